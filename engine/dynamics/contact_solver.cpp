#include "engine/dynamics/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ancf/shape_functions.h"
#include "engine/bodies/symmetric_algebra.h"

namespace netpocket {
namespace {

// Most steps between two surveys of which elements are near a body, and the farthest (m) that anything may travel
// between them.
constexpr int kLongestSurveyInterval = 16;
constexpr double kLongestTravel = 0.03;
// Clearance (m) below which an element counts as near, besides what it may move until the next survey.
constexpr double kNearMargin = 0.02;
// Inflation (m) of the boxes in the broad phase.
constexpr double kBroadMargin = 0.3;
static_assert(kLongestTravel <= BroadPhase::kLeastInHand * kBroadMargin);

}  // namespace

ContactSolver::ContactSolver(const Model& model, const SlotLayout& layout)
    : model_(model),
      layout_(layout),
      settings_(model.contact),
      damping_(restitution_damping(model.contact.restitution)),
      broad_phase_(static_cast<int>(model.elements.size()), kBroadMargin),
      near_(model.bodies.size()),
      contacts_on_body_(model.bodies.size(), 0),
      body_force_(model.bodies.size(), Eigen::Vector3d::Zero()) {
  const int count = settings_.samples_per_element;
  for (int i = 0; i < count; ++i) {
    const NodalWeights weights = shape((2.0 * i + 1.0 - count) / count, 1.0);
    samples_.push_back({weights[0], weights[1], weights[2], weights[3]});
  }
  slots_.reserve(model.elements.size());
  radius_.reserve(model.elements.size());
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ModelElement& element = model.elements[i];
    slots_.push_back({layout.position(element.node1), layout.gradient(element.gradient1),
                      layout.position(element.node2), layout.gradient(element.gradient2)});
    radius_.push_back(model.material_of(static_cast<std::int32_t>(i)).radius);
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    std::vector<std::uint8_t> excluded(model.elements.size());
    for (std::size_t i = 0; i < model.elements.size(); ++i) {
      const ModelElement& element = model.elements[i];
      const auto attached = [&](std::int32_t node) {
        return model.nodes[node].support == Support::body && model.nodes[node].body == static_cast<std::int32_t>(b);
      };
      excluded[i] = attached(element.node1) || attached(element.node2) || radius_[i] <= 0;
    }
    due_.emplace_back(model.elements.size(), 0.0);
    trackers_.emplace_back(model.bodies[b].shape, model.elements.size() * samples_.size());
    excluded_.push_back(std::move(excluded));
    pair_of_element_.emplace_back(model.elements.size(), -1);
  }
  pairs_.resize(model.bodies.size());
}

ContactSolver::Pair ContactSolver::make_pair(std::int32_t element, std::int32_t body_index) const {
  const ModelBody& body = model_.bodies[body_index];
  const CableMaterial& material = model_.material_of(element);
  const double modulus =
      effective_modulus({material.youngs_modulus, material.poisson_ratio}, {body.youngs_modulus, body.poisson_ratio});
  const double stiffness = hertz_stiffness(modulus, effective_radius(material.radius, contact_radius(body.shape)));
  const double tributary =
      material.section.mass_per_length * model_.elements[element].length / settings_.samples_per_element;
  return {stiffness, effective_mass(tributary, body.mass)};
}

bool ContactSolver::update_broad_phase(const SlotVectors& coordinates, const std::vector<double>& element_length,
                                       const std::vector<DynamicBody>& bodies) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(slots_.size());
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    boxes.push_back(curve_bounds(coordinates, slots_[i], element_length[i], radius_[i]));
  }
  std::vector<PlacedShape> shapes;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    shapes.push_back({model_.bodies[b].shape, bodies[b].centre(), bodies[b].rigid().rotation()});
  }
  const bool lost = !std::ranges::all_of(boxes, is_sound) || !std::ranges::all_of(bodies, [](const DynamicBody& body) {
    return is_sound(Eigen::AlignedBox3d(body.centre()));
  });
  if (lost) return false;
  broad_phase_.update(boxes, shapes);
  return true;
}

// Clearance of the element's nearest contact point.
double ContactSolver::clearance(const SlotVectors& coordinates, double length, std::int32_t element, std::int32_t body,
                                const DynamicBody& dynamic, double reach) {
  const Eigen::Vector3d centre = dynamic.centre();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Eigen::Vector3d point = combine(coordinates, slots_[element], samples_[i].weights(length));
    const Eigen::Vector3d local = symmetric_transposed_product(dynamic.rigid().rotation(), point - centre);
    double distance = 0;
    trackers_[body].nearest(element * samples_.size() + i, local, reach, distance);
    least = std::min(least, distance);
  }
  return least - radius_[element];
}

void ContactSolver::survey(const SlotVectors& coordinates, const SlotVectors& velocities,
                           const std::vector<double>& element_length, const std::vector<DynamicBody>& bodies,
                           double dt) {
  double fastest = 0;
  for (std::int32_t node = 0; node < layout_.node_count; ++node) {
    fastest = std::max(fastest, velocities.get(layout_.position(node)).cwiseAbs().maxCoeff());
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double rim = bodies[b].rigid().angular_velocity().norm() * bounding_radius(model_.bodies[b].shape);
    fastest = std::max(fastest, bodies[b].rigid().velocity().norm() + rim);
  }
  // Twice the present speed for what speeds up meanwhile, as far again for the other partner's motion.
  const double travel_per_step = 2 * fastest * dt;
  steps_to_survey_ = kLongestSurveyInterval;
  if (travel_per_step * kLongestSurveyInterval > kLongestTravel) {
    steps_to_survey_ = std::max(1, static_cast<int>(kLongestTravel / travel_per_step));
  }
  const double travel = travel_per_step * steps_to_survey_;
  if (broad_phase_.advance(travel)) {
    if (!update_broad_phase(coordinates, element_length, bodies)) {
      for (std::vector<std::int32_t>& near : near_) near.clear();
      return;
    }
    broad_phase_.advance(travel);
  }
  approach_per_step_ = 2 * travel_per_step;
  const double margin = kNearMargin + 2 * travel;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    near_[b].clear();
    if (!model_.bodies[b].touches_cables) continue;
    for (const std::int32_t element : broad_phase_.candidates(static_cast<int>(b))) {
      if (excluded_[b][element]) continue;
      double& due = due_[b][element];
      if (due > approach_ + margin) continue;
      due = approach_ + clearance(coordinates, element_length[element], element, static_cast<std::int32_t>(b),
                                  bodies[b], margin + radius_[element]);
      if (!(due > approach_ + margin)) near_[b].push_back(element);
    }
  }
}

void ContactSolver::forget_candidates() {
  steps_to_survey_ = 0;
  approach_ = 0;
  for (std::vector<double>& due : due_) std::ranges::fill(due, 0.0);
  broad_phase_.advance(std::numeric_limits<double>::infinity());
}

void ContactSolver::find_contacts(const SlotVectors& coordinates, const std::vector<double>& element_length,
                                  const std::vector<DynamicBody>& bodies) {
  contacts_.clear();
  deepest_penetration_ = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Eigen::Vector3d centre = bodies[b].centre();
    const Eigen::Matrix3d& rotation = bodies[b].rigid().rotation();
    const Sphere* sphere = std::get_if<Sphere>(&model_.bodies[b].shape);
    for (const std::int32_t element : near_[b]) {
      if (due_[b][element] > approach_) continue;
      const double length = element_length[element];
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        const ElementWeights weight = samples_[i].weights(length);
        const Eigen::Vector3d point = combine(coordinates, slots_[element], weight);
        double distance = 0;
        if (sphere != nullptr) {  // most points are not that near: no need to turn into body axes
          distance = symmetric_norm(point - centre) - sphere->radius;
          least = std::min(least, distance);
          if (distance >= radius_[element]) continue;
        }
        const auto nearest =
            trackers_[b].nearest(element * samples_.size() + i, symmetric_transposed_product(rotation, point - centre),
                                 radius_[element], distance);
        least = std::min(least, distance);
        if (!nearest) continue;
        const double penetration = radius_[element] - nearest->distance;
        const Eigen::Vector3d normal = symmetric_product(rotation, nearest->normal);
        contacts_.push_back({.element = element,
                             .body = static_cast<std::int32_t>(b),
                             .slot = slots_[element],
                             .weight = weight,
                             .point = point,
                             .normal = normal,
                             .penetration = penetration});
        deepest_penetration_ = std::max(deepest_penetration_, penetration);
      }
      due_[b][element] = approach_ + (least - radius_[element]);
    }
  }
}

void ContactSolver::find(const SlotVectors& coordinates, const SlotVectors& velocities,
                         const std::vector<double>& element_length, const std::vector<DynamicBody>& bodies, double dt,
                         ContactedSlots& contacted) {
  if (bodies.empty()) return;
  if (steps_to_survey_ <= 0) survey(coordinates, velocities, element_length, bodies, dt);
  --steps_to_survey_;
  approach_ += approach_per_step_;
  find_contacts(coordinates, element_length, bodies);
  std::ranges::fill(contacts_on_body_, 0);
  for (const Contact& contact : contacts_) {
    ++contacts_on_body_[contact.body];
    for (std::size_t i = 0; i < 4; ++i) contacted.share(contact.slot[i], contact.weight[i]);
  }
}

Eigen::Vector3d ContactSolver::relative_velocity(const Contact& contact, const SlotVectors& velocities,
                                                 const DynamicBody& body) const {
  return combine(velocities, contact.slot, contact.weight) - body.rigid().velocity_at(contact.point);
}

const NormalLaw& ContactSolver::law(const Contact& contact, double dt) {
  std::vector<Pair>& pairs = pairs_[contact.body];
  std::int32_t& place = pair_of_element_[contact.body][contact.element];
  if (place < 0) {
    place = static_cast<std::int32_t>(pairs.size());
    pairs.push_back(make_pair(contact.element, contact.body));
  }
  Pair& pair = pairs[place];
  if (pair.law_step != dt) {
    const double stiffness = std::min(pair.stiffness, resolved_stiffness(pair.mass, dt));
    pair.law = {stiffness, damping_ * std::sqrt(stiffness * pair.mass)};
    pair.law_step = dt;
  }
  return pair.law;
}

void ContactSolver::set_force(Contact& contact, const SlotVectors& velocities, const ContactedSlots& contacted,
                              std::span<const double> inverse_mass, const DynamicBody& body, double dt) {
  const double cable_inverse_mass = contacted.inverse_mass(contact.slot, contact.weight, inverse_mass);
  const double arm = symmetric_norm(contact.point - body.rigid().position());
  const double w = cable_inverse_mass + contacts_on_body_[contact.body] * body.inverse_mass_bound(arm);
  contact.velocity = relative_velocity(contact, velocities, body);
  const Eigen::Vector3d after = relative_velocity(contact, contacted.predicted(), body);
  const double separation_speed = symmetric_dot(after, contact.normal);
  const double normal_force =
      stepped_normal_force(law(contact, dt), contact.penetration,
                           {symmetric_dot(contact.velocity, contact.normal), separation_speed}, w, dt);
  const Eigen::Vector3d sliding = after - separation_speed * contact.normal;
  const double resistance =
      sliding_resistance(settings_.friction, settings_.friction_velocity, normal_force, symmetric_norm(sliding), w, dt);
  contact.force = normal_force * contact.normal - resistance * sliding;
}

void ContactSolver::add_forces(const SlotVectors& velocities, const ContactedSlots& contacted,
                               std::span<const double> inverse_mass, const std::vector<DynamicBody>& bodies, double dt,
                               SlotVectors& applied, std::vector<Wrench>& wrenches) {
  const SectorSum<Eigen::Vector3d> nothing(Eigen::Vector3d::Zero());
  sums_.assign(contacts_.empty() ? 0 : bodies.size(), {nothing, nothing});
  for (Contact& contact : contacts_) {
    const DynamicBody& body = bodies[contact.body];
    set_force(contact, velocities, contacted, inverse_mass, body, dt);
    for (int i = 0; i < 4; ++i) applied.add(contact.slot[i], contact.weight[i] * contact.force);
    auto& [force, torque] = sums_[contact.body];
    force.add(contact.element, -contact.force);
    torque.add(contact.element, (contact.point - body.rigid().position()).cross(-contact.force));
  }
  std::ranges::fill(body_force_, Eigen::Vector3d::Zero());
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    body_force_[b] = sums_[b].force.total();
    wrenches[b] += Wrench{body_force_[b], sums_[b].torque.total()};
  }
}

double ContactSolver::dissipated_power() const {
  double power = 0;
  for (const Contact& contact : contacts_) power -= symmetric_dot(contact.force, contact.velocity);
  return power;
}

double ContactSolver::dissipated_power(const SlotVectors& velocities, const std::vector<DynamicBody>& bodies) const {
  double power = 0;
  for (const Contact& contact : contacts_) {
    power -= symmetric_dot(contact.force, relative_velocity(contact, velocities, bodies[contact.body]));
  }
  return power;
}

std::vector<ContactPoint> ContactSolver::contacts() const {
  std::vector<ContactPoint> result;
  for (const Contact& contact : contacts_) {
    if (contact.force.squaredNorm() == 0) continue;
    const Eigen::Vector3d surface = contact.point - (radius_[contact.element] - contact.penetration) * contact.normal;
    result.push_back({surface, -contact.force, contact.element, contact.body});
  }
  return result;
}

}  // namespace netpocket
