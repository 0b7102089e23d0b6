#include "engine/dynamics/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ancf/instruction_set.h"
#include "engine/ancf/shape_functions.h"
#include "engine/bodies/symmetric_algebra.h"
#include "engine/dynamics/survey_interval.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// The farthest (m) that anything may travel between two surveys of which elements are near a body.
constexpr double kLongestTravel = 0.03;
// Clearance (m) below which an element counts as near, besides what it may move until the next survey.
constexpr double kNearMargin = 0.02;
// Inflation (m) of the boxes in the broad phase.
constexpr double kBroadMargin = 0.3;
static_assert(kLongestTravel <= BroadPhase::kLeastInHand * kBroadMargin);

struct Kernels {
  contact_kernel::PointKernel points;
  contact_kernel::ForceKernel forces;
  contact_kernel::PowerKernel power;
};

const Kernels& kernels() {
  using namespace contact_kernel;
  static const Kernels chosen = {choose_variant(baseline::points, avx2::points, avx512::points),
                                 choose_variant(baseline::forces, avx2::forces, avx512::forces),
                                 choose_variant(baseline::power, avx2::power, avx512::power)};
  return chosen;
}

void copy(const Vector3d& vector, double* out) { std::copy_n(vector.data(), 3, out); }

contact_kernel::BodyMotion motion_of(const DynamicBody& body, int contacts) {
  contact_kernel::BodyMotion motion{};
  copy(body.rigid().position(), motion.position);
  copy(body.rigid().velocity(), motion.velocity);
  copy(body.rigid().angular_velocity(), motion.angular_velocity);
  motion.inverse_mass = body.inverse_mass();
  motion.inverse_inertia = body.largest_inverse_inertia();
  motion.contacts = contacts;
  return motion;
}

// Lanes without a contact read what the first one reads, and exert nothing.
void fill_idle_lanes(ContactBlock& block) {
  for (int lane = block.count; lane < kBlockSize; ++lane) {
    for (int corner = 0; corner < 4; ++corner) {
      block.weight[corner][lane] = 0;
      block.slot[corner][lane] = block.slot[corner][0];
      block.place[corner][lane] = block.place[corner][0];
    }
    for (int axis = 0; axis < 3; ++axis) {
      block.point[axis][lane] = block.point[axis][0];
      block.normal[axis][lane] = 0;
    }
    block.penetration[lane] = block.stiffness[lane] = block.damping[lane] = 0;
  }
}

}  // namespace

ContactSolver::ContactSolver(const Model& model, const SlotLayout& layout)
    : model_(model),
      layout_(layout),
      settings_(model.contact),
      damping_(restitution_damping(model.contact.restitution)),
      broad_phase_(static_cast<int>(model.elements.size()), kBroadMargin),
      motion_(model),
      body_force_(model.bodies.size(), Vector3d::Zero()) {
  const int count = settings_.samples_per_element;
  for (int i = 0; i < count; ++i) {
    const NodalWeights weights = shape((2.0 * i + 1.0 - count) / count, 1.0);
    samples_.push_back({weights[0], weights[1], weights[2], weights[3]});
  }
  points_.resize(samples_.size() * contact_kernel::kPointRows * kBlockSize);
  const std::size_t blocks = (model.elements.size() + kBlockSize - 1) / kBlockSize;
  thickest_.resize(blocks, 0.0);
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    double& thickest = thickest_[i / kBlockSize];
    thickest = std::max(thickest, model.radius_of(static_cast<std::int32_t>(i)));
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Shape& shape = model.bodies[b].shape;
    partners_.push_back({.bounding_radius = bounding_radius(shape),
                         .is_sphere = std::holds_alternative<Sphere>(shape),
                         .tracker = SurfaceTracker(shape, model.elements.size() * samples_.size()),
                         .touchable = std::vector<std::uint8_t>(blocks, 0),
                         .due = std::vector<double>(blocks, 0.0),
                         .pairs = std::vector<std::int32_t>(blocks, -1),
                         .near = {}});
    for (std::size_t i = 0; i < model.elements.size(); ++i) {
      const auto attached = [&](std::int32_t node) {
        return model.nodes[node].support == Support::body && model.nodes[node].body == static_cast<std::int32_t>(b);
      };
      if (attached(model.elements[i].node1) || attached(model.elements[i].node2)) continue;
      if (model.radius_of(static_cast<std::int32_t>(i)) <= 0) continue;
      partners_[b].touchable[i / kBlockSize] |= static_cast<std::uint8_t>(1U << i % kBlockSize);
    }
  }
}

ContactSolver::Pairs ContactSolver::make_pairs(std::int32_t block, std::int32_t body_index) const {
  Pairs pairs{};
  const ModelBody& body = model_.bodies[body_index];
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const std::int32_t element = block * kBlockSize + lane;
    if (element >= static_cast<std::int32_t>(model_.elements.size())) break;
    const CableMaterial& material = model_.material_of(element);
    const double modulus =
        effective_modulus({material.youngs_modulus, material.poisson_ratio}, {body.youngs_modulus, body.poisson_ratio});
    pairs.stiffness[lane] = hertz_stiffness(modulus, effective_radius(material.radius, contact_radius(body.shape)));
    const double tributary =
        material.section.mass_per_length * model_.elements[element].length / settings_.samples_per_element;
    pairs.mass[lane] = effective_mass(tributary, body.mass);
  }
  return pairs;
}

// The laws of a block's elements, by lane.
const NormalLaw* ContactSolver::laws(std::int32_t block, std::int32_t body, double dt) {
  std::int32_t& place = partners_[body].pairs[block];
  if (place < 0) {
    place = static_cast<std::int32_t>(pairs_.size());
    pairs_.push_back(make_pairs(block, body));
  }
  Pairs& pairs = pairs_[place];
  if (pairs.law_step != dt) {
    for (int lane = 0; lane < kBlockSize; ++lane) {
      const double stiffness = std::min(pairs.stiffness[lane], resolved_stiffness(pairs.mass[lane], dt));
      pairs.law[lane] = {stiffness, damping_ * std::sqrt(stiffness * pairs.mass[lane])};
    }
    pairs.law_step = dt;
  }
  return pairs.law;
}

// Calls function(length) for each element of a rope, m.
template <typename Function>
void ContactSolver::for_each_rope_element(const ElementBatch& batch, const Function& function) const {
  for (const VariableRope& rope : model_.ropes) {
    for (const std::int32_t element : rope.elements) {
      function(batch.block(element / kBlockSize).length[element % kBlockSize]);
    }
  }
}

// A curve whose element changes its length by d moves by no more than |d| |S_2 + S_4|/L <= |d|/4 besides.
double ContactSolver::way_since_built(const SlotVectors& coordinates, const ElementBatch& batch) const {
  double change = 0;
  std::size_t place = 0;
  for_each_rope_element(
      batch, [&](double length) { change = std::max(change, std::abs(length - built_rope_length_[place++])); });
  return motion_.way(built_coordinates_, coordinates) + 0.25 * change;
}

bool ContactSolver::update_broad_phase(const SlotVectors& coordinates, const ElementBatch& batch,
                                       const std::vector<DynamicBody>& bodies) {
  std::vector<PlacedShape> shapes;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    shapes.push_back({model_.bodies[b].shape, bodies[b].centre(), bodies[b].rigid().rotation()});
  }
  const bool is_built = built_coordinates_.size() == coordinates.size();
  if (is_built && broad_phase_.keep(way_since_built(coordinates, batch), shapes)) return true;
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(model_.elements.size());
  for (std::size_t i = 0; i < model_.elements.size(); ++i) {
    const ElementBlock& block = batch.block(static_cast<int>(i) / kBlockSize);
    const std::size_t lane = i % kBlockSize;
    boxes.push_back(curve_bounds(coordinates,
                                 {block.slot[0][lane], block.slot[1][lane], block.slot[2][lane], block.slot[3][lane]},
                                 block.length[lane], model_.radius_of(static_cast<std::int32_t>(i))));
  }
  const bool lost = !std::ranges::all_of(boxes, is_sound) || !std::ranges::all_of(bodies, [](const DynamicBody& body) {
    return is_sound(Eigen::AlignedBox3d(body.centre()));
  });
  if (lost) return false;
  broad_phase_.rebuild(boxes, shapes);
  built_coordinates_ = coordinates;
  built_rope_length_.clear();
  for_each_rope_element(batch, [&](double length) { built_rope_length_.push_back(length); });
  return true;
}

template <typename Touch>
double ContactSolver::clearance(std::int32_t block, std::int32_t body, double margin, const SlotVectors& coordinates,
                                const ElementBatch& batch, const DynamicBody& dynamic, const Touch& touch) {
  Partner& partner = partners_[body];
  const Vector3d centre = dynamic.centre();
  const double nearest_centre = kernels().points(batch.block(block), samples_.data(), samples_.size(),
                                                 coordinates.rows(), centre.data(), points_.data());
  const double bound = nearest_centre - partner.bounding_radius - thickest_[block];
  if (bound > margin) return bound;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t sample = 0; sample < samples_.size(); ++sample) {
    const double* rows = points_.data() + sample * contact_kernel::kPointRows * kBlockSize;
    for (int lane = 0; lane < kBlockSize; ++lane) {
      if ((partner.touchable[block] >> lane & 1) == 0) continue;
      const std::int32_t element = block * kBlockSize + lane;
      const double radius = model_.radius_of(element);
      const double outside = rows[3 * kBlockSize + lane] - partner.bounding_radius - radius;
      if (outside > margin || (partner.is_sphere && outside >= 0)) {
        least = std::min(least, outside);
        continue;
      }
      const Vector3d point(rows[lane], rows[kBlockSize + lane], rows[2 * kBlockSize + lane]);
      const Vector3d local = symmetric_transposed_product(dynamic.rigid().rotation(), point - centre);
      double distance = 0;
      const auto nearest =
          partner.tracker.nearest(element * samples_.size() + sample, local, margin + radius, distance);
      least = std::min(least, distance - radius);
      if (nearest && nearest->distance < radius) touch(element, lane, sample, point, *nearest);
    }
  }
  return least;
}

double ContactSolver::fastest(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const {
  double fastest = std::sqrt(velocities.squared_norms(0, layout_.node_count).maxCoeff());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double rim = bodies[b].rigid().angular_velocity().norm() * bounding_radius(model_.bodies[b].shape);
    fastest = std::max(fastest, bodies[b].rigid().velocity().norm() + rim);
  }
  return fastest;
}

void ContactSolver::survey(const SlotVectors& coordinates, const SlotVectors& velocities, const ElementBatch& batch,
                           const std::vector<DynamicBody>& bodies, double dt) {
  // Twice the present speed for what speeds up meanwhile, as far again for the other partner's motion.
  const double travel_per_step = 2 * fastest(velocities, bodies) * dt;
  steps_to_survey_ = survey_interval(travel_per_step, kLongestTravel);
  const double travel = travel_per_step * steps_to_survey_;
  if (broad_phase_.advance(travel)) {
    if (!update_broad_phase(coordinates, batch, bodies)) {
      for (Partner& partner : partners_) partner.near.clear();
      return;
    }
    broad_phase_.advance(travel);
  }
  approach_per_step_ = 2 * travel_per_step;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    update_near(static_cast<std::int32_t>(b), kNearMargin + 2 * travel, coordinates, batch, bodies[b]);
  }
}

void ContactSolver::update_near(std::int32_t body, double margin, const SlotVectors& coordinates,
                                const ElementBatch& batch, const DynamicBody& dynamic) {
  Partner& partner = partners_[body];
  partner.near.clear();
  if (!model_.bodies[body].touches_cables) return;
  std::int32_t last = -1;
  for (const int element : broad_phase_.candidates(body)) {
    const std::int32_t block = element / kBlockSize;
    if (block == last || partner.touchable[block] == 0) continue;
    last = block;
    double& due = partner.due[block];
    if (due > approach_ + margin) continue;
    due = approach_ + clearance(block, body, margin, coordinates, batch, dynamic, [](const auto&...) {});
    if (!(due > approach_ + margin)) partner.near.push_back(block);
  }
}

void ContactSolver::forget_candidates() {
  steps_to_survey_ = 0;
  approach_ = 0;
  for (Partner& partner : partners_) std::ranges::fill(partner.due, 0.0);
  broad_phase_.advance(std::numeric_limits<double>::infinity());
}

void ContactSolver::add_contact(std::int32_t body, const ElementBlock& block, std::int32_t element, std::size_t sample,
                                const Vector3d& point, const Vector3d& normal, double penetration,
                                const NormalLaw& law) {
  Partner& partner = partners_[body];
  if (partner.first == contacts_.size() || contacts_.back().count == kBlockSize) {
    contacts_.emplace_back();
    contacts_.back().body = body;
  }
  ContactBlock& contact = contacts_.back();
  const int lane = contact.count++, element_lane = element % kBlockSize;
  const contact_kernel::Sample& unit = samples_[sample];
  const double length = block.length[element_lane];
  const double weight[4] = {unit.position1, length * unit.gradient1, unit.position2, length * unit.gradient2};
  for (int corner = 0; corner < 4; ++corner) {
    contact.weight[corner][lane] = weight[corner];
    contact.slot[corner][lane] = block.slot[corner][element_lane];
  }
  for (int axis = 0; axis < 3; ++axis) {
    contact.point[axis][lane] = point[axis];
    contact.normal[axis][lane] = normal[axis];
  }
  contact.penetration[lane] = penetration;
  contact.stiffness[lane] = law.stiffness;
  contact.damping[lane] = law.damping;
  contact.element[lane] = element;
  ++partner.contacts;
}

void ContactSolver::find_contacts(std::int32_t body, const SlotVectors& coordinates, const ElementBatch& batch,
                                  const DynamicBody& dynamic, double dt) {
  Partner& partner = partners_[body];
  partner.first = contacts_.size();
  partner.contacts = 0;
  for (const std::int32_t block : partner.near) {
    if (partner.due[block] > approach_) continue;
    const auto touch = [&](std::int32_t element, int lane, std::size_t sample, const Vector3d& point,
                           const SurfacePoint& nearest) {
      const double penetration = model_.radius_of(element) - nearest.distance;
      deepest_penetration_ = std::max(deepest_penetration_, penetration);
      add_contact(body, batch.block(block), element, sample, point,
                  symmetric_product(dynamic.rigid().rotation(), nearest.normal), penetration,
                  laws(block, body, dt)[lane]);
    };
    partner.due[block] = approach_ + clearance(block, body, 0, coordinates, batch, dynamic, touch);
  }
  partner.last = contacts_.size();
}

void ContactSolver::find(const SlotVectors& coordinates, const SlotVectors& velocities, const ElementBatch& batch,
                         const std::vector<DynamicBody>& bodies, double dt, ContactedSlots& contacted) {
  if (bodies.empty()) return;
  if (steps_to_survey_ <= 0) survey(coordinates, velocities, batch, bodies, dt);
  --steps_to_survey_;
  approach_ += approach_per_step_;
  contacts_.clear();
  deepest_penetration_ = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    find_contacts(static_cast<std::int32_t>(b), coordinates, batch, bodies[b], dt);
  }
  for (ContactBlock& block : contacts_) {
    for (int lane = 0; lane < block.count; ++lane) {
      for (int corner = 0; corner < 4; ++corner) {
        block.place[corner][lane] = contacted.share(block.slot[corner][lane], block.weight[corner][lane]);
      }
    }
    fill_idle_lanes(block);
  }
}

template <typename Function>
void ContactSolver::for_each_contact(const Function& function) const {
  for (const ContactBlock& block : contacts_) {
    for (int lane = 0; lane < block.count; ++lane) function(block, lane);
  }
}

void ContactSolver::add_forces(const SlotVectors& velocities, const ContactedSlots& contacted,
                               std::span<const double> inverse_mass, const std::vector<DynamicBody>& bodies, double dt,
                               AppliedForces& applied, std::vector<Wrench>& wrenches) {
  const contact_kernel::ForceView view{velocities.rows().first,
                                       contacted.predicted_rows(),
                                       contacted.shared_weights(),
                                       inverse_mass.data(),
                                       settings_.friction,
                                       settings_.friction_velocity,
                                       dt};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    body_force_[b].setZero();
    const Partner& partner = partners_[b];
    if (partner.contacts == 0) continue;
    const std::span<ContactBlock> contacts(contacts_.data() + partner.first, partner.last - partner.first);
    kernels().forces(view, motion_of(bodies[b], partner.contacts), contacts.data(), contacts.size());
    const SectorSum<Vector3d> nothing(Vector3d::Zero());
    BodySums sums{nothing, nothing};
    for (const ContactBlock& block : contacts) {
      for (int lane = 0; lane < block.count; ++lane) {
        const Vector3d force = lane_of(block.force, lane);
        for (int i = 0; i < 4; ++i) applied.add(block.slot[i][lane], block.weight[i][lane] * force);
        sums.force.add(block.element[lane], -force);
        const Vector3d arm = lane_of(block.point, lane) - bodies[b].rigid().position();
        sums.torque.add(block.element[lane], arm.cross(-force));
      }
    }
    body_force_[b] = sums.force.total();
    wrenches[b] += Wrench{body_force_[b], sums.torque.total()};
  }
}

double ContactSolver::dissipated_power() const {
  double power = 0;
  for_each_contact([&](const ContactBlock& block, int lane) {
    power -= symmetric_dot(lane_of(block.force, lane), lane_of(block.velocity, lane));
  });
  return power;
}

double ContactSolver::dissipated_power(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const {
  double power = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Partner& partner = partners_[b];
    if (partner.contacts == 0) continue;
    power += kernels().power(velocities.rows(), motion_of(bodies[b], partner.contacts),
                             contacts_.data() + partner.first, partner.last - partner.first);
  }
  return power;
}

std::optional<ContactSolver::Depth> ContactSolver::deepest_contact() const {
  std::optional<Depth> deepest;
  for_each_contact([&](const ContactBlock& block, int lane) {
    if (deepest && deepest->penetration >= block.penetration[lane]) return;
    deepest = Depth{block.element[lane], block.body, block.penetration[lane]};
  });
  return deepest;
}

std::vector<ContactPoint> ContactSolver::contacts() const {
  std::vector<ContactPoint> result;
  for_each_contact([&](const ContactBlock& block, int lane) {
    const Vector3d force = lane_of(block.force, lane);
    if (force.squaredNorm() == 0) return;
    const double to_surface = model_.radius_of(block.element[lane]) - block.penetration[lane];
    const Vector3d surface = lane_of(block.point, lane) - to_surface * lane_of(block.normal, lane);
    result.push_back({surface, -force, block.element[lane], block.body});
  });
  return result;
}

}  // namespace netpocket
