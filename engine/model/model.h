#pragma once
// A mechanical model of cables, rigid bodies and joints. It describes what is simulated and holds no state of a run. It
// can describe any net, rope or beam frame, with or without a pocket. SI units, world frame. A value type.
//
// Coordinates. Every node has a position. Every gradient (dr/dp, with the material coordinate p in metres) belongs to
// one node. A node may carry several gradients: one for each thread through it. Elements share positions and gradients
// by index, so knots need no constraint equations.
//
// Speed. Elements are computed eight at a time. Number the nodes, gradients and elements of repeated parts so that the
// index of the part runs fastest (node = local * parts + part). Then the kernels read eight parts without gathering.

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/ancf/cable_section.h"
#include "engine/bodies/shape.h"
#include "engine/orbit/reference_orbit.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

enum class Support : std::uint8_t {
  free,
  fixed,  // does not move
  body    // moves with a rigid body: a position as a point fixed to it, a gradient as a direction fixed to it
};

struct ModelNode {
  Eigen::Vector3d position;                            // m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s
  double point_mass = 0;                               // kg, in addition to the elements' mass
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
  std::int32_t copy_of = -1;  // the gradient that this is a copy of (sector_model.h); -1: of none
};

// A round cord or tube.
struct CableMaterial {
  CableSection section;
  double radius = 0;          // m, outer, for contact and drawing
  double youngs_modulus = 0;  // Pa, for the contact stiffness
  double poisson_ratio = 0;
  // Inflated tube: moment (N m) beyond which its wall wrinkles (ancf/wrinkling.h). Infinite: none. A run can change it.
  double wrinkling_moment = std::numeric_limits<double>::infinity();
  bool is_tube = false;  // whether the wall may wrinkle at any time of a run
};

struct ModelElement {
  std::int32_t node1, gradient1, node2, gradient2;
  double length;  // m, material length
  std::int32_t material;
  std::int32_t group = 0;  // index into Model::element_groups
  std::int32_t thread = 0;
  // Adjacent element of its thread with which it shares its axial strain (ancf/strain_pair.h); -1: none. Both must have
  // the same length and the same material, which carries full compression, and each must be the strain partner of the
  // other. The full evaluation ignores strain partners.
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

// Two bodies that move as one until a run releases the second (CableSystem::release). At the start they must move so.
// They never touch each other.
struct BodyLock {
  std::int32_t carrier, carried;  // bodies
};

// Elastic joint between two gradients of one node. It keeps `gradient2` at the rest angle to `gradient1` by the moment
// M = stiffness * angle + damping * rate. The angle is that between gradient2 and gradient1 rotated by `rest_rotation`.
// The axes of this rotation move with `body` (-1: world axes), which receives the balance of moments. So the plane of a
// kink is kept although a cable element has no torsion.
struct Hinge {
  std::int32_t gradient1, gradient2;
  Eigen::Matrix3d rest_rotation;
  std::int32_t body = -1;
  double stiffness;  // N m/rad
  double damping;    // N m s/rad
};

// Line without mass between two nodes. It pulls and never pushes: with the distance d between the nodes its tension is
// max(stiffness (d - length) + damping dd/dt, 0) while d > length, else 0. It has no contact and is not drawn.
struct TensionLine {
  std::int32_t node1, node2;
  double length;     // m, at which it becomes taut
  double stiffness;  // N/m
  double damping;    // N s/m
};

// Contact of cables and bodies: constants of the laws in engine/contact/force_law.h.
struct ContactSettings {
  double restitution = 0.5;
  double friction = 0;
  double friction_velocity = 1e-3;  // m/s
  double edge_radius = 0;           // m, of boxes and cylinders for contact with cables (contact/contact_part.h)
  bool cords = false;               // whether cords touch each other
  bool bodies = false;              // whether rigid bodies touch each other
};

struct RopeMotion {
  double length = 0;        // m, material between the retractors
  double rate = 0;          // m/s
  double acceleration = 0;  // m/s^2

  bool operator==(const RopeMotion&) const = default;
};

// A chain of elements whose material is wound in or out by retractors at its end nodes. Its inner nodes stay evenly
// spaced along the material. The mass of wound-up material is added to the end nodes. The length is state: a rope keeps
// its rate and acceleration until a run winds it otherwise (CableSystem::wind).
struct VariableRope {
  std::vector<std::int32_t> elements;  // indices into Model::elements, from one end to the other
  RopeMotion motion;                   // at the start
  double share_at_start = 0.5;         // fraction of the winding done by the retractor at the first node
};

// A rope without mass that runs through rings, with friction there (dynamics/ropes/ring_flow.h). Retractors at its two
// end nodes wind it, as a VariableRope, but its material moves from ring to ring as the tensions want. It has no
// contact. A node group with the look of a rope lets it be drawn.
struct RingRope {
  std::vector<std::int32_t> nodes;  // its ends and, in between, the rings in their order
  std::vector<double> lengths;      // m, natural, of the parts between nodes at the start
  double stiffness = 0;             // EA, N
  double damping = 0;               // c of EA (eps + c epsdot), s
  double friction = 0;              // coefficient at the rings
  double extra_angle = 0;           // rad, by which it wraps each ring besides its turn there
  double drag = 1e-3;               // N s/m, of rope that slides through a ring, besides friction; positive
  double least_part = 0.01;         // m, of rope that stays between two rings
  double share_at_start = 0.5;      // fraction of the winding done by the retractor at the first node
  RopeMotion motion = {};           // at the start; its length is the sum of `lengths`
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
  std::vector<BodyLock> locks;  // of which no two have a body in common
  std::vector<Hinge> hinges;
  std::vector<TensionLine> lines;
  std::vector<VariableRope> ropes;
  std::vector<RingRope> ring_ropes;  // a run numbers its ropes through: first `ropes`, then these
  ContactSettings contact;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // m/s^2
  // The orbit of the world's origin: its tide acts on everything (orbit/reference_orbit.h). None: no tide.
  std::optional<Orbit> orbit;

  // Each add function returns the index of what it added.
  std::int32_t add_node(const Eigen::Vector3d& position);
  std::int32_t add_gradient(std::int32_t node, const Eigen::Vector3d& value);
  std::int32_t add_material(const CableMaterial& material);
  std::int32_t add_element(const ModelElement& element);
  // Makes two elements strain partners of each other.
  void pair(std::int32_t first, std::int32_t second);
  std::int32_t add_thread(const std::string& name);
  std::int32_t add_body(const ModelBody& body);

  // Adds a straight, unstrained chain of `count` elements (1 or more) from the node `begin` to the node `end`, which
  // must not coincide. Each of its nodes gets one new gradient, the end nodes as well. Returns the indices of its
  // elements.
  std::vector<std::int32_t> add_straight_cable(std::int32_t begin, std::int32_t end, int count, std::int32_t material,
                                               std::int32_t group = 0, std::int32_t thread = 0);

  void fix_node(std::int32_t node) { nodes[node].support = Support::fixed; }
  void fix_gradient(std::int32_t gradient) { gradients[gradient].support = Support::fixed; }
  void clamp_to_body(std::int32_t node, std::int32_t gradient, std::int32_t body);

  std::size_t rope_count() const { return ropes.size() + ring_ropes.size(); }
  // m, at the start, by that number.
  double rope_length(std::size_t rope) const;
  // Material of the element `index`.
  const CableMaterial& material_of(std::int32_t index) const { return materials[elements[index].material]; }
  double radius_of(std::int32_t element) const { return material_of(element).radius; }  // m
  Structure structure() const;
  // What makes the model impossible to step, one sentence that names the item: an index that does not exist, a length,
  // mass or stiffness that is missing, a number that is not finite. Nothing when it is sound.
  std::optional<std::string> find_fault() const;
  // Mass of cables and point masses, kg, without bodies.
  double cable_mass() const;
};

}  // namespace netpocket
