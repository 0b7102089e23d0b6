#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "engine/bodies/mesh_file.h"
#include "engine/bodies/mesh_mend.h"
#include "engine/bodies/mesh_output.h"
#include "engine/bodies/mesh_weld.h"
#include "engine/scenario/mesh_unit.h"
#include "gui/commands/command.h"
#include "gui/commands/mesh_report.h"
#include "gui/commands/options.h"
#include "gui/commands/standard_streams.h"
#include "render/output/mesh_picture.h"
#include "render/output/png_file.h"

namespace netpocket {
namespace {

constexpr const char* kMeshFooter =
    R"(Tells whether an STL, OBJ, PLY or binary glTF file can be a target (shape = "mesh"), and what hinders it: open edges, triangles that
face the wrong way or are there twice, parts that enclose no volume, go through each other or lie in each other, each with
places. The picture shows them in red, and the back of triangles in orange.

--mend writes a copy in the file's unit in which all that is unambiguous is mended: corners that are nearly one are
joined, triangles turned, edges divided where another triangle's corner lies on them, doubles left out. --thickness
makes plates of open surfaces and of panels that have none.

Examples:
  netpocket mesh scenarios/meshes/upper_stage.obj --picture stage.png
  netpocket mesh antenna.stl --unit mm --mend antenna_mended.stl --thickness 0.01

)";

struct MeshChoice {
  std::string file, unit, picture, mended, backend = "auto";
  double thickness = 0;  // m; 0: not given
  double weld = 0;       // m; 0: not given
};

std::string extension(const std::string& path) { return std::filesystem::path(path).extension().string(); }

FileKind mended_kind(const MeshChoice& choice) {
  return extension(choice.mended) == ".stl" ? FileKind::stl : FileKind::obj;
}

// Coordinates as in the file.
MeshData load(const std::string& path) {
  require_readable(path);
  auto data = read_mesh_file(path, 1);
  if (const auto* problem = std::get_if<std::string>(&data)) {
    throw CommandError(ExitCode::bad_input, fmt::format("\"{}\" {}", path, *problem));
  }
  MeshData mesh = std::get<MeshData>(std::move(data));
  std::string problem = number_fault(mesh);
  if (problem.empty() && mesh.triangles.empty()) problem = "has no triangles";
  if (!problem.empty()) throw CommandError(ExitCode::bad_input, fmt::format("\"{}\" {}", path, problem));
  return mesh;
}

MeshData scaled(MeshData mesh, double factor) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

MeshUnit chosen_unit(const MeshChoice& choice, double extent) {
  const std::vector<std::string> names = unit_names();
  const auto found = std::find(names.begin(), names.end(), choice.unit);
  return found == names.end() ? likely_unit(extent) : static_cast<MeshUnit>(found - names.begin());
}

void draw(const MeshChoice& choice, const std::string& name, const MeshReview& review) {
  MeshPicture picture{review.mesh};
  for (const TriangleSide& side : review.edges.open) {
    const Triangle& t = review.mesh.triangles[side.triangle];
    picture.open_edges.emplace_back(review.mesh.vertices[t[side.edge]], review.mesh.vertices[t[(side.edge + 1) % 3]]);
  }
  for (const MeshFault& fault : review.faults) {
    if (fault.kind == MeshFaultKind::open && review.edges.forked.empty()) continue;  // drawn as lines
    picture.faults.insert(picture.faults.end(), fault.places.begin(), fault.places.end());
  }
  Eigen::AlignedBox3d box;
  for (const MeshPart& part : review.parts) box.extend(part.bounds);
  const Eigen::Vector3d size = box.sizes();
  picture.lines = {name, fmt::format("{} triangles, {} {}, {:.4g} x {:.4g} x {:.4g} m", review.mesh.triangles.size(),
                                     review.parts.size(), review.parts.size() == 1 ? "part" : "parts", size.x(),
                                     size.y(), size.z())};
  for (std::size_t i = 0; i < std::min<std::size_t>(review.faults.size(), 3); ++i) {
    picture.lines.push_back(review.faults[i].text);
  }
  const auto host = make_gl_host(gl_backend_from_name(choice.backend));
  write_png(draw_mesh(host, picture), choice.picture);
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

// The mended copy, as reviewed in metres.
MeshReview mend(const MeshChoice& choice, const MeshData& data, double unit) {
  const MendedMesh mended = mend_mesh(data, {choice.weld / unit, choice.thickness / unit, unit});
  for (const std::string& change : mended.changes) print(report_line("mended", change));
  if (mended.changes.empty()) print(report_line("mended", "nothing"));
  const FileKind kind = mended_kind(choice);
  write_whole_file(choice.mended, kind, kind == FileKind::stl ? binary_stl(mended.mesh) : obj_text(mended.mesh));
  print(report_line("written", fmt::format("\"{}\", in the file's unit", choice.mended)));
  return review_mesh(scaled(std::get<MeshData>(read_mesh_file(choice.mended, 1)), unit));
}

void check_usage(const MeshChoice& choice) {
  if (choice.mended.empty() && (choice.thickness > 0 || choice.weld > 0)) {
    throw CommandError(ExitCode::usage, fmt::format("--{} needs --mend, the file to write",
                                                    choice.thickness > 0 ? "thickness" : "weld"));
  }
  if (!choice.mended.empty() && extension(choice.mended) != ".stl" && extension(choice.mended) != ".obj") {
    throw CommandError(ExitCode::usage, fmt::format("--mend: \"{}\" must end in .stl or .obj", choice.mended));
  }
  OutputList outputs;
  outputs.add_input(choice.file);
  if (!choice.mended.empty()) outputs.add("--mend", choice.mended, mended_kind(choice));
  if (!choice.picture.empty()) outputs.add("--picture", choice.picture, FileKind::png);
}

ExitCode run(const MeshChoice& choice) {
  check_usage(choice);
  const MeshData data = load(choice.file);
  const double extent = mesh_extent(data);
  const MeshUnit unit = chosen_unit(choice, extent);
  MeshReview review = review_mesh(scaled(data, metres(unit)));
  print(report_line("file", choice.file) + unit_line(unit, !choice.unit.empty(), extent) + mesh_report(review) +
        fault_lines(review));
  std::string name = choice.file;
  if (!choice.mended.empty()) {
    review = mend(choice, data, metres(unit));
    print(mesh_report(review) + fault_lines(review));
    name = choice.mended;
  }
  if (!choice.picture.empty()) draw(choice, file_name(name), review);
  if (review.faults.empty()) return ExitCode::ok;
  const std::string help = choice.mended.empty() ? "; --mend writes a copy with what is unambiguous mended" : "";
  throw CommandError(ExitCode::bad_input, fmt::format("\"{}\" {}{}", name, review.faults.front().text, help));
}

}  // namespace

Action declare_mesh(CLI::App& app) {
  const auto choice = std::make_shared<MeshChoice>();
  app.add_option("MESH", choice->file, "mesh file, .stl, .obj, .ply or .glb")->required()->type_name("FILE");
  app.add_option("--unit", choice->unit,
                 fmt::format("unit of its coordinates: {} (default: the likely one)", fmt::join(unit_names(), ", ")))
      ->type_name("NAME")
      ->check(one_of(unit_names()));
  app.add_option("--picture", choice->picture, "draw it, with its faults")->type_name("FILE.png");
  app.add_option("--mend", choice->mended, "write a mended copy, .stl or .obj")->type_name("FILE");
  app.add_option("--thickness", choice->thickness, "with --mend: thickness that open surfaces get, m")
      ->type_name("T")
      ->check(positive_number());
  app.add_option(
         "--weld", choice->weld,
         fmt::format("with --mend: corners this near are joined, m (default: {:g} of the extent)", kWeldTolerance))
      ->type_name("T")
      ->check(positive_number());
  add_choice(app, "--backend", choice->backend, "how to draw", {"auto", "osmesa", "egl"});
  app.footer(kMeshFooter + exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering}));
  return [choice](const std::string&) { return run(*choice); };
}

}  // namespace netpocket
