// OSMesa: Mesa's software rasteriser as a plain library. Loaded on its own, apart from the system's libGL.

#include <GL/osmesa.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "render/gl/headless_context.h"
#include "render/gl/shared_library.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

// NETPOCKET_OSMESA names another libOSMesa than the installed one.
std::string library_file() {
  const char* file = std::getenv("NETPOCKET_OSMESA");
  return file && *file ? file : "libOSMesa.so.8";
}

struct OsmesaLibrary {
  SharedLibrary library{library_file()};
  decltype(&OSMesaGetProcAddress) get_proc_address =
      library.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
  decltype(&OSMesaCreateContextAttribs) create_context =
      library.function<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(&OSMesaMakeCurrent) make_current = library.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(&OSMesaGetCurrentContext) current_context =
      library.function<decltype(&OSMesaGetCurrentContext)>("OSMesaGetCurrentContext");
  decltype(&OSMesaDestroyContext) destroy_context =
      library.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
};

const OsmesaLibrary& osmesa() {
  static const OsmesaLibrary library;  // tried again when loading throws
  return library;
}

void* osmesa_lookup(const char* name) { return reinterpret_cast<void*>(osmesa().get_proc_address(name)); }

class OsmesaHost final : public GlHost {
 public:
  OsmesaHost() {
    constexpr int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
    context_ = osmesa().create_context(attributes, nullptr);
    if (!context_) throw RenderError("OSMesa offers no OpenGL 3.3 core context");
  }
  ~OsmesaHost() override { osmesa().destroy_context(context_); }

  void make_current() override {
    if (is_current()) return;
    if (!osmesa().make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kBufferEdge, kBufferEdge)) {
      throw RenderError("OSMesa's OpenGL context cannot be made current");
    }
  }
  bool is_current() const override { return osmesa().current_context() == context_; }
  std::string_view name() const override { return "osmesa"; }

 private:
  // The window draws in framebuffer objects of its own; OSMesa only insists on having some memory.
  static constexpr int kBufferEdge = 4;
  std::array<unsigned char, 4 * kBufferEdge * kBufferEdge> buffer_{};
  OSMesaContext context_;
};

}  // namespace

HeadlessContext open_osmesa_context() {
  auto host = std::make_shared<OsmesaHost>();
  host->make_current();
  const auto get_string = reinterpret_cast<decltype(&glGetString)>(osmesa_lookup("glGetString"));
  return {host, osmesa_lookup,
          fmt::format("OpenGL {}, {}", reinterpret_cast<const char*>(get_string(GL_VERSION)),
                      reinterpret_cast<const char*>(get_string(GL_RENDERER)))};
}

}  // namespace netpocket
