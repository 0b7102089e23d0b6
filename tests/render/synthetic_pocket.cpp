#include "tests/render/synthetic_pocket.h"

#include <cmath>
#include <numbers>

#include "engine/state/pocket_groups.h"

namespace netpocket::synthetic {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kRods = 8, kColumns = 6, kLowerRows = 6, kUpperRows = 6, kRows = kLowerRows + kUpperRows;
constexpr int kElementsPerSide = 2, kRopeElements = 4;
constexpr int kRodNodes = kRows * kElementsPerSide + 1;
constexpr double kPi = std::numbers::pi;

// A place on the pocket: u around in panels (0 to 8), v up in rows (0 to kRows).
struct Place {
  double u;
  double v;
};

// Rod profile (r, y): (0.6, 0) -> (4.8, 5.3) -> a tip whose radius shrinks while closing.
Vector2d profile(double v, double closed) {
  const double tip_radius = 7.56 + closed * (1.05 / std::sin(kPi / kRods) - 7.56);
  const Vector2d root(0.6, 0), kink(4.8 + 0.2 * closed, 5.3 - 0.1 * closed);
  if (v <= kLowerRows) return root + v / kLowerRows * (kink - root);
  const double s = (v - kLowerRows) / kUpperRows;
  const Vector2d tip(tip_radius, 12 - 0.6 * closed);
  const double bulge = 1.1 * closed * std::sin(kPi * s);
  return kink + s * (tip - kink) + Vector2d(bulge, 0.3 * bulge);
}

// Flat panels between neighbouring rods, sagging a little outwards when closed.
Vector3d position(const Place& place, double closed) {
  const double panel = std::min(std::floor(place.u), kRods - 1.0), s = place.u - panel;
  const Vector2d p = profile(place.v, closed);
  const auto rod = [&](double index) {
    const double angle = 2 * kPi * index / kRods;
    return Vector3d(p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle));
  };
  const Vector3d flat = (1 - s) * rod(panel) + s * rod(panel + 1);
  const double sag = 0.35 * closed * std::sin(kPi * s) * std::sin(kPi * place.v / kRows);
  return flat + sag * Vector3d(flat.x(), 0, flat.z()).normalized();
}

class Builder {
 public:
  std::vector<Place> places;
  Structure structure;

  // A thread of elements through places; every element has slopes of its own.
  void add_thread(const std::string& name, PocketGroup group, double radius, const std::vector<Place>& along) {
    std::vector<std::int32_t> nodes;
    for (const auto& place : along) nodes.push_back(add_node(place));
    const auto thread = static_cast<std::int32_t>(structure.threads.size());
    structure.threads.push_back(name);
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      const auto gradient = structure.gradient_count;
      structure.gradient_count += 2;
      StructureElement element{
          {nodes[i], nodes[i + 1]}, {gradient, gradient + 1}, index_of(group), thread, -1, 0, radius};
      element.length = (position(along[i + 1], 0) - position(along[i], 0)).norm();
      if (group == PocketGroup::closing_ropes) {
        element.rope = structure.rope_count;
        element.length = (position(along.back(), 0) - position(along.front(), 0)).norm() / kRopeElements;
      }
      structure.elements.push_back(element);
    }
    if (group == PocketGroup::closing_ropes) ++structure.rope_count;
  }

  std::int32_t add_node(const Place& place) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (std::abs(places[i].u - place.u) < 1e-9 && std::abs(places[i].v - place.v) < 1e-9) {
        return static_cast<std::int32_t>(i);
      }
    }
    places.push_back(place);
    return static_cast<std::int32_t>(places.size()) - 1;
  }
};

std::vector<Place> line(const Place& from, const Place& to, int elements) {
  std::vector<Place> along;
  for (int i = 0; i <= elements; ++i) {
    const double s = static_cast<double>(i) / elements;
    along.push_back({from.u + s * (to.u - from.u), from.v + s * (to.v - from.v)});
  }
  // The last panel ends at the first rod.
  for (auto& place : along) {
    if (place.u > kRods - 1e-9) place.u = 0;
  }
  return along;
}

void add_panel(Builder& builder, int panel) {
  const double left = panel, right = panel + 1;
  const auto column = [&](int i) { return left + (right - left) * i / kColumns; };
  for (int row = 1; row <= kRows; ++row) {
    const double v = row;
    // Rows of the triangular part have as many meshes as their number.
    const int meshes = std::min(row, kColumns);
    const auto along = line({left, v}, {right, v}, meshes * kElementsPerSide);
    if (row < kRows) builder.add_thread("row", PocketGroup::net, 0.002, along);
  }
  for (int row = 1; row < kLowerRows; ++row) {
    for (int i = 0; i <= row; ++i) {
      const Place knot{left + static_cast<double>(i) / row, static_cast<double>(row)};
      for (const int next : {i, i + 1}) {
        const Place upper{left + static_cast<double>(next) / (row + 1), row + 1.0};
        const bool on_rod = (i == 0 && next == 0) || (i == row && next == row + 1);
        if (!on_rod) builder.add_thread("diagonal", PocketGroup::net, 0.002, line(knot, upper, kElementsPerSide));
      }
    }
  }
  for (int i = 1; i < kColumns; ++i) {
    builder.add_thread("column", PocketGroup::net, 0.002,
                       line({column(i), kLowerRows}, {column(i), kRows}, kUpperRows * kElementsPerSide));
  }
  builder.add_thread("closing rope", PocketGroup::closing_ropes, 0.002,
                     line({left, kRows}, {right, kRows}, kRopeElements));
}

Builder build() {
  Builder builder;
  builder.structure.element_groups = pocket_groups();
  NodeGroup roots{kRodRoots, NodeLook::adapter, {}}, kinks{kRodKinks, NodeLook::joint, {}},
      tips{kRodTips, NodeLook::reel, {}};
  for (int rod = 0; rod < kRods; ++rod) {
    const double u = rod;
    builder.add_thread("rod", PocketGroup::rods, 0.05, line({u, 0}, {u, kRows}, kRodNodes - 1));
    roots.nodes.push_back(builder.add_node({u, 0}));
    kinks.nodes.push_back(builder.add_node({u, kLowerRows}));
    tips.nodes.push_back(builder.add_node({u, kRows}));
  }
  builder.structure.node_groups = {roots, kinks, tips};
  for (int panel = 0; panel < kRods; ++panel) add_panel(builder, panel);
  builder.structure.node_count = static_cast<std::int32_t>(builder.places.size());
  return builder;
}

}  // namespace

Structure make_structure(const Shape& target) {
  auto structure = build().structure;
  structure.bodies = {{"spacecraft", BodyRole::spacecraft, Box{{1.6, 2.0, 1.6}}, 1210},
                      {"target", BodyRole::target, target, 200}};
  return structure;
}

Snapshot make_snapshot(const Structure& structure, double time, double closed) {
  static const Builder builder = build();
  Snapshot snapshot;
  snapshot.time = time;
  const auto nodes = structure.node_count, elements = static_cast<int>(structure.elements.size());
  snapshot.positions.resize(3, nodes);
  snapshot.velocities.resize(3, nodes);
  snapshot.gradients.resize(3, structure.gradient_count);
  for (int i = 0; i < nodes; ++i) {
    const auto& place = builder.places[i];
    snapshot.positions.col(i) = position(place, closed);
    snapshot.velocities.col(i) = (position(place, closed + 0.01) - position(place, closed - 0.01)) / 0.02 * 0.15;
  }
  snapshot.tension.resize(elements);
  snapshot.strain.resize(elements);
  snapshot.rope_element_length.assign(structure.rope_count, 0);
  for (int i = 0; i < elements; ++i) {
    const auto& element = structure.elements[i];
    const Vector3d chord = snapshot.positions.col(element.node[1]) - snapshot.positions.col(element.node[0]);
    for (const auto gradient : element.gradient) snapshot.gradients.col(gradient) = chord.normalized();
    if (element.rope >= 0) snapshot.rope_element_length[element.rope] = chord.norm();
    const double height = (snapshot.positions(1, element.node[0]) + snapshot.positions(1, element.node[1])) / 2;
    snapshot.tension[i] = element.group == index_of(PocketGroup::rods) ? -20 : 40 * std::exp(-std::pow((height - 9) / 3, 2));
    snapshot.strain[i] = snapshot.tension[i] / (12e9 * kPi * 0.002 * 0.002);
  }
  snapshot.bodies.resize(structure.bodies.size());
  snapshot.bodies[0].position = {0, -1, 0};
  snapshot.bodies[1].position = {0, 7.5, 0};
  snapshot.bodies[1].attitude = Eigen::AngleAxisd(0.05 * time, Vector3d(1, 2, 0.5).normalized());
  return snapshot;
}

}  // namespace netpocket::synthetic
