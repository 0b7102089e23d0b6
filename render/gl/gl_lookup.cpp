#include "render/gl/gl_lookup.h"

#include <dlfcn.h>

#include <atomic>

#include "render/gl/gl_functions.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

std::atomic<GlLookup> chosen_lookup = nullptr;
std::atomic<bool> system_gl_in_use = false;

void require_forwarders() {
  if (!dlsym(RTLD_DEFAULT, "netpocket_gl_forwarders")) {
    throw RenderError("this program cannot draw without a display: it was linked without netpocket_use_rendering");
  }
}

void require_functions(GlLookup lookup) {
#define NETPOCKET_GL_REQUIRE(result, name, parameters, arguments) \
  if (!lookup(#name)) throw RenderError("the OpenGL library lacks the function " #name);
  NETPOCKET_GL_FUNCTIONS(NETPOCKET_GL_REQUIRE)
#undef NETPOCKET_GL_REQUIRE
}

}  // namespace

GlLookup gl_lookup() { return chosen_lookup; }

void choose_gl_lookup(GlLookup lookup) {
  require_forwarders();
  if (lookup == nullptr) {
    if (chosen_lookup)
      throw RenderError("this process already draws with OSMesa and cannot change to the system's OpenGL");
    system_gl_in_use = true;
    return;
  }
  if (system_gl_in_use)
    throw RenderError("this process already draws with the system's OpenGL and cannot change to OSMesa");
  require_functions(lookup);
  chosen_lookup = lookup;
}

void note_system_gl_in_use() { system_gl_in_use = true; }

}  // namespace netpocket
