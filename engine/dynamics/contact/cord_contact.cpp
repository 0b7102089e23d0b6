#include "engine/dynamics/contact/cord_contact.h"

#include <algorithm>
#include <cmath>

#include "engine/bodies/segment_distance.h"
#include "engine/dynamics/contact/cord_chain.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// Smallest distance of two cords' axes within a step, as a fraction of the sum of the radii.
constexpr double kFloor = 0.25;
// Friction of nearly parallel cords across their axes fades below this sine of the angle between them, because it would
// need moments that grow like 1/sine.
constexpr double kLeastSine = 0.1;

// A spring yields beyond the depth of an impact at this speed (m/s): its energy is spent.
constexpr double kDeepImpact = 10;

ElementWeights difference(const ElementWeights& a, const ElementWeights& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

Segment segment_of(const CordPolyline::Vertices& vertices, std::int32_t segment) {
  const auto i = static_cast<std::size_t>(segment);
  return {vertices[i], vertices[i + 1]};
}

// Fractions of the nearest points, independent of the order of the segments. The mean of the two results is a minimiser
// too, because the set of minimisers is convex.
std::array<double, 2> nearest_fractions(const Segment& a, const Segment& b) {
  const SegmentDistance forward = closest_points(a, b), backward = closest_points(b, a);
  return {0.5 * (forward.first_fraction + backward.second_fraction),
          0.5 * (forward.second_fraction + backward.first_fraction)};
}

}  // namespace

CordContact::CordContact(const Model& model, const CoordinateLayout& layout, const CoordinateVectors& coordinates,
                         std::span<const double> inverse_mass)
    : model_(model),
      settings_(model.contact),
      damping_(restitution_damping(model.contact.restitution)),
      polyline_(model, layout),
      pairs_(model, polyline_, coordinates, inverse_mass),
      search_(model, polyline_, pairs_),
      next_(next_elements(model)) {
  previous_ = previous_elements(next_);
}

// Whether the point at `fraction` of one of the two capsules is a nearest point of its whole cord. An end of a capsule
// belongs to the capsule that begins there, and is a nearest point only if the capsule before does not come nearer.
// `separation`: vector from the other cord's point to this one.
bool CordContact::is_least(const NearSegments& near, bool second, double fraction, const Vector3d& separation,
                           const CoordinateVectors& coordinates, const std::vector<double>& element_length) const {
  if (fraction > 0 && fraction < 1) return true;
  const auto place = static_cast<std::size_t>(second ? near.second : near.first);
  const auto element = static_cast<std::size_t>(search_.near_elements()[place]);
  const std::int32_t segment = second ? near.second_segment : near.first_segment;
  if (fraction >= 1) return segment + 1 == CordPolyline::kSegments && next_[element] < 0;
  const CordPolyline::Vertices& own = vertices_[place];
  if (segment > 0) {
    const auto i = static_cast<std::size_t>(segment);
    return symmetric_dot(separation, own[i - 1] - own[i]) >= 0;
  }
  const std::int32_t previous = previous_[element];
  if (previous < 0) return true;
  const Vector3d before = polyline_.vertex(coordinates, element_length[static_cast<std::size_t>(previous)], previous,
                                           CordPolyline::kSegments - 1);
  return symmetric_dot(separation, before - own.front()) >= 0;
}

double CordContact::material_stiffness(std::int32_t first, std::int32_t second) const {
  const CableMaterial &a = model_.material_of(first), &b = model_.material_of(second);
  const double modulus = effective_modulus({a.youngs_modulus, a.poisson_ratio}, {b.youngs_modulus, b.poisson_ratio});
  return hertz_stiffness(modulus, effective_radius(a.radius, b.radius));
}

CordContact::Side CordContact::make_side(std::int32_t element, std::int32_t segment, double fraction,
                                         double length) const {
  Side side{};
  side.element = element;
  side.coordinate = polyline_.indices(element);
  side.end = {polyline_.weights(segment, length), polyline_.weights(segment + 1, length)};
  for (std::size_t i = 0; i < 4; ++i) side.point[i] = (1 - fraction) * side.end[0][i] + fraction * side.end[1][i];
  side.fraction = fraction;
  side.radius = model_.radius_of(element);
  return side;
}

// Adds a contact if the two capsules overlap or may have to be stopped within the step.
void CordContact::test(const NearSegments& near, const CoordinateVectors& coordinates,
                       const std::vector<double>& element_length) {
  const std::int32_t first = search_.near_elements()[static_cast<std::size_t>(near.first)];
  const std::int32_t second = search_.near_elements()[static_cast<std::size_t>(near.second)];
  const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
  const Segment one = segment_of(vertices_[static_cast<std::size_t>(near.first)], near.first_segment);
  const Segment other = segment_of(vertices_[static_cast<std::size_t>(near.second)], near.second_segment);
  const double reach = model_.radius_of(first) + model_.radius_of(second);
  const double farthest = std::max(reach, kFloor * reach + ahead_);
  if (closest_points(one, other).distance > farthest) return;
  const auto [f, g] = nearest_fractions(one, other);
  const Vector3d separation = (one.start + f * (one.end - one.start)) - (other.start + g * (other.end - other.start));
  const double distance = symmetric_norm(separation);
  if (!(distance > 0) || distance > farthest) return;
  if (!is_least(near, false, f, separation, coordinates, element_length) ||
      !is_least(near, true, g, -separation, coordinates, element_length)) {
    return;
  }
  Contact contact{};
  contact.side = {make_side(first, near.first_segment, f, element_length[a]),
                  make_side(second, near.second_segment, g, element_length[b])};
  contact.normal = separation / distance;
  contact.distance = distance;
  contact.reach = reach;
  for (auto& [side, segment] : {std::pair<Side&, const Segment&>{contact.side[0], one}, {contact.side[1], other}}) {
    const Vector3d axis = segment.end - segment.start;
    side.length = std::max(symmetric_norm(axis), side.radius);  // a capsule shorter than its radius has no direction
    const Vector3d direction = axis / side.length;
    side.tangent = direction - symmetric_dot(direction, contact.normal) * contact.normal;
  }
  const double mass = effective_mass(model_.material_of(first).section.mass_per_length * element_length[a],
                                     model_.material_of(second).section.mass_per_length * element_length[b]);
  contact.stiffness = std::min(material_stiffness(first, second), resolved_stiffness(mass, reference_step_));
  contact.deepest = depth_of_impact(mass, contact.stiffness, kDeepImpact);
  contacts_.push_back(contact);
}

template <typename Vectors>
CordContact::Velocities CordContact::relative_velocity(const Contact& contact, const Vectors& velocities) const {
  const auto& [a, b] = contact.side;
  return {combine(velocities, a.coordinate, a.point) - combine(velocities, b.coordinate, b.point),
          {combine(velocities, a.coordinate, difference(a.end[0], a.end[1])),
           combine(velocities, b.coordinate, difference(b.end[0], b.end[1]))}};
}

template <typename Function>
void CordContact::for_each_corner(const Function& function) const {
  for (std::size_t corner = 0; corner < 4; ++corner) {
    for (const NearSide& side : search_.sides()) {
      const std::int32_t index = contact_of_near_[static_cast<std::size_t>(side.pair)];
      if (index < 0) continue;
      function(contacts_[static_cast<std::size_t>(index)].side[side.second ? 1 : 0], corner);
    }
  }
}

// The factor 4 is 2 for two approaching cords, times 2 for acceleration.
double CordContact::reach_ahead(double cord_speed, double dt) const {
  constexpr double kGrowingWay = 4;
  return std::min(kGrowingWay * cord_speed * dt, search_.broad_margin());
}

void CordContact::look_around(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                              double cord_speed, double dt, const DividedLoop& loop) {
  ahead_ = reach_ahead(cord_speed, dt);
  search_.update(coordinates, element_length, ahead_, loop);
}

CordOffsets::Capsule CordContact::capsule_of(std::int32_t element, std::int32_t segment) const {
  constexpr std::int32_t kSegments = CordPolyline::kSegments;
  const auto index = static_cast<std::size_t>(element);
  const std::int32_t number = kSegments * element + segment;
  CordOffsets::Capsule capsule{number, number - 1, number + 1};
  if (segment == 0) capsule.before = previous_[index] < 0 ? -1 : kSegments * previous_[index] + kSegments - 1;
  if (segment == kSegments - 1) capsule.after = next_[index] < 0 ? -1 : kSegments * next_[index];
  return capsule;
}

// `entered`: depth (m) that the contact can have reached by the motion of the last step.
void CordContact::set_offset(Contact& contact, const NearSegments& near, double entered) {
  const CordOffsets::Capsule one = capsule_of(contact.side[0].element, near.first_segment);
  const CordOffsets::Capsule other = capsule_of(contact.side[1].element, near.second_segment);
  contact.place = CordOffsets::place_of(one, other);
  contact.offset = offsets_.follow(one, other, contact.overlap(), entered);
  relaxed_ += contact.offset > 0 ? 1 : 0;
}

// The next step finds a spring that yields relaxed at its present depth.
double CordContact::note_step() {
  double yielded = 0;
  offsets_.begin_step();
  for (const Contact& contact : contacts_) {
    if (!(contact.overlap() > 0)) continue;
    offsets_.note(contact.place, contact.yields() ? contact.overlap() : contact.offset);
    if (contact.yields()) yielded += contact.stored_energy();
  }
  offsets_.end_step();
  return yielded;
}

void CordContact::find(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                       const std::vector<double>& element_length, double last_step, double dt,
                       ContactedCoordinates& contacted) {
  contacts_.clear();
  relaxed_ = stops_ = 0;
  if (reference_step_ == 0) reference_step_ = dt;
  if (search_.near().empty()) return;
  vertices_.clear();
  for (const std::int32_t element : search_.near_elements()) {
    vertices_.push_back(polyline_.vertices(coordinates, element_length[static_cast<std::size_t>(element)], element));
  }
  contact_of_near_.clear();
  for (const NearSegments& near : search_.near()) {
    const std::size_t before = contacts_.size();
    test(near, coordinates, element_length);
    if (contacts_.size() > before) {
      // A contact that is still apart counts only if its approach must be stopped within the step.
      Contact& contact = contacts_.back();
      const Vector3d velocity = relative_velocity(contact, velocities).point;
      const double speed = symmetric_dot(velocity, contact.normal);
      if (contact.distance > contact.reach && contact.distance + 2 * dt * speed > kFloor * contact.reach) {
        contacts_.pop_back();
      } else {
        set_offset(contact, near, 2 * symmetric_norm(velocity) * last_step);
      }
    }
    contact_of_near_.push_back(contacts_.size() > before ? static_cast<std::int32_t>(before) : -1);
  }
  if (contacts_.empty()) return;
  for_each_corner(
      [&](const Side& side, std::size_t corner) { contacted.share(side.coordinate[corner], side.point[corner]); });
}

// Forces (N) along the two tangents t_i, on the first cord. The speeds are s_i = t_i.v plus a part from the cords'
// bending. The sliding velocity is x_1 t_1 + x_2 t_2 with G x = s, G_ij = t_i.t_j.
std::array<double, 2> CordContact::friction(const Contact& contact, const Velocities& velocity,
                                            const ContactedCoordinates& contacted, std::span<const double> inverse_mass,
                                            double axis_inverse_mass, const StepTimes& times) const {
  std::array<double, 2> speed{};
  double bending = 0;  // 1/kg, what the moments add to the inverse mass
  for (std::size_t i = 0; i < 2; ++i) {
    const Side& side = contact.side[i];
    const double lever = -contact.distance / side.length;
    speed[i] = symmetric_dot(side.tangent, velocity.point) + lever * symmetric_dot(contact.normal, velocity.spread[i]);
    const Weights spread = difference(side.end[0], side.end[1]);
    double own = contacted.inverse_mass(side.coordinate, spread, inverse_mass);
    for (std::size_t k = 0; k < 4; ++k) own += spread[k] * spread[k] * inverse_mass[side.coordinate[k]];
    bending = std::max(bending, lever * lever * own);
  }
  const Vector3d &t = contact.side[0].tangent, &u = contact.side[1].tangent;
  const double tt = symmetric_squared_norm(t) + kLeastSine * kLeastSine;
  const double uu = symmetric_squared_norm(u) + kLeastSine * kLeastSine;
  const double tu = symmetric_dot(t, u), determinant = tt * uu - tu * tu;
  const std::array<double, 2> x = {(uu * speed[0] - tu * speed[1]) / determinant,
                                   (tt * speed[1] - tu * speed[0]) / determinant};
  // determinant / trace is a lower bound of G's smaller eigenvalue.
  const double factor = times.inertia_factor();
  const double root = std::sqrt(factor * axis_inverse_mass) + std::sqrt(factor * bending * (tt + uu) / determinant);
  const double resistance = sliding_resistance(settings_.friction, settings_.friction_velocity, contact.normal_force,
                                               symmetric_norm(x[0] * t + x[1] * u), root * root, times.drift);
  return {-resistance * x[0], -resistance * x[1]};
}

void CordContact::set_forces(Contact& contact, const CoordinateVectors& velocities,
                             const ContactedCoordinates& contacted, std::span<const double> inverse_mass,
                             const StepTimes& times) {
  auto& [a, b] = contact.side;
  const double w = contacted.inverse_mass(a.coordinate, a.point, inverse_mass) +
                   contacted.inverse_mass(b.coordinate, b.point, inverse_mass);
  if (!(w > 0)) return;
  const Velocities after = relative_velocity(contact, contacted);
  const double before_speed = symmetric_dot(relative_velocity(contact, velocities).point, contact.normal);
  const double after_speed = symmetric_dot(after.point, contact.normal);
  // The law's effective mass is that of the discrete model, 1/w.
  const NormalLaw law{contact.stiffness, damping_ * std::sqrt(contact.stiffness / w)};
  const double allowed_approach = std::max(contact.distance - kFloor * contact.reach, 0.0) / times.drift;
  const double stopping = (-allowed_approach - after_speed) / (times.kick * w);
  if (!contact.yields()) {
    contact.normal_force = stepped_normal_force(law, contact.compression(), {before_speed, after_speed},
                                                times.inertia_factor() * w, times.drift);
    contact.elastic = normal_force({contact.stiffness, 0}, contact.compression(), 0);
  }
  if (stopping > contact.normal_force) {
    ++stops_;
    contact.normal_force = stopping;
  }
  if (!(contact.normal_force > 0)) return;
  const auto along = friction(contact, after, contacted, inverse_mass, w, times);
  const Vector3d force = contact.normal_force * contact.normal + (along[0] * a.tangent + along[1] * b.tangent);
  for (std::size_t i = 0; i < 2; ++i) {
    Side& side = contact.side[i];
    const Vector3d own = i == 0 ? force : Vector3d(-force);
    const Vector3d couple = (-contact.distance / side.length * along[i]) * contact.normal;
    side.force = {(1 - side.fraction) * own + couple, side.fraction * own - couple};
  }
}

void CordContact::add_forces(const CoordinateVectors& velocities, const ContactedCoordinates& contacted,
                             std::span<const double> inverse_mass, const StepTimes& times, AppliedForces& applied) {
  if (contacts_.empty()) return;
  for (Contact& contact : contacts_) set_forces(contact, velocities, contacted, inverse_mass, times);
  for_each_corner([&](const Side& side, std::size_t corner) {
    applied.add(side.coordinate[corner], side.end[0][corner] * side.force[0] + side.end[1][corner] * side.force[1]);
  });
}

double CordContact::stored_energy() const {
  double energy = 0;
  for (const Contact& contact : contacts_) {
    energy += contact.stored_energy();
  }
  return energy;
}

contact_kernel::ContactPower CordContact::dissipated_power(const CoordinateVectors& velocities) const {
  contact_kernel::ContactPower power;
  for (const Contact& contact : contacts_) {
    double total = 0;
    for (const Side& side : contact.side) {
      for (std::size_t i = 0; i < 2; ++i) {
        total -= symmetric_dot(side.force[i], combine(velocities, side.coordinate, side.end[i]));
      }
    }
    const double separation = symmetric_dot(relative_velocity(contact, velocities).point, contact.normal);
    power.damping -= (contact.normal_force - contact.elastic) * separation;
    power.friction += total + contact.normal_force * separation;
  }
  return power;
}

ContactDepth CordContact::deepest_part() const {
  ContactDepth deepest;
  const Contact* where = nullptr;
  for (const Contact& contact : contacts_) {
    const double part = contact.overlap() / contact.reach;
    if (!(part > deepest.part)) continue;
    deepest.part = part;
    where = &contact;
  }
  if (where == nullptr) return deepest;
  deepest.element = where->side[0].element;
  deepest.partner = where->side[1].element;
  deepest.stiffness = where->stiffness / material_stiffness(deepest.element, deepest.partner);
  return deepest;
}

int CordContact::count() const {
  return static_cast<int>(std::ranges::count_if(contacts_, [](const Contact& c) { return c.normal_force > 0; }));
}

double CordContact::total_normal_force() const {
  double sum = 0;
  for (const Contact& contact : contacts_) sum += contact.normal_force;
  return sum;
}

}  // namespace netpocket
