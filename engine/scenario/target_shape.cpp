#include "engine/scenario/target_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "engine/bodies/mesh_file.h"
#include "engine/bodies/triangle_mesh.h"
#include "engine/scenario/mesh_unit.h"
#include "engine/scenario/parameter_text.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

using MeshResult = std::variant<std::shared_ptr<const TriangleMesh>, std::string>;

constexpr char kMeshKey[] = "target.mesh_file";

bool is_inside(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

// Path of a named file with links followed, or the rest of a sentence on why it may not be used.
std::variant<fs::path, std::string> allowed_path(const FileScope& scope, const std::string& name) {
  if (std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    return std::string("is not a file's name");
  const fs::path path(name);
  if (path.is_absolute()) {
    if (scope.allows_absolute) return path;
    return std::string("is an absolute path, which only the command line may give: --set target.mesh_file=...");
  }
  if (scope.folder.empty())
    return std::string("is looked for in the scenario's folder, but the scenario has no file yet");
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(scope.folder, error);
  const fs::path file = fs::weakly_canonical(folder / path, error);
  if (error) return "cannot be found: " + error.message();
  if (!is_inside(folder, file)) {
    return std::string("leads out of the scenario's folder; only an absolute path on the command line may");
  }
  return file;
}

MeshResult load_mesh(const std::string& path, double scale) {
  auto data = read_mesh_file(path, scale);
  if (auto* problem = std::get_if<std::string>(&data)) return std::move(*problem);
  return TriangleMesh::make(std::get<MeshData>(data));
}

// Properties by which a changed file is recognized.
struct FileMark {
  std::string path;
  std::uintmax_t size = 0;
  fs::file_time_type time{};
  double scale = 0;
  bool operator==(const FileMark&) const = default;
};

// Caches one mesh. A scenario is checked at each edit and then built, always with the same mesh.
class LatestMesh {
 public:
  MeshResult get(const std::string& path, double scale) {
    std::error_code error;
    const FileMark mark = {path, fs::file_size(path, error), fs::last_write_time(path, error), scale};
    if (error) return load_mesh(path, scale);
    const std::lock_guard lock(mutex_);
    if (!mesh_ || mark != mark_) {
      mesh_ = load_mesh(path, scale);
      mark_ = mark;
    }
    return *mesh_;
  }

 private:
  std::mutex mutex_;
  FileMark mark_;
  std::optional<MeshResult> mesh_;
};

std::variant<Shape, Diagnostic> mesh_shape(const Scenario& scenario) {
  static LatestMesh latest;
  const std::string& name = scenario.target.mesh_file;
  const auto fails = [&](const std::string& rest) {
    return Diagnostic{.key = kMeshKey, .message = fmt::format("{} {}", netpocket::quoted(name), rest)};
  };
  if (name.empty()) return Diagnostic{.key = kMeshKey, .message = "the shape \"mesh\" needs a file, .stl, .obj, .ply or .glb"};
  const KeptMesh& kept = scenario.files.kept_mesh;
  if (kept.mesh && kept.file == name && kept.unit == scenario.target.mesh_unit) return Shape(MeshShape{kept.mesh});
  const auto path = allowed_path(scenario.files, name);
  if (const auto* problem = std::get_if<std::string>(&path)) return fails(*problem);
  const auto mesh = latest.get(std::get<fs::path>(path).string(), metres(scenario.target.mesh_unit));
  if (const auto* problem = std::get_if<std::string>(&mesh)) return fails(*problem);
  return Shape(MeshShape{std::get<std::shared_ptr<const TriangleMesh>>(mesh)});
}

std::variant<Shape, Diagnostic> satellite_shape(const TargetParameters& target) {
  if (target.span <= target.size.x()) {
    return Diagnostic{.key = "target.span",
                      .message = fmt::format("must exceed the bus's edge along x, {} m (target.size), not be {} m",
                                             target.size.x(), target.span)};
  }
  return Shape(Satellite({target.size, target.span, target.panel_width, target.dish_diameter}));
}

}  // namespace

std::variant<Shape, Diagnostic> target_shape(const Scenario& scenario) {
  const TargetParameters& target = scenario.target;
  switch (target.shape) {
    case TargetShape::box:
      return Shape(Box{target.size});
    case TargetShape::cylinder:
      return Shape(Cylinder{target.radius, target.length});
    case TargetShape::satellite:
      return satellite_shape(target);
    case TargetShape::mesh:
      return mesh_shape(scenario);
    case TargetShape::sphere:
      break;
  }
  return Shape(Sphere{target.radius});
}

void keep_mesh(Scenario& scenario, const Shape& shape) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  if (scenario.target.shape != TargetShape::mesh || !mesh) return;
  scenario.files.kept_mesh = {scenario.target.mesh_file, scenario.target.mesh_unit, mesh->mesh};
}

Eigen::Matrix3d target_inertia(const TargetParameters& target, const Shape& shape) {
  if (target.inertia_from == InertiaSource::shape) return solid_inertia(shape, target.mass);
  return target.inertia.asDiagonal();
}

}  // namespace netpocket
