#include "gui/workbench/viewport/opengl_presenter.h"

#include <vtkOpenGLState.h>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <utility>

#include "render/gl/gl_lookup.h"

namespace netpocket {
namespace {

// The context of a QOpenGLWidget, for as long as the widget has it.
class WidgetHost final : public GlHost {
 public:
  explicit WidgetHost(QOpenGLWidget& widget) : widget_(widget) {}

  // Only when another context is current: otherwise Qt would bind its own framebuffer in the middle of a drawing.
  void make_current() override {
    if (!is_current()) widget_.makeCurrent();
  }
  bool is_current() const override {
    return widget_.context() != nullptr && QOpenGLContext::currentContext() == widget_.context();
  }
  std::string_view name() const override { return "qt"; }
  bool exclusive() const override { return false; }

 private:
  QOpenGLWidget& widget_;
};

}  // namespace

OpenGlPresenter::OpenGlPresenter() { setUpdateBehavior(NoPartialUpdate); }

OpenGlPresenter::~OpenGlPresenter() { release(); }

void OpenGlPresenter::release() {
  if (!drawing_) return;
  makeCurrent();
  drawing_.reset();
  doneCurrent();
}

void OpenGlPresenter::show(const ViewState& state) {
  state_ = state;
  stale_ = true;
  update();
}

void OpenGlPresenter::initializeGL() {
  // Moving the window to another screen may bring a new context.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &OpenGlPresenter::release);
  try {
    stale_ = true;
    choose_gl_lookup(nullptr);
    drawing_ = std::make_unique<SceneDrawing>(std::make_shared<WidgetHost>(*this));
    drawing_->window().OpenGLInitContext();
  } catch (const std::exception& error) {
    drawing_.reset();
    if (failed) failed(QString::fromUtf8(error.what()));
    return;
  }
  const auto text = [this](GLenum name) {
    return QString::fromLatin1(reinterpret_cast<const char*>(context()->functions()->glGetString(name)));
  };
  description_ = QString("OpenGL %1, %2").arg(text(GL_VERSION), text(GL_RENDERER));
}

void OpenGlPresenter::paintGL() {
  if (!drawing_ || !state_.options) return;
  QElapsedTimer timer;
  timer.start();
  auto* state = drawing_->window().GetState();
  state->Reset();
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);  // what VTK expects; Qt leaves GL_LESS
  // A window that is repainted or grabbed for another reason gets the same picture again.
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  const bool draws = std::exchange(stale_, false) || pixels != std::exchange(drawn_size_, pixels);
  if (draws) drawing_->draw(state_, pixels.width(), pixels.height());
  copy_to_widget();
  state->Pop();
  if (draws && shown) shown(state_, 1e-9 * static_cast<double>(timer.nsecsElapsed()));
}

void OpenGlPresenter::copy_to_widget() {
  auto& window = drawing_->window();
  auto* state = window.GetState();
  if (QOpenGLContext::currentContext() != context()) makeCurrent();
  auto* gl = context()->extraFunctions();
  const int* size = window.GetSize();
  constexpr GLenum kAttachment = GL_COLOR_ATTACHMENT0;
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDrawBuffers(1, &kAttachment);
  state->vtkglDisable(GL_SCISSOR_TEST);
  gl->glDisable(GL_SCISSOR_TEST);
  window.BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  // Otherwise the window behind shines through where VTK has left the alpha below one.
  gl->glColorMask(0, 0, 0, 1);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(1, 1, 1, 1);
  state->ResetGLColorMaskState();
  state->ResetGLClearColorState();
}

}  // namespace netpocket
