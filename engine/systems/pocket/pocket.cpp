#include "engine/systems/pocket/pocket.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <variant>

#include "engine/math/rotation.h"
#include "engine/scenario/fidelity.h"
#include "engine/scenario/pocket_tether.h"
#include "engine/scenario/target_shape.h"
#include "engine/state/pocket_groups.h"
#include "engine/systems/pocket/materials.h"
#include "engine/systems/pocket/sector_builder.h"
#include "engine/systems/pocket/sector_variation.h"
#include "engine/systems/tether_winch.h"

namespace netpocket {
namespace {

// Rows of the triangular grid closer to the axis than this many root radii are omitted: the rods are clamped there.
constexpr double kRootClearance = 1.05;

// Nodes of a panel's grid by row (counted from the kink row, downwards in the lower grid, upwards in the upper one) and
// place in the row.
using Grid = std::map<std::pair<int, int>, SectorIndex>;

class PocketBuilder {
 public:
  explicit PocketBuilder(const Scenario& scenario)
      : scenario_(scenario),
        mesh_(mesh_division(scenario)),
        columns_(mesh_.columns),
        rows_(mesh_.rows),
        tether_(pocket_tether(scenario)),
        sectors_(pocket_.model, scenario.pocket.rod_count, scenario.solver.pair_strains) {}

  Pocket build() {
    Model& model = pocket_.model;
    net_ = add_softened(cord_material(scenario_.net));
    rope_ = add_softened(cord_material(scenario_.rope));
    for (const double wall : {scenario_.rods.wall_lower, scenario_.rods.wall_upper}) {
      pocket_.rod_materials.push_back({add_softened(rod_material(scenario_.rods, wall)), wall});
    }
    model.contact = {.restitution = scenario_.contact.restitution,
                     .friction = scenario_.contact.friction,
                     .friction_velocity = scenario_.contact.friction_velocity,
                     .edge_radius = scenario_.contact.edge_radius,
                     .cords = scenario_.contact.cords,
                     .bodies = scenario_.contact.bodies};
    model.gravity = scenario_.solver.gravity;
    add_bodies();
    add_rods();
    add_lower_net();
    add_upper_net();
    add_closing_ropes();
    vary_sectors(scenario_, pocket_);
    if (pocket_.hub >= 0) add_tether();
    finish_structure();
    return std::move(pocket_);
  }

 private:
  const Eigen::Vector2d& profile(int i) const { return scenario_.rods.profile[i]; }
  Eigen::Vector3d on_rod(int rod, double r, double y) const {
    const Eigen::Vector3d out = sectors_.radial(rod % sectors_.sectors());
    return {r * out.x(), y, r * out.z()};
  }

  std::int32_t add_softened(CableMaterial material) {
    material.section.EA /= axial_softening(scenario_);
    return pocket_.model.add_material(material);
  }

  void add_bodies();
  void add_hub();
  void add_tether();
  std::int32_t add_held_node(const Eigen::Vector3d& place, std::int32_t body);
  void add_rods();
  void add_lower_net();
  void add_upper_net();
  void add_closing_ropes();
  void finish_structure();
  SectorIndex panel_node(const SectorIndex& rod_node, double across);
  void add_net_thread(const std::vector<SectorIndex>& knots, const std::string& what);

  const Scenario& scenario_;
  MeshDivision mesh_;
  int columns_, rows_;
  PocketTether tether_;
  Pocket pocket_;
  SectorBuilder sectors_;
  std::int32_t net_ = 0, rope_ = 0;
  std::vector<SectorIndex> lower_rows_;  // rod nodes from the kink row (0) downwards
  std::vector<SectorIndex> upper_rows_;  // rod nodes from the kink row (0) up to the tip
  SectorIndex root_;
  SectorThread lower_, upper_;
  Grid lower_grid_;
  std::vector<SectorThread> ropes_;
};

Shape shape_of_target(const Scenario& scenario) {
  auto shape = target_shape(scenario);
  if (const auto* problem = std::get_if<Diagnostic>(&shape)) throw std::runtime_error(problem->text());
  return std::get<Shape>(std::move(shape));
}

void PocketBuilder::add_bodies() {
  const SpacecraftParameters& craft = scenario_.spacecraft;
  const TargetParameters& target = scenario_.target;
  const Shape shape = shape_of_target(scenario_);
  pocket_.spacecraft = pocket_.model.add_body({.name = "spacecraft",
                                               .role = BodyRole::spacecraft,
                                               .shape = Box{craft.size},
                                               .mass = craft.mass,
                                               .inertia = craft.inertia.asDiagonal(),
                                               .state = {.position = craft.position},
                                               .touches_cables = scenario_.contact.spacecraft});
  pocket_.target = pocket_.model.add_body({.name = "target",
                                           .role = BodyRole::target,
                                           .shape = shape,
                                           .mass = target.mass,
                                           .inertia = target_inertia(target, shape),
                                           .state = {.position = target.position,
                                                     .attitude = rotation_by(target.attitude),
                                                     .velocity = target.velocity,
                                                     .angular_velocity = target.spin},
                                           .youngs_modulus = target.youngs_modulus,
                                           .poisson_ratio = target.poisson_ratio});
  if (tether_.attached) add_hub();
}

// A square plate on the rods' roots, towards the pocket.
void PocketBuilder::add_hub() {
  const Eigen::Vector2d root = profile(0);
  const double width = 2 * root.x(), thickness = tether_.hub_thickness;
  const auto moment = [&](double a, double b) { return tether_.hub_mass / 12 * (a * a + b * b); };
  pocket_.hub = pocket_.model.add_body(
      {.name = "hub",
       .role = BodyRole::other,
       .shape = Box{{width, thickness, width}},
       .mass = tether_.hub_mass,
       .inertia =
           Eigen::Vector3d(moment(width, thickness), moment(width, width), moment(width, thickness)).asDiagonal(),
       .state = {.position = {0, root.y() + 0.5 * thickness, 0}},
       .touches_cables = false});
  pocket_.model.locks = {{pocket_.spacecraft, pocket_.hub}};
}

// A node at `place` that moves with a body.
std::int32_t PocketBuilder::add_held_node(const Eigen::Vector3d& place, std::int32_t body) {
  const std::int32_t node = pocket_.model.add_node(place);
  pocket_.model.nodes.back().support = Support::body;
  pocket_.model.nodes.back().body = body;
  return node;
}

// Folded free of stress between the spacecraft's face and the hub (thrown_net.h).
void PocketBuilder::add_tether() {
  Model& model = pocket_.model;
  const SpacecraftParameters& craft = scenario_.spacecraft;
  const Eigen::Vector3d face = craft.position + Eigen::Vector3d(0, 0.5 * craft.size.y(), 0);
  const Eigen::Vector3d far_side(0, profile(0).y() + tether_.hub_thickness, 0);
  const Eigen::Vector3d eye = face + 0.1 * (far_side - face);
  const Eigen::Vector3d slope = (far_side - eye) / tether_.length;
  CableMaterial without_contact = cord_material(tether_.cord);
  if (tether_.drum.attached) {
    return add_wound_tether(model, tether_.drum, without_contact.section, add_held_node(eye, pocket_.spacecraft),
                            add_held_node(far_side, pocket_.hub));
  }
  without_contact.radius = 0;  // folded, it would touch itself all over
  const std::int32_t material = model.add_material(without_contact), thread = model.add_thread("tether");
  const auto add_point = [&](int i) {
    const double part = static_cast<double>(i) / tether_.elements;
    const std::int32_t node = model.add_node((1 - part) * eye + part * far_side);
    return std::pair(node, model.add_gradient(node, slope));
  };
  auto [node, gradient] = add_point(0);
  const std::int32_t first = node;
  for (int i = 1; i <= tether_.elements; ++i) {
    const auto [next, next_gradient] = add_point(i);
    pocket_.tether.push_back(model.add_element({.node1 = node,
                                                .gradient1 = gradient,
                                                .node2 = next,
                                                .gradient2 = next_gradient,
                                                .length = tether_.length / tether_.elements,
                                                .material = material,
                                                .group = static_cast<std::int32_t>(pocket_groups().size()),
                                                .thread = thread}));
    node = next;
    gradient = next_gradient;
  }
  for (const auto& [end, body] : {std::pair(first, pocket_.spacecraft), {node, pocket_.hub}}) {
    model.nodes[static_cast<std::size_t>(end)].support = Support::body;
    model.nodes[static_cast<std::size_t>(end)].body = body;
  }
}

void PocketBuilder::add_rods() {
  const Eigen::Vector2d root = profile(0), kink = profile(1), tip = profile(2);
  const auto rod_node = [&](double r, double y) {
    return sectors_.add_node([this, r, y](int sector) { return on_rod(sector, r, y); });
  };
  root_ = rod_node(root.x(), root.y());
  // The apex is the virtual point on the axis where the lower parts of the rods would meet.
  const double apex_y = root.y() - root.x() * (kink.y() - root.y()) / (kink.x() - root.x());
  lower_rows_.push_back(rod_node(kink.x(), kink.y()));
  for (int row = 1; row < columns_; ++row) {
    const double part = static_cast<double>(columns_ - row) / columns_;
    if (part * kink.x() < kRootClearance * root.x()) break;
    lower_rows_.push_back(rod_node(part * kink.x(), apex_y + part * (kink.y() - apex_y)));
  }
  upper_rows_.push_back(lower_rows_.front());
  for (int row = 1; row <= rows_; ++row) {
    const double part = static_cast<double>(row) / rows_;
    upper_rows_.push_back(rod_node((1 - part) * kink.x() + part * tip.x(), (1 - part) * kink.y() + part * tip.y()));
  }

  const int per_side = mesh_.per_side_of_a_rod;
  std::vector<SectorIndex> knots = {root_};
  knots.insert(knots.end(), lower_rows_.rbegin(), lower_rows_.rend());
  std::vector<int> divisions(knots.size() - 1, per_side);
  // The stub between the clamp and the first row is shorter than the other sides.
  const double row_height = (kink.y() - apex_y) / columns_;
  const double stub = sectors_.position(lower_rows_.back(), 0).y() - root.y();
  divisions.front() = std::max(1, static_cast<int>(std::lround(per_side * stub / row_height)));
  const auto name = [](int sector) { return fmt::format("rod {}", sector + 1); };
  lower_ = sectors_.add_thread(knots, divisions, pocket_.rod_materials[0].material, PocketGroup::rods, name);
  upper_ = sectors_.add_thread(upper_rows_, std::vector<int>(rows_, per_side), pocket_.rod_materials[1].material,
                               PocketGroup::rods, name);

  Model& model = pocket_.model;
  for (int sector = 0; sector < sectors_.sectors(); ++sector) {
    model.clamp_to_body(sectors_.node(root_, sector), sectors_.gradient(lower_.gradients.front(), sector),
                        pocket_.base());
    const std::int32_t below = sectors_.gradient(lower_.gradients.back(), sector);
    const std::int32_t above = sectors_.gradient(upper_.gradients.front(), sector);
    const Eigen::Vector3d t1 = model.gradients[below].value, t2 = model.gradients[above].value;
    // Rotation about the circumferential direction n that takes t1 to t2.
    const Eigen::Vector3d out = sectors_.radial(sector);
    const Eigen::Vector3d n(-out.z(), 0, out.x());
    const double sine = n.dot(t1.cross(t2)), cosine = t1.dot(t2);
    Eigen::Matrix3d cross;
    cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
    const Eigen::Matrix3d along = n * n.transpose();
    model.hinges.push_back({below, above, cosine * (Eigen::Matrix3d::Identity() - along) + sine * cross + along,
                            pocket_.base(), scenario_.rods.hinge_stiffness, scenario_.rods.hinge_damping});
    model.nodes[sectors_.node(upper_rows_.back(), sector)].point_mass = scenario_.rods.tip_mass;
  }
}

// Node between a rod's node and that of the next rod, at the fraction `across` of the distance.
SectorIndex PocketBuilder::panel_node(const SectorIndex& rod_node, double across) {
  return sectors_.add_node([this, rod_node, across](int sector) -> Eigen::Vector3d {
    return (1 - across) * sectors_.position(rod_node, sector) + across * sectors_.position(rod_node.of_next(), sector);
  });
}

void PocketBuilder::add_net_thread(const std::vector<SectorIndex>& knots, const std::string& what) {
  if (knots.size() < 2) return;
  const std::vector<int> divisions(knots.size() - 1, mesh_.per_side);
  // Straight cords would buckle in a direction that rounding errors decide. The bow determines it.
  const Bow bow{scenario_.pocket.bow, {0, profile(1).y(), 0}};
  sectors_.add_thread(
      knots, divisions, net_, PocketGroup::net,
      [&](int sector) { return fmt::format("panel {} {}", sector + 1, what); }, bow);
}

void PocketBuilder::add_lower_net() {
  const int row_count = static_cast<int>(lower_rows_.size());
  for (int row = 0; row < row_count; ++row) {
    const int cells = columns_ - row;
    for (int place = 0; place <= cells; ++place) {
      if (place == 0) {
        lower_grid_[{row, place}] = lower_rows_[row];
      } else if (place == cells) {
        lower_grid_[{row, place}] = lower_rows_[row].of_next();
      } else {
        lower_grid_[{row, place}] = panel_node(lower_rows_[row], static_cast<double>(place) / cells);
      }
    }
  }
  for (int row = 0; row < row_count; ++row) {
    std::vector<SectorIndex> knots;
    for (int place = 0; place <= columns_ - row; ++place) knots.push_back(lower_grid_[{row, place}]);
    add_net_thread(knots, row == 0 ? "kink row" : fmt::format("lower row {}", row));
  }
  for (int line = 1; line < columns_; ++line) {
    std::vector<SectorIndex> along_this, along_next;  // parallel to rod s and to rod s+1
    for (int row = 0; row < row_count; ++row) {
      if (line <= columns_ - row) along_this.push_back(lower_grid_[{row, line}]);
      if (line - row >= 0) along_next.push_back(lower_grid_[{row, line - row}]);
    }
    add_net_thread(along_this, fmt::format("diagonal {} along its first rod", line));
    add_net_thread(along_next, fmt::format("diagonal {} along its second rod", line));
  }
}

void PocketBuilder::add_upper_net() {
  std::vector<std::vector<SectorIndex>> grid(rows_ + 1, std::vector<SectorIndex>(columns_ + 1));
  for (int place = 0; place <= columns_; ++place) grid[0][place] = lower_grid_[{0, place}];
  for (int row = 1; row <= rows_; ++row) {
    grid[row].front() = upper_rows_[row];
    grid[row].back() = upper_rows_[row].of_next();
    for (int place = 1; place < columns_; ++place) {
      grid[row][place] = panel_node(upper_rows_[row], static_cast<double>(place) / columns_);
    }
  }
  for (int row = 1; row <= rows_; ++row) {
    add_net_thread(grid[row], row == rows_ ? "mouth row" : fmt::format("upper row {}", row));
  }
  for (int place = 1; place < columns_; ++place) {
    std::vector<SectorIndex> knots;
    for (int row = 0; row <= rows_; ++row) knots.push_back(grid[row][place]);
    add_net_thread(knots, fmt::format("column {}", place));
  }
}

void PocketBuilder::add_closing_ropes() {
  const SectorIndex tip = upper_rows_.back();
  const SectorThread thread =
      sectors_.add_thread({tip, tip.of_next()}, {scenario_.closing.elements}, rope_, PocketGroup::closing_ropes,
                          [](int sector) { return fmt::format("closing rope {}", sector + 1); });
  for (int sector = 0; sector < sectors_.sectors(); ++sector) {
    const double open = (sectors_.position(tip.of_next(), sector) - sectors_.position(tip, sector)).norm();
    VariableRope rope{{}, {open}};
    for (const std::int32_t local : thread.elements) rope.elements.push_back(sectors_.element(local, sector));
    pocket_.model.ropes.push_back(std::move(rope));
  }
}

void PocketBuilder::finish_structure() {
  Model& model = pocket_.model;
  model.nodes.shrink_to_fit();
  model.gradients.shrink_to_fit();
  model.elements.shrink_to_fit();
  model.element_groups = pocket_groups();
  if (pocket_.hub >= 0) model.element_groups.push_back({"tether", "the tether", CableLook::rope});
  const auto add_group = [&](const char* name, NodeLook look, SectorIndex node) {
    NodeGroup group{name, look, {}};
    for (int sector = 0; sector < sectors_.sectors(); ++sector) group.nodes.push_back(sectors_.node(node, sector));
    model.node_groups.push_back(std::move(group));
  };
  add_group(kRodRoots, NodeLook::adapter, root_);
  add_group(kRodKinks, NodeLook::joint, lower_rows_.front());
  add_group(kRodTips, NodeLook::reel, upper_rows_.back());
  pocket_.structure = model.structure();
}

}  // namespace

Pocket build_pocket(const Scenario& scenario) { return PocketBuilder(scenario).build(); }

}  // namespace netpocket
