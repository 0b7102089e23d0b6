#include "tests/systems/falling_net/falling_net.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/math/rotation.h"
#include "engine/scenario/target_shape.h"
#include "engine/systems/capture_system.h"
#include "engine/systems/pocket/materials.h"
#include "tests/systems/falling_net/spin_damper.h"

namespace netpocket {
namespace {

double number(const Scenario& scenario, std::string_view key) {
  return std::get<double>(scenario.own.contains(key) ? scenario.own.find(key)->second
                                                     : find_parameter(key, scenario.system)->get(scenario));
}

int cells_of(const Scenario& scenario) {
  return static_cast<int>(std::get<std::int64_t>(find_parameter("falling_net.cells", scenario.system)->get(scenario)));
}

void check(const Scenario& scenario, const Shape* target, Diagnostics& problems) {
  if (target == nullptr) return;
  const double needed = bounding_radius(*target) + scenario.net.diameter;
  if (number(scenario, "falling_net.height") <= needed) {
    problems.add({.key = "falling_net.height",
                  .message = fmt::format("must be more than {:.4g} m, or the net starts in the target", needed)});
  }
}

bool acts_at_once_here(std::string_view key) { return key == "falling_net.spin_damping"; }

const SystemParameters& description() {
  static const SystemParameters kDescription = {
      .name = "falling_net",
      .title = "Falling net",
      .help = "A square net between four masses falls on the target.",
      .shared_groups = {"net", "target", "contact"},
      .groups = {{"falling_net", "Falling net", "The net and its masses at the start."}},
      .parameters = {own_parameter(
                         "falling_net.cells", [] { return ParameterValue(std::int64_t{6}); }, {1, 40}, "",
                         "cells along a side", "assumption"),
                     own_parameter(
                         "falling_net.side", [] { return ParameterValue(4.0); }, {0.1, 100}, "m", "side of the net",
                         "assumption"),
                     own_parameter(
                         "falling_net.corner_mass", [] { return ParameterValue(0.5); }, {1e-3, 1e3}, "kg",
                         "mass at each corner", "assumption"),
                     own_parameter(
                         "falling_net.height", [] { return ParameterValue(1.5); }, {0, 1e3}, "m",
                         "height of the net above the target's centre", "assumption"),
                     own_parameter(
                         "falling_net.speed", [] { return ParameterValue(2.0); }, {0, 100}, "m/s",
                         "speed of the net towards the target", "assumption"),
                     own_parameter(
                         "falling_net.spin_damping", [] { return ParameterValue(0.0); }, {0, 1e6}, "N m s",
                         "torque on the target against its spin, by rate", "assumption")},
      .check = check,
      .acts_at_once = acts_at_once_here};
  return kDescription;
}

class NetBuilder {
 public:
  explicit NetBuilder(const Scenario& scenario)
      : scenario_(scenario), cells_(cells_of(scenario)), side_(number(scenario, "falling_net.side")) {}

  CaptureSystem build() {
    model_.contact = {.restitution = scenario_.contact.restitution,
                      .friction = scenario_.contact.friction,
                      .friction_velocity = scenario_.contact.friction_velocity,
                      .cords = scenario_.contact.cords,
                      .bodies = scenario_.contact.bodies};
    model_.gravity = scenario_.solver.gravity;
    model_.element_groups = {{"net", "the net", CableLook::cord}};
    material_ = model_.add_material(cord_material(scenario_.net));
    add_nodes();
    add_cords();
    CaptureSystem system;
    system.target = add_target();
    system.structure = model_.structure();
    add_channels(system);
    system.model = std::move(model_);
    system.controllers.push_back(
        {std::make_unique<SpinDamper>(system.target, number(scenario_, "falling_net.spin_damping")), 0.02});
    return system;
  }

 private:
  std::int32_t node(int row, int column) const { return row * (cells_ + 1) + column; }

  void add_nodes() {
    const double height = scenario_.target.position.y() + number(scenario_, "falling_net.height");
    for (int row = 0; row <= cells_; ++row) {
      for (int column = 0; column <= cells_; ++column) {
        const double x = side_ * (static_cast<double>(column) / cells_ - 0.5);
        const double z = side_ * (static_cast<double>(row) / cells_ - 0.5);
        const std::int32_t index = model_.add_node({x, height, z});
        model_.nodes[static_cast<std::size_t>(index)].velocity.y() = -number(scenario_, "falling_net.speed");
      }
    }
    corners_ = {node(0, 0), node(0, cells_), node(cells_, cells_), node(cells_, 0)};
    for (const std::int32_t corner : corners_) {
      model_.nodes[static_cast<std::size_t>(corner)].point_mass = number(scenario_, "falling_net.corner_mass");
    }
    model_.node_groups = {{"corners", NodeLook::reel, corners_}};
  }

  // A cord keeps its slope where it crosses others: all its elements share one gradient at each node.
  void add_cords() {
    for (int line = 0; line <= cells_; ++line) {
      add_cord(fmt::format("row {}", line), [&](int i) { return node(line, i); });
      add_cord(fmt::format("column {}", line), [&](int i) { return node(i, line); });
    }
  }

  void add_cord(const std::string& name, const std::function<std::int32_t(int)>& node_at) {
    const std::int32_t thread = model_.add_thread(name);
    const auto place = [&](int i) { return model_.nodes[static_cast<std::size_t>(node_at(i))].position; };
    const Eigen::Vector3d along = (place(1) - place(0)).normalized();
    std::int32_t gradient = model_.add_gradient(node_at(0), along);
    for (int i = 0; i < cells_; ++i) {
      const std::int32_t next = model_.add_gradient(node_at(i + 1), along);
      model_.add_element({.node1 = node_at(i),
                          .gradient1 = gradient,
                          .node2 = node_at(i + 1),
                          .gradient2 = next,
                          .length = side_ / cells_,
                          .material = material_,
                          .thread = thread});
      gradient = next;
    }
  }

  std::int32_t add_target() {
    const TargetParameters& target = scenario_.target;
    const Shape shape = std::get<Shape>(target_shape(scenario_));
    return model_.add_body({.name = "target",
                            .role = BodyRole::target,
                            .shape = shape,
                            .mass = target.mass,
                            .inertia = target_inertia(target, shape),
                            .state = {.position = target.position,
                                      .attitude = rotation_by(target.attitude),
                                      .velocity = target.velocity,
                                      .angular_velocity = target.spin}});
  }

  void add_channels(CaptureSystem& system) const {
    std::vector<ChannelInfo> channels = common_channels(false, true);
    const std::size_t height = channels.size();
    channels.push_back({"corner_height", "m", "height of the corners above the target's centre, mean"});
    channels.push_back({"spread", "m", "distance between opposite corners, mean"});
    channels.push_back({"captured", "1", "1 while all corners are below the target's centre"});
    system.structure.channels = std::make_shared<const ChannelList>(std::move(channels));
    system.fill_channels = [corners = corners_, height, target = system.target](const CableSystem&, Snapshot& s) {
      double sum = 0, highest = -std::numeric_limits<double>::infinity();
      for (const std::int32_t corner : corners) {
        const double above = s.positions(1, corner) - s.bodies[static_cast<std::size_t>(target)].position.y();
        sum += above;
        highest = std::max(highest, above);
      }
      const auto distance = [&](int a, int b) {
        return (s.positions.col(corners[a]) - s.positions.col(corners[b])).norm();
      };
      s.channels[height] = sum / 4;
      s.channels[height + 1] = 0.5 * (distance(0, 2) + distance(1, 3));
      s.channels[height + 2] = highest < 0 ? 1 : 0;
    };
  }

  const Scenario& scenario_;
  int cells_;
  double side_;  // m
  Model model_;
  std::int32_t material_ = 0;
  std::vector<std::int32_t> corners_;
};

CaptureSystem build(const Scenario& scenario) { return NetBuilder(scenario).build(); }

std::vector<Phase> phases(const Scenario& scenario) {
  const double speed = std::max(number(scenario, "falling_net.speed"), 1e-3);
  const double fall = (number(scenario, "falling_net.height") - scenario.target.radius) / speed;
  return {{"fall", 0, fall}, {"wrap", fall, std::numeric_limits<double>::infinity()}};
}

}  // namespace

void register_falling_net() { register_capture_system({&description(), build, phases}); }

}  // namespace netpocket
