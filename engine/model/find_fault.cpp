#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/model/model.h"
#include "engine/orbit/gravity.h"

namespace netpocket {
namespace {

using Fault = std::optional<std::string>;

std::string numbered(const char* what, std::size_t index) {
  std::string text = what;
  text += ' ';
  text += std::to_string(index);
  return text;
}

class FaultSearch {
 public:
  explicit FaultSearch(const Model& model) : model_(model) {}

  Fault first() const {
    for (const auto search :
         {&FaultSearch::in_nodes, &FaultSearch::in_gradients, &FaultSearch::in_materials, &FaultSearch::in_elements,
          &FaultSearch::in_bodies, &FaultSearch::in_locks, &FaultSearch::in_hinges, &FaultSearch::in_lines,
          &FaultSearch::in_ropes, &FaultSearch::in_ring_ropes, &FaultSearch::in_node_groups}) {
      if (Fault fault = (this->*search)()) return fault;
    }
    return in_orbit();
  }

 private:
  static bool is_index(std::int32_t index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
  }
  static bool is_positive(double value) { return value > 0 && std::isfinite(value); }
  static bool is_not_negative(double value) { return value >= 0 && std::isfinite(value); }

  // Calls `fault_of` with each item until it returns a text, which is completed to a sentence.
  template <typename Items, typename FaultOf>
  static Fault search(const char* what, const Items& items, const FaultOf& fault_of) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (const std::string fault = fault_of(items[i], i); !fault.empty())
        return numbered(what, i).append(" ").append(fault);
    }
    return std::nullopt;
  }

  template <typename Supported>
  std::string support_fault(const Supported& item) const {
    const bool names_a_body = item.support == Support::body;
    return names_a_body && !is_index(item.body, model_.bodies.size()) ? "is held by a body that does not exist" : "";
  }

  Fault in_nodes() const {
    return search("node", model_.nodes, [&](const ModelNode& node, std::size_t) -> std::string {
      if (!node.position.allFinite() || !node.velocity.allFinite())
        return "has a position or velocity that is not finite";
      if (!node.load.allFinite()) return "has a load that is not finite";
      if (!is_not_negative(node.point_mass)) return "has a negative or infinite mass";
      return support_fault(node);
    });
  }

  Fault in_gradients() const {
    return search("gradient", model_.gradients, [&](const ModelGradient& gradient, std::size_t) -> std::string {
      if (!is_index(gradient.node, model_.nodes.size())) return "belongs to a node that does not exist";
      if (!gradient.value.allFinite() || !gradient.rate.allFinite()) return "has a value or rate that is not finite";
      return support_fault(gradient);
    });
  }

  Fault in_materials() const {
    return search("material", model_.materials, [&](const CableMaterial& material, std::size_t) -> std::string {
      const CableSection& section = material.section;
      if (!is_positive(section.EA)) return "has no axial stiffness";
      if (!is_not_negative(section.EI)) return "has a negative or infinite bending stiffness";
      if (!is_positive(section.mass_per_length)) return "has no mass per length";
      if (!is_not_negative(section.axial_damping) || !is_not_negative(section.bending_damping)) {
        return "has a negative or infinite damping";
      }
      if (!(section.compression >= 0 && section.compression <= 1)) return "has a compression outside 0 to 1";
      if (!is_not_negative(material.radius)) return "has a negative or infinite radius";
      return "";
    });
  }

  Fault in_elements() const {
    return search("element", model_.elements, [&](const ModelElement& element, std::size_t index) -> std::string {
      for (const std::int32_t node : {element.node1, element.node2}) {
        if (!is_index(node, model_.nodes.size())) return "joins a node that does not exist";
      }
      if (element.node1 == element.node2) return "joins a node to itself";
      for (const auto& [gradient, node] :
           {std::pair(element.gradient1, element.node1), {element.gradient2, element.node2}}) {
        if (!is_index(gradient, model_.gradients.size())) return "has a gradient that does not exist";
        if (model_.gradients[gradient].node != node) return "has a gradient of another node";
      }
      if (!is_positive(element.length)) return "has no length";
      if (!is_index(element.material, model_.materials.size())) return "is of a material that does not exist";
      if (!is_index(element.group, model_.element_groups.size())) return "belongs to a group that does not exist";
      if (!is_index(element.thread, model_.threads.size())) return "belongs to a thread that does not exist";
      return partner_fault(element, index);
    });
  }

  std::string partner_fault(const ModelElement& element, std::size_t index) const {
    if (element.strain_partner == -1) return "";
    if (!is_index(element.strain_partner, model_.elements.size())) return "has a strain partner that does not exist";
    const ModelElement& partner = model_.elements[element.strain_partner];
    if (partner.strain_partner != static_cast<std::int32_t>(index)) return "is not its strain partner's partner";
    const bool are_alike = partner.material == element.material &&
                           std::abs(partner.length - element.length) <= 1e-6 * std::abs(element.length);
    return are_alike ? "" : "has a strain partner of another length or material";
  }

  Fault in_bodies() const {
    return search("body", model_.bodies, [&](const ModelBody& body, std::size_t) -> std::string {
      if (!is_positive(body.mass)) return "has no mass";
      if (!body.inertia.allFinite()) return "has an inertia that is not finite";
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(body.inertia, Eigen::EigenvaluesOnly);
      if (!(solver.eigenvalues().minCoeff() > 0)) return "has an inertia that is not positive definite";
      const bool is_finite = body.state.position.allFinite() && body.state.attitude.coeffs().allFinite() &&
                             body.state.velocity.allFinite() && body.state.angular_velocity.allFinite();
      return is_finite ? "" : "has a state that is not finite";
    });
  }

  Fault in_locks() const {
    std::vector<bool> is_locked(model_.bodies.size());
    return search("lock", model_.locks, [&](const BodyLock& lock, std::size_t) -> std::string {
      for (const std::int32_t body : {lock.carrier, lock.carried}) {
        if (!is_index(body, model_.bodies.size())) return "joins a body that does not exist";
        if (is_locked[static_cast<std::size_t>(body)]) return "joins a body that is locked already";
        is_locked[static_cast<std::size_t>(body)] = true;
      }
      return "";
    });
  }

  Fault in_hinges() const {
    return search("hinge", model_.hinges, [&](const Hinge& hinge, std::size_t) -> std::string {
      for (const std::int32_t gradient : {hinge.gradient1, hinge.gradient2}) {
        if (!is_index(gradient, model_.gradients.size())) return "joins a gradient that does not exist";
      }
      if (model_.gradients[hinge.gradient1].node != model_.gradients[hinge.gradient2].node) {
        return "joins gradients of two nodes";
      }
      if (hinge.body != -1 && !is_index(hinge.body, model_.bodies.size()))
        return "turns with a body that does not exist";
      if (!is_not_negative(hinge.stiffness) || !is_not_negative(hinge.damping)) {
        return "has a negative or infinite stiffness or damping";
      }
      return "";
    });
  }

  Fault in_lines() const {
    return search("line", model_.lines, [&](const TensionLine& line, std::size_t) -> std::string {
      for (const std::int32_t node : {line.node1, line.node2}) {
        if (!is_index(node, model_.nodes.size())) return "joins a node that does not exist";
      }
      if (line.node1 == line.node2) return "joins a node to itself";
      if (!is_positive(line.length)) return "has no length";
      if (!is_positive(line.stiffness)) return "has no stiffness";
      return is_not_negative(line.damping) ? "" : "has a negative or infinite damping";
    });
  }

  Fault in_ropes() const {
    return search("rope", model_.ropes, [&](const VariableRope& rope, std::size_t) -> std::string {
      if (rope.elements.empty()) return "has no elements";
      for (std::size_t i = 0; i < rope.elements.size(); ++i) {
        if (!is_index(rope.elements[i], model_.elements.size())) return "has an element that does not exist";
        if (i == 0) continue;
        const ModelElement &last = model_.elements[rope.elements[i - 1]], &element = model_.elements[rope.elements[i]];
        if (last.node2 != element.node1) return "has elements that do not follow each other";
      }
      if (!is_positive(rope.motion.length)) return "has no length at the start";
      if (!std::isfinite(rope.motion.rate) || !std::isfinite(rope.motion.acceleration)) {
        return "has a rate or acceleration that is not finite";
      }
      if (!(rope.share_at_start >= 0 && rope.share_at_start <= 1)) return "has a share at its start outside 0 to 1";
      return "";
    });
  }

  Fault in_ring_ropes() const {
    return search("rope through rings", model_.ring_ropes, [&](const RingRope& rope, std::size_t) -> std::string {
      if (rope.nodes.size() < 2) return "has fewer than two nodes";
      if (rope.lengths.size() + 1 != rope.nodes.size()) return "has other than one length between two nodes";
      for (std::size_t i = 0; i < rope.nodes.size(); ++i) {
        if (!is_index(rope.nodes[i], model_.nodes.size())) return "joins a node that does not exist";
        if (i > 0 && rope.nodes[i] == rope.nodes[i - 1]) return "joins a node to itself";
      }
      if (!std::ranges::all_of(rope.lengths, [](double length) { return is_positive(length); })) return "has no length";
      if (!is_positive(rope.stiffness)) return "has no stiffness";
      if (!is_positive(rope.drag) || !is_positive(rope.least_part)) return "needs a positive drag and least part";
      if (!is_not_negative(rope.damping) || !is_not_negative(rope.friction) || !is_not_negative(rope.extra_angle)) {
        return "has a negative or infinite damping, friction or angle";
      }
      if (!(rope.share_at_start >= 0 && rope.share_at_start <= 1)) return "has a share at its start outside 0 to 1";
      return std::isfinite(rope.motion.rate) && std::isfinite(rope.motion.acceleration)
                 ? ""
                 : "has a rate or acceleration that is not finite";
    });
  }

  // A closed orbit has negative energy.
  Fault in_orbit() const {
    if (!model_.orbit) return std::nullopt;
    const Orbit& orbit = *model_.orbit;
    if (!are_perpendicular(orbit.x, orbit.y)) return "the axes of the orbit are parallel";
    const double radius = orbit.position.norm(), square = orbit.velocity.squaredNorm();
    const bool is_closed = radius > 0 && std::isfinite(radius) && 0.5 * square < kEarthMu / radius;
    const bool has_plane = orbit.position.cross(orbit.velocity).squaredNorm() > 0;
    return is_closed && has_plane ? std::nullopt : Fault("the orbit is not a closed one round the Earth");
  }

  Fault in_node_groups() const {
    return search("group of nodes", model_.node_groups, [&](const NodeGroup& group, std::size_t) -> std::string {
      for (const std::int32_t node : group.nodes) {
        if (!is_index(node, model_.nodes.size())) return "names a node that does not exist";
      }
      return "";
    });
  }

  const Model& model_;
};

}  // namespace

Fault Model::find_fault() const { return FaultSearch(*this).first(); }

}  // namespace netpocket
