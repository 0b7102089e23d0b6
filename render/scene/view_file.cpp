#include "render/scene/view_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <sstream>

#include "render/render_error.h"

namespace netpocket {
namespace {

constexpr double kFarthest = 1e6;  // m
constexpr const char* kKeys = "position, focal_point, view_up, view_angle or half_height";

class ViewReader {
 public:
  ViewReader(const toml::table& table, std::string name) : table_(table), name_(std::move(name)) {
    for (const auto& [key, node] : table) {
      const std::string_view text = key.str();
      const bool known = text == "position" || text == "focal_point" || text == "view_up" || text == "view_angle" ||
                         text == "half_height";
      if (!known) fail(node, fmt::format("unknown key '{}': use {}", text, kKeys));
    }
  }

  bool has(std::string_view key) const { return table_.get(key) != nullptr; }

  Eigen::Vector3d vector(std::string_view key) const {
    const auto* node = table_.get(key);
    if (!node) throw RenderError(fmt::format("{}: '{}' is missing", name_, key));
    const auto* array = node->as_array();
    Eigen::Vector3d vector;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = array && array->size() == 3 ? array->get(i)->value<double>() : std::nullopt;
      if (!value || !(std::abs(*value) <= kFarthest)) {
        fail(*node, fmt::format("'{}' must be three numbers from {:g} to {:g}", key, -kFarthest, kFarthest));
      }
      vector[static_cast<Eigen::Index>(i)] = *value;
    }
    return vector;
  }

  // Between the limits, both excluded.
  double number(std::string_view key, double low, double high) const {
    const auto& node = *table_.get(key);
    const auto value = node.value<double>();
    if (!value || !(*value > low && *value < high)) {
      fail(node, fmt::format("'{}' must be a number between {:g} and {:g}", key, low, high));
    }
    return *value;
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& message) const {
    throw RenderError(fmt::format("{}, line {}: {}", name_, node.source().begin.line, message));
  }

  [[noreturn]] void fail(const std::string& message) const { throw RenderError(fmt::format("{}: {}", name_, message)); }

 private:
  const toml::table& table_;
  std::string name_;
};

bool are_parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.cross(b).norm() < 1e-6 * a.norm() * b.norm();
}

}  // namespace

CameraView read_view_text(std::string_view text, const std::string& name) try {
  const toml::table table = toml::parse(text, name);
  const ViewReader reader(table, name);
  CameraView view;
  view.position = reader.vector("position");
  view.focal_point = reader.vector("focal_point");
  if (reader.has("view_angle") && reader.has("half_height")) {
    reader.fail("view_angle (perspective) and half_height (parallel projection) contradict each other: give one");
  }
  if (reader.has("view_angle")) view.view_angle = reader.number("view_angle", 0, 170);
  if (reader.has("half_height")) view.half_height = reader.number("half_height", 0, 1e6);
  const Eigen::Vector3d forward = view.focal_point - view.position;
  if (forward.norm() < 1e-6) reader.fail("position and focal_point must differ");
  if (reader.has("view_up")) {
    view.view_up = reader.vector("view_up");
    if (view.view_up.isZero()) reader.fail("view_up must not be zero");
    if (are_parallel(forward, view.view_up)) reader.fail("view_up must not point along the line of sight");
  } else if (are_parallel(forward, view.view_up)) {
    // Straight from above or below there is no telling what is up: X runs to the right, as in the preset "front".
    view.view_up = Eigen::Vector3d::UnitX().cross(forward).normalized();
  }
  return view;
} catch (const toml::parse_error& error) {
  throw RenderError(fmt::format("{}, line {}: {}", name, error.source().begin.line, error.description()));
}

CameraView read_view_file(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) throw RenderError(fmt::format("cannot read the view \"{}\"", path));
  return read_view_text(text.str(), path);
}

std::string view_text(const CameraView& view) {
  const auto vector = [](const Eigen::Vector3d& v) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x(), v.y(), v.z());
  };
  std::string text = fmt::format("position = {}  # m, world\nfocal_point = {}  # m, world\nview_up = {}\n",
                                 vector(view.position), vector(view.focal_point), vector(view.view_up));
  if (view.half_height > 0)
    return text + fmt::format("half_height = {:.6g}  # m, parallel projection\n", view.half_height);
  return text + fmt::format("view_angle = {:.6g}  # degrees, vertical\n", view.view_angle);
}

}  // namespace netpocket
