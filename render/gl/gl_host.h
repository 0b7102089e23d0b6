#pragma once
// OpenGL contexts that need no display: OSMesa (in software, no driver at all) and EGL without a surface.
// Thread contract: a host and everything drawn with it belong to the thread that made it.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace netpocket {

enum class GlBackend { automatic, osmesa, egl };

// An OpenGL context that a HostedRenderWindow draws in. Other programs may bring their own, e.g. that of a Qt widget.
class GlHost {
 public:
  virtual ~GlHost() = default;
  virtual void make_current() = 0;  // throws RenderError when the context is lost
  virtual bool is_current() const = 0;
  virtual std::string_view name() const = 0;
  // Whether VTK may treat the context's state as its own.
  virtual bool exclusive() const { return true; }
};

// "auto", "osmesa" or "egl"; throws RenderError for any other name.
GlBackend gl_backend_from_name(std::string_view name);

// Makes a context of OpenGL 3.3 core or later and makes it current. `automatic` takes EGL when the machine has a
// graphics device, else OSMesa, else EGL in software. Throws RenderError with the reason when there is none; also when
// this process already draws through another library, because VTK binds its OpenGL functions once per process.
std::shared_ptr<GlHost> make_gl_host(GlBackend backend);

struct GlBackendReport {
  GlBackend backend;
  std::string name;
  bool available;
  std::string detail;  // the OpenGL version and renderer, or why there is none
};

// Tries each backend. Leaves no context current; does not decide which library the process draws through.
std::vector<GlBackendReport> available_backends();

}  // namespace netpocket
