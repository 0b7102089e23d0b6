#include "engine/dynamics/system/symmetric_sector.h"

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

// Largest deviation of a symmetric state: m and m/s of nodes and bodies, 1 and 1/s of gradients, m, m/s and m/s^2 of
// ropes.
constexpr double kStateBound = 1e-9;

bool is_axial(const Eigen::Vector3d& v, double bound = 0) {
  return std::abs(v.x()) <= bound && std::abs(v.z()) <= bound;
}

bool are_alike(const RopeMotion& a, const RopeMotion& b) {
  return std::abs(a.length - b.length) <= kStateBound && std::abs(a.rate - b.rate) <= kStateBound &&
         std::abs(a.acceleration - b.acceleration) <= kStateBound;
}

// Whether a control acts along the axis and about it only.
bool is_axial(const BodyControl& control) {
  const bool at_axis = is_axial(control.point) || control.force.isZero(0);
  const auto is_free_or_still = [](const std::optional<double>& velocity) { return velocity.value_or(0) == 0; };
  return at_axis && is_axial(control.force) && is_axial(control.spin) && is_axial(control.at_centre.force) &&
         is_axial(control.at_centre.torque) && is_free_or_still(control.velocity[0]) &&
         is_free_or_still(control.velocity[2]);
}

// The numbers of one part of a system, to be given to the same part of another.
template <typename Part>
void copy_numbers(Part& from, Part& to, void (Part::*visit)(const std::function<void(double&)>&)) {
  std::vector<double> numbers;
  (from.*visit)([&](double& number) { numbers.push_back(number); });
  std::size_t next = 0;
  (to.*visit)([&](double& number) { number = numbers[next++]; });
}

}  // namespace

SymmetricSector::SymmetricSector(System& whole, int sectors) : whole_(whole), turn_(std::max(sectors, 1)) {
  std::optional<std::string> problem;
  if (whole.elements.is_full()) problem = "only mean-strain elements are computed by sectors";
  if (!problem) problem = find_asymmetry(whole.model, sectors);
  if (problem) {
    status_.reason = *problem;
    return;
  }
  sector_ = sector_model(whole.model, sectors);
  const System::Origin origin{sector_, whole.state};
  part_ = std::make_unique<System>(Model(sector_.model), SystemOptions{}, &origin);
  if (whole.model.contact.cords) watch_.emplace(whole.model, whole.state, whole.elements, sector_);
  list_copies();
  for (const ModelBody& body : whole.model.bodies) is_round_.push_back(std::holds_alternative<Sphere>(body.shape));
  winding_.resize(whole.model.ropes.size());
  try_to_enter();
}

void SymmetricSector::list_copies() {
  const int sectors = sector_.sectors;
  const auto list = [&](const std::vector<std::int32_t>& of_whole, std::vector<Copy>& copies, std::size_t count) {
    std::vector<std::int32_t> first(count / static_cast<std::size_t>(sectors), -1);
    for (std::size_t i = 0; i < of_whole.size(); ++i) {
      if (of_whole[i] < 0) continue;
      std::int32_t& copy = first[static_cast<std::size_t>(of_whole[i] / sectors)];
      const auto turns_of = [&](std::int32_t place) { return of_whole[static_cast<std::size_t>(place)] % sectors; };
      const auto place = static_cast<std::int32_t>(i);
      if (copy < 0 || turns_of(place) < turns_of(copy)) copy = place;
    }
    for (std::size_t local = 0; local < first.size(); ++local) {
      const std::int32_t of = of_whole[static_cast<std::size_t>(first[local])];
      copies.push_back({first[local], static_cast<std::int32_t>(local), of % sectors});
    }
  };
  list(sector_.node_of, nodes_, whole_.model.nodes.size());
  list(sector_.gradient_of, gradients_, whole_.model.gradients.size());
  list(sector_.element_of, elements_, whole_.model.elements.size());
}

std::int32_t SymmetricSector::element_of(std::int32_t element) const {
  return element < 0 ? element : sector_.element_of[static_cast<std::size_t>(element)];
}

// function(index in the whole, turns from the copy).
template <typename Function>
void SymmetricSector::for_each_image(const Copy& copy, const Function& function) const {
  for (int sector = 0; sector < sector_.sectors; ++sector) {
    function(copy.local * sector_.sectors + sector, sector - copy.turns);
  }
}

void SymmetricSector::unfold(const CoordinateVectors& part, CoordinateVectors& whole) const {
  const CoordinateLayout of_part = part_->state.layout, of_whole = whole_.state.layout;
  for (const Copy& copy : nodes_) {
    const Eigen::Vector3d v = part.get(of_part.position(copy.place));
    for_each_image(copy, [&](std::int32_t node, int turns) { whole.set(of_whole.position(node), turn_(turns, v)); });
  }
  for (const Copy& copy : gradients_) {
    const Eigen::Vector3d v = part.get(of_part.gradient(copy.place));
    for_each_image(copy, [&](std::int32_t at, int turns) { whole.set(of_whole.gradient(at), turn_(turns, v)); });
  }
}

void SymmetricSector::fold(const CoordinateVectors& whole, CoordinateVectors& part) const {
  const CoordinateLayout of_part = part_->state.layout, of_whole = whole_.state.layout;
  for (const Copy& copy : nodes_) {
    part.set(of_part.position(copy.place), whole.get(of_whole.position(copy.local * sector_.sectors + copy.turns)));
  }
  for (const Copy& copy : gradients_) {
    part.set(of_part.gradient(copy.place), whole.get(of_whole.gradient(copy.local * sector_.sectors + copy.turns)));
  }
  part_->ties->follow(part);
}

Eigen::Vector3d SymmetricSector::of_node(const CoordinateVectors& vectors, std::int32_t node) const {
  const Copy& copy = nodes_[static_cast<std::size_t>(node / sector_.sectors)];
  return turn_(node % sector_.sectors - copy.turns, vectors.get(part_->state.layout.position(copy.place)));
}

Eigen::Vector3d SymmetricSector::gradient(std::int32_t gradient) const {
  const Copy& copy = gradients_[static_cast<std::size_t>(gradient / sector_.sectors)];
  return turn_(gradient % sector_.sectors - copy.turns,
               part_->state.coordinates.get(part_->state.layout.gradient(copy.place)));
}

// Whatever of the state does not depend on the sector.
void SymmetricSector::exchange(System& from, System& to) const {
  for (std::size_t b = 0; b < from.state.bodies.size(); ++b) {
    to.state.bodies[b].rigid() = from.state.bodies[b].rigid();
    to.state.bodies[b].note_exerted(from.state.bodies[b].exerted());
  }
  to.state.controls = from.state.controls;
  to.state.time = from.state.time;
  to.state.last_step = from.state.last_step;
  to.state.steps = from.state.steps;
  if (to.contacts.reference_step() != from.contacts.reference_step()) {
    to.contacts.set_reference_step(from.contacts.reference_step());
  }
  copy_numbers(from.contacts, to.contacts, &SystemContacts::visit_impulses);
  copy_numbers(from.contacts, to.contacts, &SystemContacts::visit_bodies);
  to.contacts.depths() = from.contacts.depths();
  if (to.contacts.friction() != from.contacts.friction()) to.contacts.set_friction(from.contacts.friction());
  copy_numbers(from.forces.wrinkling(), to.forces.wrinkling(), &RodWrinkling::visit_state);
  copy_numbers(from.energies, to.energies, &EnergyAccount::visit_state);
  to.safeguards = from.safeguards;
  to.forces.forget();
  to.energies.forget_audit();
}

void SymmetricSector::unfold() {
  if (!active_ || unfolded_ == part_->state.version) return;
  unfold(part_->state.coordinates, whole_.state.coordinates);
  unfold(part_->state.velocities, whole_.state.velocities);
  exchange(*part_, whole_);
  for (ContactDepth* depth : {&whole_.contacts.depths().pressed, &whole_.contacts.depths().overlapping}) {
    depth->element = element_of(depth->element);
  }
  whole_.elements.ropes().take_motions(part_->elements.ropes(), static_cast<std::size_t>(sector_.sectors), 1);
  for (const DynamicBody& body : whole_.state.bodies) {
    body.move_attachments(whole_.state.coordinates, whole_.state.velocities);
  }
  whole_.state_has_jumped();
  unfolded_ = part_->state.version;
}

void SymmetricSector::fold() {
  fold(whole_.state.coordinates, part_->state.coordinates);
  fold(whole_.state.velocities, part_->state.velocities);
  exchange(whole_, *part_);
  for (ContactDepth* depth : {&part_->contacts.depths().pressed, &part_->contacts.depths().overlapping}) {
    if (depth->element < 0) continue;
    depth->element = elements_[static_cast<std::size_t>(depth->element / sector_.sectors)].place;
  }
  part_->elements.ropes().take_motions(whole_.elements.ropes(), 1, static_cast<std::size_t>(sector_.sectors));
  part_->state_has_jumped();
  if (watch_) watch_->forget();
}

std::optional<std::string> SymmetricSector::asymmetry() const {
  const CableState& state = whole_.state;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidBody& body = state.bodies[b].rigid();
    if (is_axial(body.position(), kStateBound) && is_axial(body.velocity(), kStateBound) &&
        is_axial(body.angular_velocity(), kStateBound) && is_axial(state.controls[b]))
      continue;
    return "the " + whole_.model.bodies[b].name + " is not on the axis or does not move along it";
  }
  const auto images_agree = [&](const CoordinateVectors& vectors, const Copy& copy, std::int32_t first) {
    const Eigen::Vector3d v = vectors.get(first + copy.local * sector_.sectors + copy.turns);
    bool agree = true;
    for_each_image(copy, [&](std::int32_t index, int turns) {
      agree = agree && (vectors.get(first + index) - turn_(turns, v)).lpNorm<Eigen::Infinity>() <= kStateBound;
    });
    return agree;
  };
  for (const CoordinateVectors* vectors : {&state.coordinates, &state.velocities}) {
    for (const Copy& copy : nodes_) {
      if (!images_agree(*vectors, copy, state.layout.position(0))) return "nodes of the sectors differ";
    }
    for (const Copy& copy : gradients_) {
      if (!images_agree(*vectors, copy, state.layout.gradient(0))) return "gradients of the sectors differ";
    }
  }
  for (std::int32_t rope = 0; rope < static_cast<std::int32_t>(whole_.model.ropes.size()); ++rope) {
    const std::int32_t first = rope - rope % sector_.sectors;
    if (!are_alike(whole_.elements.ropes().motion(rope), whole_.elements.ropes().motion(first))) {
      return "ropes are wound apart";
    }
  }
  if (whole_.contacts.reference_step() != 0 && !whole_.contacts.with_bodies().are_springs_plain())
    return "springs of contacts differ";
  return std::nullopt;
}

void SymmetricSector::try_to_enter() {
  if (part_ == nullptr) return;
  if (const auto problem = asymmetry()) {
    status_ = {false, whole_.state.time, *problem};
    return;
  }
  active_ = true;
  status_ = {true, whole_.state.time, ""};
  fold();
  unfolded_ = -1;
  std::ranges::fill(winding_, std::nullopt);
}

void SymmetricSector::leave(const std::string& reason) {
  if (!active_) return;
  note_change();
  unfold();
  active_ = false;
  status_ = {false, whole_.state.time, reason};
  for (std::size_t rope = 0; rope < winding_.size(); ++rope) {
    if (winding_[rope]) whole_.elements.ropes().wind(static_cast<std::int32_t>(rope), *winding_[rope]);
    winding_[rope].reset();
  }
}

void SymmetricSector::control(std::int32_t body, const BodyControl& control) {
  if (!is_axial(control))
    leave("the " + whole_.model.bodies[static_cast<std::size_t>(body)].name +
          " is pushed across the axis or turned about another one");
}

void SymmetricSector::wind(std::int32_t rope, const RopeMotion& motion) {
  const std::int32_t first = rope - rope % sector_.sectors;
  winding_[static_cast<std::size_t>(rope)] = motion;
  const auto& of_first = winding_[static_cast<std::size_t>(first)];
  if (of_first && !are_alike(*of_first, motion)) leave("ropes are wound apart");
}

// Whether all ropes of a place in the sectors are wound or none.
bool SymmetricSector::take_winding() {
  const auto sectors = static_cast<std::size_t>(sector_.sectors);
  for (std::size_t first = 0; first < winding_.size(); first += sectors) {
    const auto given = std::count_if(winding_.begin() + static_cast<std::ptrdiff_t>(first),
                                     winding_.begin() + static_cast<std::ptrdiff_t>(first + sectors),
                                     [](const auto& motion) { return motion.has_value(); });
    if (given != 0 && given != sector_.sectors) return false;
  }
  for (std::size_t first = 0; first < winding_.size(); first += sectors) {
    if (winding_[first]) {
      part_->elements.ropes().wind(static_cast<std::int32_t>(first / sectors), *winding_[first]);
    }
  }
  return true;
}

// Why the step whose forces are known cannot be that of one sector.
std::optional<std::string> SymmetricSector::obstacle(double dt) {
  const SystemContacts& contacts = part_->contacts;
  for (std::size_t b = 0; b < is_round_.size(); ++b) {
    if (!is_round_[b] && contacts.with_bodies().touches(static_cast<std::int32_t>(b))) {
      return "cords touch the " + whole_.model.bodies[b].name + ", which is not round";
    }
  }
  if (contacts.of_bodies() != nullptr && contacts.of_bodies()->count() > 0) return "bodies touch each other";
  if (contacts.with_bodies().stops() > 0) return "a cord is stopped at its greatest depth in a body";
  if (!watch_) return std::nullopt;
  return watch_->look(part_->state, part_->elements.lengths(),
                      {contacts.last_way(), part_->travelled.cord_speed(), part_->state.last_step, dt});
}

void SymmetricSector::step(double dt, double spring_step) {
  if (!take_winding()) return leave("ropes are wound apart");
  if (part_->contacts.reference_step() != 0 && !part_->contacts.fits(spring_step)) {
    return leave("springs of contacts become stiffer");
  }
  part_->fix_contacts(dt);
  part_->forces.keep_for_step(dt);
  if (const auto reason = obstacle(dt)) return leave(*reason);
  part_->step(dt, spring_step);
  std::ranges::fill(winding_, std::nullopt);
}

void SymmetricSector::set_wrinkling_moment(std::int32_t material, double moment) {
  System& part = *part_;
  const double before = part.forces.wrinkling_energy();
  part.forces.wrinkling().set_moment(material, moment);
  part.forces.forget();
  part.energies.add_input(sector_.sectors * (part.forces.wrinkling_energy() - before));
  unfolded_ = -1;
}

// The whole system holds all numbers. If they are replaced, the sector may stand for it again only if it did then.
void SymmetricSector::visit_state(const std::function<void(double&)>& visit) {
  note_change();
  unfold();
  const std::int64_t version = whole_.state.version;
  whole_.visit_state(visit);
  double stands = active_ ? 1 : 0;
  visit(stands);
  const bool has_changed = whole_.state.version != version || (stands != 0) != active_;
  if (!has_changed) return;
  active_ = false;
  std::ranges::fill(winding_, std::nullopt);
  if (stands != 0) try_to_enter();
}

void SymmetricSector::unfold(const Snapshot& part, Snapshot& whole) const {
  whole.time = part.time;
  whole.step = part.step;
  whole.bodies = part.bodies;
  const auto count = [](std::size_t size) { return static_cast<Eigen::Index>(size); };
  whole.positions.resize(3, count(whole_.model.nodes.size()));
  whole.velocities.resizeLike(whole.positions);
  whole.gradients.resize(3, count(whole_.model.gradients.size()));
  for (const Copy& copy : nodes_) {
    const Eigen::Vector3d position = part.positions.col(copy.place), velocity = part.velocities.col(copy.place);
    for_each_image(copy, [&](std::int32_t node, int turns) {
      whole.positions.col(node) = turn_(turns, position);
      whole.velocities.col(node) = turn_(turns, velocity);
    });
  }
  for (const Copy& copy : gradients_) {
    const Eigen::Vector3d value = part.gradients.col(copy.place);
    for_each_image(copy, [&](std::int32_t index, int turns) { whole.gradients.col(index) = turn_(turns, value); });
  }
  whole.tension.resize(count(whole_.model.elements.size()));
  whole.strain.resizeLike(whole.tension);
  for (const Copy& copy : elements_) {
    for_each_image(copy, [&](std::int32_t element, int) {
      whole.tension[element] = part.tension[copy.place];
      whole.strain[element] = part.strain[copy.place];
    });
  }
  whole.rope_element_length.clear();
  for (const double length : part.rope_element_length) {
    whole.rope_element_length.insert(whole.rope_element_length.end(), static_cast<std::size_t>(sector_.sectors),
                                     length);
  }
  whole.contacts.clear();
  for (const ContactPoint& contact : part.contacts) {
    for (int turns = 0; turns < sector_.sectors; ++turns) {
      whole.contacts.push_back({turn_(turns, contact.position), turn_(turns, contact.force),
                                element_of(contact.element) + turns, contact.body});
    }
  }
}

}  // namespace netpocket
