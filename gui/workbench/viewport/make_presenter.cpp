#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

#include "gui/workbench/viewport/image_presenter.h"
#include "gui/workbench/viewport/opengl_presenter.h"

namespace netpocket {
namespace {

// The name of the platform's OpenGL renderer; empty when windows cannot have OpenGL 3.2.
QString opengl_renderer() {
  const QString platform = QGuiApplication::platformName();
  if (platform != "xcb" && !platform.startsWith("wayland")) return {};
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || context.isOpenGLES() || context.format().version() < qMakePair(3, 2)) return {};
  if (!context.makeCurrent(&surface)) return {};
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  context.doneCurrent();
  return QString::fromLatin1(name);
}

bool draws_in_software(const QString& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software"}) {
    if (renderer.contains(name, Qt::CaseInsensitive)) return true;
  }
  return false;
}

bool choose_opengl(PresenterKind kind) {
  if (kind == PresenterKind::image) return false;
  const QString renderer = opengl_renderer();
  return !renderer.isEmpty() && (kind == PresenterKind::opengl || !draws_in_software(renderer));
}

}  // namespace

void prepare_opengl_format() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  // A forward-compatible context would draw every line one pixel wide.
  format.setOption(QSurfaceFormat::DeprecatedFunctions);
  format.setSwapInterval(0);
  format.setSamples(0);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setAlphaBufferSize(8);
  QSurfaceFormat::setDefaultFormat(format);
}

std::unique_ptr<Presenter> make_presenter(PresenterKind kind) {
  if (choose_opengl(kind)) return std::make_unique<OpenGlPresenter>();
  return std::make_unique<ImagePresenter>();
}

}  // namespace netpocket
