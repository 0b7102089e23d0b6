#include "engine/systems/thrown_net/thrown_net.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "engine/math/elementary.h"
#include "engine/math/rotation.h"
#include "engine/model/lane_order.h"
#include "engine/model/reorder.h"
#include "engine/scenario/target_shape.h"
#include "engine/systems/pocket/materials.h"
#include "engine/systems/tether_winch.h"

namespace netpocket {
namespace {

enum class NetGroup : std::int32_t { cords, corner_threads, drawstring, tether };

// The tether starts this far in front of the spacecraft's face, so that its end does not touch it.
constexpr double kEye = 0.02;  // m

// Drag of a drawstring at a ring, by the force that rope of its mass needs to run with the speed of waves: little
// enough not to be noticed beside friction.
constexpr double kRingDrag = 1e-3;

class ThrownNetBuilder {
 public:
  explicit ThrownNetBuilder(const Scenario& scenario)
      : scenario_(scenario),
        given_(thrown_net_parameters(scenario)),
        model_(net_.model),
        face_(scenario.spacecraft.position + Eigen::Vector3d(0, 0.5 * scenario.spacecraft.size.y(), 0)) {}

  ThrownNet build() {
    net_.pattern = net_pattern(given_.shape, given_.side, given_.cells, given_.spokes);
    model_.contact = {.restitution = scenario_.contact.restitution,
                      .friction = scenario_.contact.friction,
                      .friction_velocity = scenario_.contact.friction_velocity,
                      .edge_radius = scenario_.contact.edge_radius,
                      .cords = scenario_.contact.cords,
                      .bodies = scenario_.contact.bodies};
    model_.gravity = scenario_.solver.gravity;
    model_.element_groups = {{"net", "the net", CableLook::cord},
                             {"corner threads", "a corner thread", CableLook::cord},
                             {"drawstring", "the drawstring", CableLook::rope},
                             {"tether", "the tether", CableLook::rope}};
    add_bodies();
    add_knots();
    add_cords();
    add_corner_masses();
    if (given_.tethered) add_tether();
    throw_net();
    order_by_parts();
    return std::move(net_);
  }

 private:
  // A straight chain from node to node, folded: its material is `length` long and its slopes are chord/length.
  std::vector<std::int32_t> add_chain(const std::vector<std::int32_t>& stops, int per_stop, double length,
                                      std::int32_t material, NetGroup group, const std::string& name);
  std::int32_t add_inner_node(std::int32_t from, std::int32_t to, double part);
  void add_bodies();
  void add_knots();
  void add_cords();
  std::vector<std::int32_t> nodes_of(const NetCord& cord) const;
  void add_side(const NetCord& cord, const std::string& name);
  void add_rings(const NetCord& cord);
  void add_corner_masses();
  void add_tether();
  void throw_net();
  LaneItem part_of(std::int32_t node) const;
  LaneItem part_of(const ModelGradient& gradient) const;
  LaneItem part_of(const ModelElement& element) const;
  void order_by_parts();

  const Scenario& scenario_;
  ThrownNetParameters given_;
  ThrownNet net_;
  Model& model_;
  Eigen::Vector3d face_;  // m, middle of the spacecraft's +y face
  std::int32_t cord_ = 0, drawstring_ = 0;
};

std::int32_t ThrownNetBuilder::add_inner_node(std::int32_t from, std::int32_t to, double part) {
  const Eigen::Vector3d begin = model_.nodes[static_cast<std::size_t>(from)].position;
  const Eigen::Vector3d end = model_.nodes[static_cast<std::size_t>(to)].position;
  return model_.add_node((1 - part) * begin + part * end);
}

std::vector<std::int32_t> ThrownNetBuilder::add_chain(const std::vector<std::int32_t>& stops, int per_stop,
                                                      double length, std::int32_t material, NetGroup group,
                                                      const std::string& name) {
  const auto place = [&](std::int32_t node) { return model_.nodes[static_cast<std::size_t>(node)].position; };
  const Eigen::Vector3d slope = (place(stops.back()) - place(stops.front())) / length;
  const std::int32_t thread = model_.add_thread(name);
  const double element_length = length / static_cast<double>((stops.size() - 1) * static_cast<std::size_t>(per_stop));
  std::vector<std::int32_t> elements;
  std::int32_t node = stops.front(), gradient = model_.add_gradient(node, slope);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    for (int k = 1; k <= per_stop; ++k) {
      const std::int32_t next =
          k == per_stop ? stops[i + 1] : add_inner_node(stops[i], stops[i + 1], static_cast<double>(k) / per_stop);
      const std::int32_t next_gradient = model_.add_gradient(next, slope);
      elements.push_back(model_.add_element({.node1 = node,
                                             .gradient1 = gradient,
                                             .node2 = next,
                                             .gradient2 = next_gradient,
                                             .length = element_length,
                                             .material = material,
                                             .group = static_cast<std::int32_t>(group),
                                             .thread = thread}));
      node = next;
      gradient = next_gradient;
    }
  }
  return elements;
}

void ThrownNetBuilder::add_bodies() {
  const SpacecraftParameters& craft = scenario_.spacecraft;
  const TargetParameters& target = scenario_.target;
  auto shape = target_shape(scenario_);
  if (const auto* problem = std::get_if<Diagnostic>(&shape)) throw std::runtime_error(problem->text());
  const Shape& of_target = std::get<Shape>(shape);
  net_.spacecraft = model_.add_body({.name = "spacecraft",
                                     .role = BodyRole::spacecraft,
                                     .shape = Box{craft.size},
                                     .mass = craft.mass,
                                     .inertia = craft.inertia.asDiagonal(),
                                     .state = {.position = craft.position},
                                     .touches_cables = scenario_.contact.spacecraft});
  net_.target = model_.add_body({.name = "target",
                                 .role = BodyRole::target,
                                 .shape = of_target,
                                 .mass = target.mass,
                                 .inertia = target_inertia(target, of_target),
                                 .state = {.position = target.position,
                                           .attitude = rotation_by(target.attitude),
                                           .velocity = target.velocity,
                                           .angular_velocity = target.spin},
                                 .youngs_modulus = target.youngs_modulus,
                                 .poisson_ratio = target.poisson_ratio});
}

void ThrownNetBuilder::add_knots() {
  for (const Eigen::Vector2d& flat : net_.pattern.knots) {
    const Eigen::Vector2d folded = given_.folding * flat;
    net_.knots.push_back(model_.add_node(face_ + Eigen::Vector3d(folded.x(), given_.gap, folded.y())));
  }
}

void ThrownNetBuilder::add_cords() {
  cord_ = model_.add_material(cord_material(given_.cord));
  if (given_.has_drawstring()) drawstring_ = model_.add_material(cord_material(given_.drawstring_cord));
  int side = 0;
  for (const NetCord& cord : net_.pattern.cords) {
    if (cord.is_side && given_.has_drawstring()) {
      if (given_.passage == DrawstringPassage::even) {
        add_side(cord, fmt::format("drawstring {}", ++side));
        continue;
      }
      add_rings(cord);
    }
    const auto elements = add_chain(nodes_of(cord), cord.divisions * given_.elements_per_side, cord.length, cord_,
                                    NetGroup::cords, cord.name);
    net_.net_elements.insert(net_.net_elements.end(), elements.begin(), elements.end());
  }
}

std::vector<std::int32_t> ThrownNetBuilder::nodes_of(const NetCord& cord) const {
  std::vector<std::int32_t> nodes;
  for (const std::int32_t knot : cord.knots) nodes.push_back(net_.node_of(knot));
  return nodes;
}

// A side whose cord is drawstring: a rope that winches at the net's corners wind in.
void ThrownNetBuilder::add_side(const NetCord& cord, const std::string& name) {
  VariableRope rope;
  rope.elements = add_chain(nodes_of(cord), cord.divisions * given_.elements_per_side, cord.length, drawstring_,
                            NetGroup::drawstring, name);
  rope.motion.length = cord.length;
  model_.ropes.push_back(std::move(rope));
}

// A side along whose cord the drawstring runs, through rings at the knots. Its mass stays with the knots.
void ThrownNetBuilder::add_rings(const NetCord& cord) {
  const CableSection& section = model_.materials[static_cast<std::size_t>(drawstring_)].section;
  const std::size_t parts = cord.knots.size() - 1;
  const double length = cord.length / static_cast<double>(parts);
  const double impedance = std::sqrt(section.EA * section.mass_per_length);
  model_.ring_ropes.push_back({.nodes = nodes_of(cord),
                               .lengths = std::vector<double>(parts, length),
                               .stiffness = section.EA,
                               .damping = section.axial_damping,
                               .friction = given_.ring_friction,
                               .extra_angle = given_.ring_angle,
                               .drag = kRingDrag * impedance,
                               .least_part = given_.ring_spacing});
  model_.node_groups.push_back(
      {fmt::format("drawstring {}", model_.ring_ropes.size()), NodeLook::rope, nodes_of(cord)});
  for (std::size_t part = 0; part < parts; ++part) {
    for (const std::size_t end : {part, part + 1}) {
      model_.nodes[static_cast<std::size_t>(net_.node_of(cord.knots[end]))].point_mass +=
          0.5 * section.mass_per_length * length;
    }
  }
}

void ThrownNetBuilder::add_corner_masses() {
  CordParameters thread = given_.cord;
  thread.diameter = given_.corner_thread_diameter;
  const std::int32_t material = given_.corner_thread > 0 ? model_.add_material(cord_material(thread)) : 0;
  const double mesh = given_.side / given_.cells;
  const int count = std::max(1, static_cast<int>(std::lround(given_.corner_thread / mesh))) * given_.elements_per_side;
  int number = 0;
  for (const std::int32_t knot : net_.pattern.corners) {
    const std::int32_t corner = net_.node_of(knot);
    const Eigen::Vector3d place = model_.nodes[static_cast<std::size_t>(corner)].position;
    const Eigen::Vector3d out = Eigen::Vector3d(place.x() - face_.x(), 0, place.z() - face_.z()).normalized();
    std::int32_t mass = corner;
    if (given_.corner_thread > 0) {
      mass = model_.add_node(place + given_.folding * given_.corner_thread * out);
      add_chain({corner, mass}, count, given_.corner_thread, material, NetGroup::corner_threads,
                fmt::format("corner thread {}", ++number));
    }
    ModelNode& node = model_.nodes[static_cast<std::size_t>(mass)];
    node.point_mass += given_.corner_mass;
    node.velocity = given_.speed * (sine(given_.angle) * out + cosine(given_.angle) * Eigen::Vector3d::UnitY());
    net_.corner_masses.push_back(mass);
  }
  model_.node_groups.push_back({kCornerMasses, NodeLook::reel, net_.corner_masses});
}

void ThrownNetBuilder::add_tether() {
  const std::int32_t eye = model_.add_node(face_ + Eigen::Vector3d(0, std::min(kEye, 0.5 * given_.gap), 0));
  const std::int32_t middle = net_.node_of(net_.pattern.middle);
  model_.nodes[static_cast<std::size_t>(eye)].support = Support::body;
  model_.nodes[static_cast<std::size_t>(eye)].body = net_.spacecraft;
  const CableMaterial cord = cord_material(given_.tether);
  if (given_.is_wound()) {
    net_.tether_rope = static_cast<std::int32_t>(model_.rope_count());
    return add_wound_tether(model_, given_.drum, cord.section, eye, middle);
  }
  const std::int32_t material = model_.add_material(cord);
  const auto elements =
      add_chain({eye, middle}, given_.tether_elements, given_.tether_length, material, NetGroup::tether, "tether");
  net_.tether_end = elements.front();
}

// Spin and recoil: everything that is free turns about the axis; the spacecraft has the opposite momenta.
void ThrownNetBuilder::throw_net() {
  std::vector<double> mass;
  for (const ModelNode& node : model_.nodes) mass.push_back(node.point_mass);
  for (const ModelElement& element : model_.elements) {
    const double half =
        0.5 * model_.materials[static_cast<std::size_t>(element.material)].section.mass_per_length * element.length;
    for (const std::int32_t node : {element.node1, element.node2}) mass[static_cast<std::size_t>(node)] += half;
  }
  const Eigen::Vector3d spin(0, given_.spin, 0);
  ModelBody& craft = model_.bodies[static_cast<std::size_t>(net_.spacecraft)];
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), angular_momentum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    ModelNode& node = model_.nodes[i];
    if (node.support != Support::free) continue;
    const Eigen::Vector3d arm = node.position - craft.state.position;
    node.velocity += spin.cross(arm);
    momentum += mass[i] * node.velocity;
    angular_momentum += mass[i] * arm.cross(node.velocity);
  }
  for (ModelGradient& gradient : model_.gradients) gradient.rate = spin.cross(gradient.value);
  if (!given_.recoil) return;
  craft.state.velocity = -momentum / craft.mass;
  craft.state.angular_velocity = -(craft.inertia.inverse() * angular_momentum);
}

// Knots were added first, in the order of the pattern.
LaneItem ThrownNetBuilder::part_of(std::int32_t node) const {
  const auto& parts = net_.pattern.parts;
  const auto index = static_cast<std::size_t>(node);
  if (index >= parts.size()) return {};
  return {parts[index].part, {parts[index].place, -1, -1, -1}};
}

// An element between two knots belongs to the part of the first.
LaneItem ThrownNetBuilder::part_of(const ModelElement& element) const {
  LaneItem item = part_of(element.node1);
  const LaneItem other = part_of(element.node2);
  if (item.part < 0 || other.part < 0) return {};
  item.place[1] = other.place[0];
  return item;
}

// The gradients of a square net's cords are along x or z, so the axis tells those of a knot apart.
LaneItem ThrownNetBuilder::part_of(const ModelGradient& gradient) const {
  int axis = 0;
  gradient.value.cwiseAbs().maxCoeff(&axis);
  if (gradient.value != gradient.value[axis] * Eigen::Vector3d::Unit(axis)) return {};
  LaneItem item = part_of(gradient.node);
  item.place[1] = axis;
  return item;
}

// So that the kernels compute the same place of eight parts at once.
void ThrownNetBuilder::order_by_parts() {
  if (net_.pattern.parts.empty()) return;
  std::vector<LaneItem> nodes, gradients, elements;
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) nodes.push_back(part_of(static_cast<std::int32_t>(i)));
  for (const ModelGradient& gradient : model_.gradients) gradients.push_back(part_of(gradient));
  for (const ModelElement& element : model_.elements) elements.push_back(part_of(element));
  const NewIndices to = reorder(model_, {lane_order(nodes), lane_order(gradients), lane_order(elements)});
  renumber(net_.knots, to.nodes);
  renumber(net_.corner_masses, to.nodes);
  renumber(net_.net_elements, to.elements);
  renumber(std::span(&net_.tether_end, 1), to.elements);
}

}  // namespace

ThrownNet build_thrown_net(const Scenario& scenario) { return ThrownNetBuilder(scenario).build(); }

}  // namespace netpocket
