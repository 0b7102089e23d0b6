#include "gui/commands/model_report.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "engine/bodies/shape.h"
#include "engine/bodies/triangle_mesh.h"
#include "engine/capture/simulation.h"
#include "engine/control/closing_law.h"
#include "engine/scenario/fidelity.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/pocket_outline.h"
#include "engine/systems/capture_system.h"

namespace netpocket {
namespace {

// Elements of a group.
struct Cables {
  std::string name;
  int count = 0;
  double mass = 0;  // kg
};

std::vector<Cables> cables_of(const Model& model) {
  std::vector<Cables> groups;
  for (const ElementGroup& group : model.element_groups) groups.push_back({group.name});
  for (const ModelElement& element : model.elements) {
    Cables& cables = groups[static_cast<std::size_t>(element.group)];
    ++cables.count;
    cables.mass += element.length * model.materials[element.material].section.mass_per_length;
  }
  return groups;
}

std::string counts(const std::vector<Cables>& groups) {
  std::vector<std::string> parts;
  for (const Cables& group : groups) parts.push_back(fmt::format("{} {}", group.name, group.count));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string line(const char* label, const std::string& value) { return fmt::format("{:<15}{}\n", label, value); }

bool has_table(const Scenario& scenario, std::string_view name) {
  return find_parameter_group(name, scenario.system) != nullptr;
}

std::string choice_text(const Scenario& scenario, std::string_view key) {
  const Parameter& parameter = *find_parameter(key);
  return std::string(parameter.choices[std::get<Choice>(parameter.get(scenario)).index]);
}

std::string masses(const Model& model, const std::vector<Cables>& groups) {
  std::vector<std::string> parts;
  for (const Cables& group : groups) parts.push_back(fmt::format("{} {:.3g}", group.name, group.mass));
  for (const ModelBody& body : model.bodies) parts.push_back(fmt::format("{} {:g}", body.name, body.mass));
  return fmt::format("{} kg", fmt::join(parts, ", "));
}

std::string closing(const Scenario& scenario) {
  const ClosingSchedule schedule(scenario.closing, open_tip_distance(scenario));
  if (scenario.closing.starts_at != ClosingStart::time) {
    return fmt::format("{:.4g} m to {:.4g} m between rod tips within {:g} s from the event {} ({})",
                       schedule.open_length(), schedule.closed_length(), schedule.end() - schedule.start(),
                       choice_text(scenario, "closing.starts_at"), choice_text(scenario, "closing.law"));
  }
  return fmt::format("{:.4g} m to {:.4g} m between rod tips, from t = {:g} s to {:g} s ({})", schedule.open_length(),
                     schedule.closed_length(), schedule.start(), schedule.end(), choice_text(scenario, "closing.law"));
}

std::string towing(const Scenario& scenario) {
  const std::string mode = choice_text(scenario, "towing.mode");
  if (scenario.towing.mode == TowingMode::none) return mode;
  if (scenario.towing.starts_at == TowingStart::closed) return fmt::format("when closed ({})", mode);
  return fmt::format("from t = {:g} s ({})", scenario.towing.start, mode);
}

// "mesh, 1280 triangles, ...".
std::string target_line(const Scenario& scenario, const Shape& shape) {
  std::string text = choice_text(scenario, "target.shape");
  if (const auto* solid = std::get_if<MeshShape>(&shape)) {
    const TriangleMesh& mesh = *solid->mesh;
    const Eigen::Vector3d& centre = mesh.centre_in_file();
    text += fmt::format(" {}, {} triangles, {} vertices, centre of mass at ({:.4g}, {:.4g}, {:.4g}) m of the file",
                        netpocket::quoted(scenario.target.mesh_file), mesh.triangles().size(), mesh.vertices().size(),
                        centre.x(), centre.y(), centre.z());
    if (mesh.joined_corners() > 0) {
      text += fmt::format(", {} corners joined that differed by at most {:.3g} m", mesh.joined_corners(),
                          mesh.weld_tolerance());
    }
  }
  const Eigen::Vector3d size = extents(shape).sizes();
  return text +
         fmt::format(", {:.4g} x {:.4g} x {:.4g} m, volume {:.4g} m^3", size.x(), size.y(), size.z(), volume(shape));
}

std::string inertia_line(const Scenario& scenario, const Eigen::Matrix3d& inertia) {
  const std::string diagonal = fmt::format("{:.5g}, {:.5g}, {:.5g}", inertia(0, 0), inertia(1, 1), inertia(2, 2));
  const std::string products = inertia.isDiagonal() ? ""
                                                    : fmt::format(", I_xy {:.4g}, I_yz {:.4g}, I_zx {:.4g}",
                                                                  inertia(0, 1), inertia(1, 2), inertia(2, 0));
  return fmt::format("{}{} kg m^2 ({})", diagonal, products, choice_text(scenario, "target.inertia_from"));
}

std::string symmetry(const Simulation& simulation) {
  const SymmetryStatus status = simulation.symmetry();
  if (status.is_symmetric) return "one sector is computed for all until something breaks the symmetry";
  return "all sectors are computed: " + (status.reason.empty() ? "the system has no sectors" : status.reason);
}

}  // namespace

std::string model_report(const Scenario& scenario) {
  const Simulation simulation(scenario);
  const RunStatistics statistics = simulation.statistics();
  const CaptureSystem system = build_capture_system(scenario);
  const std::vector<Cables> cables = cables_of(system.model);
  const double frames = std::ceil(scenario.output.end_time * scenario.output.frame_rate);
  const double steps = frames * std::ceil(1 / (scenario.output.frame_rate * statistics.time_step));

  std::string text = line("scenario", scenario.name);
  text += line("nodes", fmt::format("{}", simulation.structure().node_count));
  text += line("elements", fmt::format("{}: {}", statistics.elements, counts(cables)));
  text += line("coordinates", fmt::format("{}", statistics.coordinates));
  text += line("evaluation", statistics.evaluation);
  if (const std::string draft = draft_notice(scenario.solver.fidelity); !draft.empty()) text += line("draft", draft);
  text += line("masses", masses(system.model, cables));
  if (const auto* target = system.target >= 0 ? &system.model.bodies[static_cast<std::size_t>(system.target)] : nullptr;
      target != nullptr && has_table(scenario, "target")) {
    text += line("target", target_line(scenario, target->shape));
    text += line("target inertia", inertia_line(scenario, target->inertia));
  }
  if (scenario.system == kPocketSystem) text += line("closing", closing(scenario));
  if (has_table(scenario, "towing")) text += line("towing", towing(scenario));
  if (scenario.solver.symmetry == Symmetry::automatic) text += line("symmetry", symmetry(simulation));
  text +=
      line("step", fmt::format("{:.4g} s at the start, limited by {}", statistics.time_step, statistics.step_limit));
  text +=
      line("steps", fmt::format("about {:.0f} for {:g} s, {:.0f} frames", steps, scenario.output.end_time, frames + 1));
  return text;
}

}  // namespace netpocket
