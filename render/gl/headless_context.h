#pragma once
// What make_gl_host and available_backends choose from.

#include <memory>
#include <string>

#include "render/gl/gl_host.h"
#include "render/gl/gl_lookup.h"

namespace netpocket {

struct HeadlessContext {
  std::shared_ptr<GlHost> host;
  GlLookup lookup;          // where its functions come from; null: the system's libGL
  std::string description;  // OpenGL version and renderer
};

// Each makes a context and makes it current; throws RenderError with the reason when it cannot.
HeadlessContext open_osmesa_context();
HeadlessContext open_egl_context();

}  // namespace netpocket
