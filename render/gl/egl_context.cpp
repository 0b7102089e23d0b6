// EGL on Mesa's surfaceless platform: the system's OpenGL, by a graphics device or in software, without a display.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <fmt/format.h>

#include "render/gl/headless_context.h"
#include "render/gl/shared_library.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

struct EglLibrary {
  SharedLibrary library{"libEGL.so.1"};
  decltype(&eglGetProcAddress) get_proc_address = library.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglInitialize) initialize = library.function<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api = library.function<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglCreateContext) create_context = library.function<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy_context = library.function<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current = library.function<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  decltype(&eglGetCurrentContext) current_context =
      library.function<decltype(&eglGetCurrentContext)>("eglGetCurrentContext");
};

const EglLibrary& egl() {
  static const EglLibrary library;
  return library;
}

EGLDisplay surfaceless_display() {
  const auto get_platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl().get_proc_address("eglGetPlatformDisplayEXT"));
  if (!get_platform_display) throw RenderError("EGL does not know platforms (EGL_EXT_platform_base)");
  EGLDisplay display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !egl().initialize(display, nullptr, nullptr)) {
    throw RenderError("EGL has no surfaceless platform here (Mesa's EGL driver is missing)");
  }
  return display;
}

class EglHost final : public GlHost {
 public:
  EglHost() : display_(surfaceless_display()) {
    constexpr EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    egl().bind_api(EGL_OPENGL_API);
    context_ = egl().create_context(display_, EGLConfig{}, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) throw RenderError("EGL offers no OpenGL 3.3 core context");
  }
  ~EglHost() override {
    if (is_current()) egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl().destroy_context(display_, context_);
  }

  void make_current() override {
    if (is_current()) return;
    if (!egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      throw RenderError("EGL's OpenGL context cannot be made current");
    }
  }
  bool is_current() const override { return egl().current_context() == context_; }
  std::string_view name() const override { return "egl"; }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

}  // namespace

HeadlessContext open_egl_context() {
  auto host = std::make_shared<EglHost>();
  host->make_current();
  const auto get_string = reinterpret_cast<decltype(&glGetString)>(egl().get_proc_address("glGetString"));
  return {host, nullptr,
          fmt::format("OpenGL {}, {}", reinterpret_cast<const char*>(get_string(GL_VERSION)),
                      reinterpret_cast<const char*>(get_string(GL_RENDERER)))};
}

}  // namespace netpocket
