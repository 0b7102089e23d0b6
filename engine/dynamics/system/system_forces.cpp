#include "engine/dynamics/system/system_forces.h"

#include <algorithm>
#include <set>

#include "engine/dynamics/joints/hinge_forces.h"
#include "engine/dynamics/joints/line_forces.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

// Number of blocks that a thread processes at once and whose powers it sums in sequence. Constant, so that sums do not
// depend on the number of threads.
constexpr int kForceChunk = 32;
// Largest size (bytes) of the element forces for which the rest of a step's data also fits into a processor's own cache
// (1 to 2 MB).
constexpr std::size_t kCacheForForces = 1 << 19;

struct ForceKernels {
  update_kernel::SumKernel sum;
  hinge_kernel::Kernel hinges;
};

const ForceKernels& force_kernels() {
  static const ForceKernels chosen = {NETPOCKET_VARIANT_OF(update_kernel, sum_forces),
                                      NETPOCKET_VARIANT_OF(hinge_kernel, forces)};
  return chosen;
}

// Several threads divide the elements, and meanwhile one looks for contacts: then elements come first.
std::optional<PairedElements> paired(const CableElements& elements, const CableState& state,
                                     const SystemThreads& threads) {
  if (elements.is_full() || threads.count() > 1) return std::nullopt;
  PairedElements pairs(elements.batch(), elements.batch_elements(), state.layout.size());
  return pairs.middle_count() > 0 ? std::optional(std::move(pairs)) : std::nullopt;
}

}  // namespace

SystemForces::SystemForces(const Model& model, CableElements& elements, const CableState& state,
                           const RingRopes& ring_ropes, SystemContacts& contacts, TravelledWay& travelled,
                           const SystemThreads& threads, TiedCoordinates* ties)
    : model_(model),
      elements_(elements),
      state_(state),
      ring_ropes_(ring_ropes),
      contacts_(contacts),
      travelled_(travelled),
      threads_(threads),
      ties_(ties),
      pairs_(paired(elements, state, threads)),
      assembly_(elements.batch_elements(), state.layout.size(), threads.count(),
                pairs_ ? pairs_->is_middle() : std::span<const std::uint8_t>()),
      wrinkling_(model, elements.batch_elements(), elements.is_full()),
      element_forces_(static_cast<std::size_t>(elements.batch().block_count()) * kForceRows * kBlockSize, 0.0),
      applied_(state.layout.size()),
      wrenches_(state.bodies.size()) {
  if (model.orbit) tide_.emplace(*model.orbit, elements, state);
  collect_hinges();
  applied_.set_constant(elements.constant_loads());
  for (const DynamicBody& body : state.bodies) {
    std::set<std::int32_t> blocks;
    for (const DynamicBody::Attachment& attachment : body.attachments()) {
      blocks.insert(attachment.coordinate / kBlockSize);
    }
    attached_blocks_.emplace_back(blocks.begin(), blocks.end());
  }
}

// Keeps the hinges' order and begins a new block wherever the body that keeps the hinge plane changes.
void SystemForces::collect_hinges() {
  for (const Hinge& hinge : model_.hinges) {
    if (hinges_.empty() || hinges_.back().body != hinge.body || hinges_.back().count == kBlockSize) {
      hinges_.emplace_back();
      hinges_.back().body = hinge.body;
    }
    HingeBlock& block = hinges_.back();
    // Fill the unused lanes with this hinge too. Their results are ignored.
    for (int lane = block.count; lane < kBlockSize; ++lane) {
      for (int i = 0; i < 9; ++i) block.rest_rotation[i][lane] = hinge.rest_rotation.data()[i];
      block.stiffness[lane] = hinge.stiffness;
      block.damping[lane] = hinge.damping;
      block.gradient1[lane] = state_.layout.gradient(hinge.gradient1);
      block.gradient2[lane] = state_.layout.gradient(hinge.gradient2);
    }
    ++block.count;
  }
}

void SystemForces::keep_current(double dt) {
  if (!are_current() || step_ != dt || are_waiting_) compute(dt);
}

void SystemForces::keep_for_step(double dt) {
  if (!are_current() || step_ != dt) compute(dt, !pairs_);
}

void SystemForces::compute(double dt, bool with_elements) {
  are_waiting_ = !with_elements;
  if (are_waiting_) pairs_->forget();
  const StepTimes times{.kick = 0.5 * (state_.last_step + dt), .drift = dt};
  elements_.update_ropes();
  contacts_.look_around(travelled_, dt);
  const double cord_speed = travelled_.cord_speed();
  const auto add_others = [&] {
    applied_.clear();
    for (Wrench& wrench : wrenches_) wrench = Wrench{};
    add_hinges(times.kick);
    add_lines();
    ring_ropes_.add_forces(state_.coordinates, applied_);
    wrinkling_.add_forces(state_.coordinates, applied_);
    RopeDynamics& ropes = elements_.ropes();
    if (!ropes.empty()) {
      ropes.add_flow_forces(state_.coordinates, state_.velocities, state_.last_step, times.kick, applied_);
    }
    contacts_.find(cord_speed, dt);
  };
  if (with_elements) {
    add_elements(add_others);
  } else {
    add_others();
  }
  const auto sum_forces = [this](auto blocks, double* rows) { sum(blocks, rows); };
  if (ties_ != nullptr) {
    contacts_.share_among(*ties_);
    ties_->share(sum_forces, applied_);
    ties_->begin_applied(applied_);
  }
  contacts_.add_cord_forces(times, sum_forces, applied_, wrenches_);
  if (ties_ != nullptr) {
    ties_->share_applied(applied_);
    if (!are_waiting_) lead_ties();
  }
  if (tide_) tide_->compute();
  for (std::size_t b = 0; b < wrenches_.size(); ++b) {
    add_attachments(b);
    add_gravity(b);
    if (tide_) wrenches_[b] += tide_->wrench(b);
  }
  contacts_.add_body_forces(times, wrenches_);
  version_ = state_.version;
  step_ = dt;
  ++computations_;
}

// Leaders must know what their followers bear before they move, but not before that.
void SystemForces::lead_ties() {
  ties_->lead([this](auto blocks, double* rows) { sum(blocks, rows); }, applied_);
}

template <typename Meanwhile>
void SystemForces::add_elements(const Meanwhile& meanwhile) {
  const int blocks = elements_.batch().block_count(), chunks = (blocks + kForceChunk - 1) / kForceChunk;
  chunk_power_.resize(chunks);
  const auto compute_chunks = [&](int first_chunk, int last_chunk) {
    for (int chunk = first_chunk; chunk < last_chunk; ++chunk) {
      const int first = chunk * kForceChunk, last = std::min(blocks, first + kForceChunk);
      chunk_power_[chunk] =
          elements_.forces(first, last, state_.coordinates, state_.velocities, element_forces_.data());
    }
  };
  threads_.run(chunks, compute_chunks, meanwhile);
  sum_powers();
}

void SystemForces::sum_powers() {
  element_power_ = {};
  for (const BatchPower& power : chunk_power_) {
    element_power_.dissipated += power.dissipated;
    element_power_.fed += power.fed;
  }
}

void SystemForces::add_hinges(double kick) {
  hinge_power_ = 0;
  hinge_safeguards_ = {};
  hinge_torques_.assign(wrenches_.size(), SectorSum<Eigen::Vector3d>(Eigen::Vector3d::Zero()));
  for (HingeBlock& block : hinges_) {
    hinge_kernel::Axes axes{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    if (block.body >= 0) {
      const RigidBody& body = state_.bodies[block.body].rigid();
      std::copy_n(body.rotation().data(), 9, axes.rotation);
      std::copy_n(body.angular_velocity().data(), 3, axes.angular_velocity);
    }
    force_kernels().hinges(state_.coordinates.rows(), state_.velocities.rows(), elements_.inverse_mass().data(), kick,
                           axes, block);
    for (int lane = 0; lane < block.count; ++lane) {
      applied_.add(block.gradient1[lane], lane_of(block.on_gradient1, lane));
      applied_.add(block.gradient2[lane], lane_of(block.on_gradient2, lane));
      if (block.body >= 0) hinge_torques_[block.body].add(lane, lane_of(block.torque_on_body, lane));
      hinge_power_ += block.dissipated_power[lane];
      hinge_safeguards_.limited_hinges += block.is_limited[lane] > 0 ? 1 : 0;
      hinge_safeguards_.loose_hinges += block.is_loose[lane] > 0 ? 1 : 0;
    }
  }
  for (std::size_t b = 0; b < wrenches_.size(); ++b) {
    wrenches_[b].torque += of_all_sectors({{0, 0, 0}, hinge_torques_[b].total()}, sectors()).torque;
  }
}

void SystemForces::add_lines() {
  line_power_ = 0;
  for (const TensionLine& line : model_.lines) {
    const std::int32_t first = state_.layout.position(line.node1), second = state_.layout.position(line.node2);
    const LineForces pull = line_forces(line, state_.coordinates.get(second) - state_.coordinates.get(first),
                                        state_.velocities.get(second) - state_.velocities.get(first));
    line_power_ += pull.dissipated_power;  // also where the damper takes all that the spring gives
    if (pull.tension == 0) continue;
    applied_.add(first, pull.on_node1);
    applied_.add(second, -pull.on_node1);
  }
}

// Adds the forces on a body's attachments, from elements and applied forces, to the body's wrench.
void SystemForces::add_attachments(std::size_t body) {
  const std::span<const std::int32_t> blocks = attached_blocks_[body];
  attached_forces_.resize(blocks.size() * kVectorRows * kBlockSize);
  sum(blocks, attached_forces_.data());
  SectorSum<Eigen::Vector3d> force(Eigen::Vector3d::Zero()), torque(Eigen::Vector3d::Zero());
  std::size_t place = 0;
  const DynamicBody& moving = state_.bodies[body];
  for (const DynamicBody::Attachment& attachment : moving.attachments()) {
    while (blocks[place] != attachment.coordinate / kBlockSize) ++place;
    const double* row = attached_forces_.data() + place * kVectorRows * kBlockSize + attachment.coordinate % kBlockSize;
    const Wrench wrench = moving.attachment_wrench(attachment, {row[0], row[kBlockSize], row[2 * kBlockSize]});
    force.add(attachment.coordinate, wrench.force);
    torque.add(attachment.coordinate, wrench.torque);
  }
  wrenches_[body] += of_all_sectors({force.total(), torque.total()}, sectors());
}

void SystemForces::add_gravity(std::size_t body) {
  const Eigen::Vector3d weight = model_.bodies[body].mass * model_.gravity;
  wrenches_[body].force += weight;
  wrenches_[body].torque += (state_.bodies[body].centre() - state_.bodies[body].rigid().position()).cross(weight);
}

update_kernel::UpdateView SystemForces::view() const {
  update_kernel::UpdateView view{};
  assembly_.describe(view);
  view.element_forces = element_forces_.data();
  view.exceeds_cache = element_forces_.size() * sizeof(double) > kCacheForForces;
  view.applied = applied_.rows();
  view.loaded = applied_.loaded();
  return view;
}

// Middles of pairs are the last blocks of the assembly.
update_kernel::Fastest SystemForces::move(update_kernel::UpdateView motion, update_kernel::Kernel update, double kick,
                                          double drift) {
  const int blocks = elements_.batch().block_count();
  update_kernel::Fastest fastest;
  const auto note = [&](const update_kernel::Fastest& part) {
    fastest = {larger_or_none(fastest.position, part.position), larger_or_none(fastest.gradient, part.gradient)};
  };
  chunk_power_.clear();
  for (int first = 0; first < blocks; first += kForceChunk) {
    const pair_kernel::PairSums sums =
        pairs_->move(motion, first, std::min(blocks, first + kForceChunk), kick, drift, element_forces_.data());
    chunk_power_.push_back(sums.power);
    note(sums.fastest);
  }
  sum_powers();
  are_waiting_ = false;
  if (ties_ != nullptr) lead_ties();
  motion.loaded = applied_.loaded();
  note(update(motion, 0, assembly_.block_count() - pairs_->middle_count(), kick, drift));
  unmoved_.clear();
  for (const std::int32_t block : pairs_->unmoved_middles()) unmoved_.push_back(assembly_.block(block));
  motion.blocks = unmoved_.data();
  note(update(motion, 0, static_cast<int>(unmoved_.size()), kick, drift));
  return fastest;
}

void SystemForces::sum(std::span<const std::int32_t> coordinate_blocks, double* rows) {
  if (are_waiting_) {
    pairs_->find_forces(coordinate_blocks, state_.coordinates.rows(), state_.velocities.rows(), element_forces_.data());
  }
  force_kernels().sum(view(), coordinate_blocks.data(), coordinate_blocks.size(), rows);
}

double SystemForces::with_hinge_energy(double energy) const {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  for (const Hinge& hinge : model_.hinges) {
    const Eigen::Matrix3d axes =
        hinge.body >= 0 ? state_.bodies[hinge.body].rigid().rotation() : Eigen::Matrix3d::Identity();
    energy += hinge_forces(hinge, state_.coordinates.get(state_.layout.gradient(hinge.gradient1)),
                           state_.coordinates.get(state_.layout.gradient(hinge.gradient2)), zero, zero, axes, zero)
                  .energy;
  }
  return energy;
}

double SystemForces::line_energy() const {
  double energy = 0;
  for (const TensionLine& line : model_.lines) {
    energy += line_forces(line,
                          state_.coordinates.get(state_.layout.position(line.node2)) -
                              state_.coordinates.get(state_.layout.position(line.node1)),
                          Eigen::Vector3d::Zero())
                  .energy;
  }
  return energy;
}

double SystemForces::load_work() const {
  double work = 0;
  const CoordinateVectors* loads = applied_.constant();
  for (std::int32_t coordinate = 0; loads != nullptr && coordinate < state_.layout.size(); ++coordinate) {
    work += loads->get(coordinate).dot(state_.coordinates.get(coordinate));
  }
  work *= sectors();
  for (std::size_t b = 0; b < wrenches_.size(); ++b) {
    work += model_.bodies[b].mass * model_.gravity.dot(state_.bodies[b].centre());
  }
  return work;
}

}  // namespace netpocket
