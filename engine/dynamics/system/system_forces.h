#pragma once
// All forces of a system at its present state: elements, hinges, lines, wrinkling, ropes, contacts, gravity, the tide
// and loads.
// Internal to this room.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/assembly.h"
#include "engine/dynamics/assembly/paired_elements.h"
#include "engine/dynamics/assembly/safeguards.h"
#include "engine/dynamics/assembly/update_kernel.h"
#include "engine/dynamics/joints/hinge_kernel.h"
#include "engine/dynamics/joints/rod_wrinkling.h"
#include "engine/dynamics/ropes/ring_ropes.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/system_contacts.h"
#include "engine/dynamics/system/system_threads.h"
#include "engine/dynamics/system/tidal_field.h"
#include "engine/dynamics/system/travelled_way.h"
#include "engine/math/sector_sum.h"

namespace netpocket {

class SystemForces {
 public:
  // All must outlive this object.
  SystemForces(const Model& model, CableElements& elements, const CableState& state, const RingRopes& ring_ropes,
               SystemContacts& contacts, TravelledWay& travelled, const SystemThreads& threads,
               TiedCoordinates* ties = nullptr);

  // Computes the forces for a next step of `dt` (s): always, or unless they are known for this state and step. Forces
  // computed for a snapshot are kept, so that the next step need not compute them again.
  void compute(double dt) { compute(dt, true); }
  void keep_current(double dt);
  // The same for a step that follows at once. Most forces of elements may then wait for that step's move().
  void keep_for_step(double dt);
  // To be called when anything but the state has changed that forces depend on.
  void forget() { version_ = -1; }
  // Whether forces are known for the present state, and a number that differs for each computation.
  bool are_current() const { return version_ == state_.version; }
  std::int64_t computations() const { return computations_; }

  // On bodies, about the centre of mass with their attachments.
  const std::vector<Wrench>& wrenches() const { return wrenches_; }
  // On coordinates, as the update kernels take them. Masses and state are not set.
  update_kernel::UpdateView view() const;
  int block_count() const { return assembly_.block_count(); }
  // What acts on free coordinates as an acceleration besides these forces; null: nothing. Its part on bodies is among
  // the wrenches.
  const TidalField* tide() const { return tide_ ? &*tide_ : nullptr; }
  // Whether forces of elements still wait. Then move() computes them and moves all coordinates of `motion`, which is
  // the view with masses and state: v += kick M^-1 F, x += drift v. Only then is element_power() known. Returns the
  // largest speeds.
  bool are_waiting() const { return are_waiting_; }
  update_kernel::Fastest move(update_kernel::UpdateView motion, update_kernel::Kernel update, double kick,
                              double drift);

  // Powers (W) at the present state: of the elements; of the dampers of hinges and of lines.
  const BatchPower& element_power() const { return element_power_; }
  double hinge_power() const { return hinge_power_; }
  double line_power() const { return line_power_; }
  // Counts of the hinges' safeguards in the present forces.
  const SafeguardCounts& hinge_safeguards() const { return hinge_safeguards_; }

  RodWrinkling& wrinkling() { return wrinkling_; }
  double wrinkling_energy() const { return wrinkling_.energy(state_.coordinates); }  // J
  // `energy` (J) plus that of the hinges.
  double with_hinge_energy(double energy) const;
  double line_energy() const;  // J
  // Work (J) of gravity and constant loads, up to an additive constant. Of all sectors.
  double load_work() const;

 private:
  void compute(double dt, bool with_elements);
  void collect_hinges();
  void sum_powers();
  void lead_ties();
  template <typename Meanwhile>
  void add_elements(const Meanwhile& meanwhile);
  void add_hinges(double kick);
  void add_lines();
  void add_attachments(std::size_t body);
  void add_gravity(std::size_t body);
  void sum(std::span<const std::int32_t> coordinate_blocks, double* rows);
  int sectors() const { return ties_ != nullptr ? ties_->sectors() : 1; }

  const Model& model_;
  CableElements& elements_;
  const CableState& state_;
  const RingRopes& ring_ropes_;
  SystemContacts& contacts_;
  TravelledWay& travelled_;
  const SystemThreads& threads_;
  TiedCoordinates* ties_;  // of a model that is one sector; null: none

  std::optional<PairedElements> pairs_;  // where they are moved as their forces are computed
  Assembly assembly_;
  AlignedVector<HingeBlock> hinges_;
  RodWrinkling wrinkling_;
  AlignedVector<double> element_forces_;
  AppliedForces applied_;  // all forces but those of elements
  std::vector<Wrench> wrenches_;
  std::optional<TidalField> tide_;
  std::vector<std::vector<std::int32_t>>
      attached_blocks_;                    // by body: blocks of coordinates that hold its attachments, ascending
  AlignedVector<double> attached_forces_;  // on the attached blocks of one body
  BatchPower element_power_;
  std::vector<BatchPower> chunk_power_;
  double hinge_power_ = 0, line_power_ = 0;
  SafeguardCounts hinge_safeguards_;
  std::vector<SectorSum<Eigen::Vector3d>> hinge_torques_;  // N m, by body
  std::int64_t version_ = -1;                              // of the state that forces are for
  double step_ = 0;                                        // s, step that forces are for
  std::int64_t computations_ = 0;
  bool are_waiting_ = false;
  std::vector<update_kernel::CoordinateBlock> unmoved_;  // middles of pairs that are moved one by one
};

}  // namespace netpocket
