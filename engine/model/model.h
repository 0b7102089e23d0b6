#pragma once
// A mechanical model of cables, rigid bodies and joints: what is simulated, with no state of a run. Any net, rope or
// beam frame can be described, with or without a pocket. SI units, world frame.
//
// Coordinates: every node has a position; every gradient (dr/dp, p the material coordinate in metres) belongs to one
// node. A node may carry several gradients: one for each thread through it. Elements share positions and gradients by
// index, so knots need no constraint equations.
//
// Speed: elements are computed eight at a time. Number nodes, gradients and elements of repeated parts with the part's
// index running fastest (node = local * parts + part) to let eight parts be read without gathering.

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/ancf/cable_section.h"
#include "engine/bodies/shape.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

enum class Support : std::uint8_t {
  free,
  fixed,  // stays where it is
  body    // moves with a rigid body (a position as a point of it, a gradient as a direction)
};

struct ModelNode {
  Eigen::Vector3d position;                            // m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s
  double point_mass = 0;                               // kg, besides the elements' mass
  Eigen::Vector3d load = Eigen::Vector3d::Zero();      // N, constant force
  Support support = Support::free;
  std::int32_t body = -1;
};

struct ModelGradient {
  std::int32_t node;
  Eigen::Vector3d value;                           // dr/dp, dimensionless
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();  // 1/s
  Support support = Support::free;
  std::int32_t body = -1;
};

// A round cord or tube.
struct CableMaterial {
  CableSection section;
  double radius = 0;          // m, outer, for contact and drawing
  double youngs_modulus = 0;  // Pa, for the contact stiffness
  double poisson_ratio = 0;
  // Inflated tube: moment beyond which its wall wrinkles (ancf/wrinkling.h), N m. None by default; a run can change it.
  double wrinkling_moment = std::numeric_limits<double>::infinity();
  bool is_tube = false;  // whether there is a wall that may wrinkle, then or later
};

struct ModelElement {
  std::int32_t node1, gradient1, node2, gradient2;
  double length;  // m, material length
  std::int32_t material;
  std::int32_t group = 0;  // index into Model::element_groups
  std::int32_t thread = 0;
  // The next or previous element of its thread with which it shares its axial strain (ancf/strain_pair.h): of the same
  // length and material, whose compression is full, and with this one as its strain partner; -1: none. The full
  // evaluation has none.
  std::int32_t strain_partner = -1;
};

struct ModelBody {
  std::string name;
  BodyRole role = BodyRole::other;
  Shape shape;
  double mass;              // kg
  Eigen::Matrix3d inertia;  // kg m^2, body axes, about the centre of mass
  BodyState state;          // at the start
  bool touches_cables = true;
  double youngs_modulus = 70e9;  // Pa, for the contact stiffness
  double poisson_ratio = 0.33;
};

// Elastic joint between two gradients of one node: keeps `gradient2` at the rest angle to `gradient1` by a moment
// M = stiffness * angle + damping * rate, where the angle is measured between gradient2 and gradient1 turned by
// `rest_rotation`. The rotation's axes move with `body` (world axes for -1), which takes the balance of moments: this
// is what keeps the plane of a kink although a cable element has no torsion.
struct Hinge {
  std::int32_t gradient1, gradient2;
  Eigen::Matrix3d rest_rotation;
  std::int32_t body = -1;
  double stiffness;  // N m/rad
  double damping;    // N m s/rad
};

// How cables and bodies touch: law and constants of engine/contact/force_law.h.
struct ContactSettings {
  double restitution = 0.5;
  double friction = 0;
  double friction_velocity = 1e-3;  // m/s
  bool cords = false;               // cords touch each other too
  bool bodies = false;              // rigid bodies touch each other too
};

struct RopeMotion {
  double length;        // m, material between the retractors
  double rate;          // m/s
  double acceleration;  // m/s^2

  bool operator==(const RopeMotion&) const = default;
};

// A chain of elements whose material is wound in (or let out) by retractors at its end nodes. Its inner nodes stay
// evenly spread over the length. Wound-up mass joins the end nodes.
struct VariableRope {
  std::vector<std::int32_t> elements;             // indices into Model::elements, from one end to the other
  std::function<RopeMotion(double time)> motion;  // pure function of time
  double share_at_start = 0.5;                    // part of the winding done by the retractor at the first node
  std::int32_t same_motion_as = -1;               // an earlier rope with the same motion, if known: need not be asked
};

struct Model {
  std::vector<ModelNode> nodes;
  std::vector<ModelGradient> gradients;
  std::vector<CableMaterial> materials;
  std::vector<ModelElement> elements;
  std::vector<ElementGroup> element_groups = {{"cables", "a cable"}};
  std::vector<NodeGroup> node_groups;
  std::vector<std::string> threads = {"cable"};
  std::vector<ModelBody> bodies;
  std::vector<Hinge> hinges;
  std::vector<VariableRope> ropes;
  ContactSettings contact;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // m/s^2

  std::int32_t add_node(const Eigen::Vector3d& position);
  std::int32_t add_gradient(std::int32_t node, const Eigen::Vector3d& value);
  std::int32_t add_material(const CableMaterial& material);
  std::int32_t add_element(const ModelElement& element);
  // Makes two elements each other's strain partner.
  void pair(std::int32_t first, std::int32_t second);
  std::int32_t add_thread(const std::string& name);
  std::int32_t add_body(const ModelBody& body);

  // A straight chain of `count` elements from the node `begin` to the node `end`, at its natural length, one gradient
  // per node (the first and the last are new gradients of the end nodes). Returns the indices of its elements.
  std::vector<std::int32_t> add_straight_cable(std::int32_t begin, std::int32_t end, int count, std::int32_t material,
                                               std::int32_t group = 0, std::int32_t thread = 0);

  void fix_node(std::int32_t node) { nodes[node].support = Support::fixed; }
  void fix_gradient(std::int32_t gradient) { gradients[gradient].support = Support::fixed; }
  void clamp_to_body(std::int32_t node, std::int32_t gradient, std::int32_t body);

  // Material that element `index` is made of.
  const CableMaterial& material_of(std::int32_t index) const { return materials[elements[index].material]; }
  double radius_of(std::int32_t element) const { return material_of(element).radius; }  // m
  Structure structure() const;
  // Mass of cables and point masses, kg.
  double cable_mass() const;
};

}  // namespace netpocket
