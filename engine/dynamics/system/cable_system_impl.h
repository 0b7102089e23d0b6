#pragma once
// What a CableSystem consists of. Internal to this room.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/dynamics/assembly/tied_coordinates.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/element_states.h"
#include "engine/dynamics/system/energy_account.h"
#include "engine/dynamics/system/leapfrog.h"
#include "engine/dynamics/system/system_contacts.h"
#include "engine/dynamics/system/system_forces.h"
#include "engine/dynamics/system/system_threads.h"
#include "engine/dynamics/system/travelled_way.h"

namespace netpocket {

class SymmetricSector;

// Step (s) for forces that are needed before the first step.
inline constexpr double kStepBeforeFirst = 1e-4;

// The parts of a system. Each refers to those before it.
struct CableSystem::Impl {
  // What a system that is one sector of another needs to know of it.
  struct Origin {
    const SectorModel& sector;
    const CableState& whole;
  };

  static CableState sector_state(const Model& model, std::span<const double> mass, const Origin& origin);

  Impl(Model&& source, const SystemOptions& options, const Origin* origin = nullptr);
  ~Impl();

  void begin_account();
  void fix_contacts(double dt);
  void fit_contacts(double dt, double spring_step);
  void step(double dt, double spring_step);
  void step_locked(LockedBodies& lock, double kick, double dt);
  void step_bodies(double kick, double dt);
  void keep_forces_current() { forces.keep_current(state.last_step > 0 ? state.last_step : kStepBeforeFirst); }
  void state_has_jumped();
  void visit_state(const std::function<void(double&)>& visit);
  bool looks_sound() const;
  EnergyAudit audit();
  EnergyAudit capture(Snapshot& snapshot);
  // What steps at present: this system, or the sector that stands for it.
  Impl& running();
  // Goes on with the whole system, if a sector has stood for it.
  void leave_symmetry(const std::string& reason);
  // Index into Model::ring_ropes of what a run numbers as `rope`; nothing if it is one of Model::ropes.
  std::optional<std::size_t> ring_rope(std::int32_t rope) const {
    const auto index = static_cast<std::size_t>(rope);
    return index < model.ropes.size() ? std::nullopt : std::optional(index - model.ropes.size());
  }
  std::string contact_of(std::int32_t element) const;

  Model model;
  SystemThreads threads;
  std::optional<TiedCoordinates> ties;  // of a system that is one sector
  CableElements elements;
  CableState state;
  ElementStates element_states;
  TravelledWay travelled;
  RingRopes ring_ropes;
  SystemContacts contacts;
  SystemForces forces;
  Leapfrog integrator;
  EnergyAccount energies;
  SafeguardCounts safeguards;
  std::unique_ptr<SymmetricSector> sector;  // may stand for this system; null: never
};

}  // namespace netpocket
