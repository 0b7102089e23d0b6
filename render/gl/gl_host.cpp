#include "render/gl/gl_host.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <system_error>

#include "render/gl/headless_context.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

struct HeadlessBackend {
  GlBackend backend;
  const char* name;
  HeadlessContext (*open)();
};

constexpr HeadlessBackend kOsmesa = {GlBackend::osmesa, "osmesa", open_osmesa_context};
constexpr HeadlessBackend kEgl = {GlBackend::egl, "egl", open_egl_context};

bool machine_has_graphics_device() {
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/dri", unreadable)) {
    if (entry.path().filename().string().starts_with("renderD")) return true;
  }
  return false;
}

std::shared_ptr<GlHost> open(const HeadlessBackend& backend) {
  try {
    auto context = backend.open();
    choose_gl_lookup(context.lookup);
    return context.host;
  } catch (const RenderError& error) {
    throw RenderError(fmt::format("cannot draw with {}: {}", backend.name, error.what()));
  }
}

std::shared_ptr<GlHost> open_first(const std::array<HeadlessBackend, 2>& order) {
  try {
    return open(order[0]);
  } catch (const RenderError& first) {
    try {
      return open(order[1]);
    } catch (const RenderError& second) {
      throw RenderError(fmt::format("{}; {}", first.what(), second.what()));
    }
  }
}

}  // namespace

GlBackend gl_backend_from_name(std::string_view name) {
  if (name == "auto") return GlBackend::automatic;
  for (const auto& backend : {kOsmesa, kEgl}) {
    if (name == backend.name) return backend.backend;
  }
  throw RenderError(fmt::format("unknown rendering back end '{}': use auto, osmesa or egl", name));
}

std::shared_ptr<GlHost> make_gl_host(GlBackend backend) {
  if (backend == GlBackend::osmesa) return open(kOsmesa);
  if (backend == GlBackend::egl) return open(kEgl);
  return machine_has_graphics_device() ? open_first({kEgl, kOsmesa}) : open_first({kOsmesa, kEgl});
}

std::vector<GlBackendReport> available_backends() {
  std::vector<GlBackendReport> reports;
  for (const auto& backend : {kOsmesa, kEgl}) {
    try {
      reports.push_back({backend.backend, backend.name, true, backend.open().description});
    } catch (const RenderError& error) {
      reports.push_back({backend.backend, backend.name, false, error.what()});
    }
  }
  return reports;
}

}  // namespace netpocket
