#pragma once
// Capture systems: ways to catch a target. A scenario names the kind of its system, and the run of a scenario knows
// only what is declared here. systems/pocket and systems/thrown_net hold the first two kinds.
//
// To add a kind: declare its parameters (scenario/system_parameters.h), write a function that builds the system from a
// scenario, and register both before the first scenario is read.
//
// Thread contract: registration must be over before other threads use what is declared here. The rest is constant.

#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "engine/control/controller.h"
#include "engine/model/model.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/system_parameters.h"
#include "engine/state/phase.h"

namespace netpocket {

struct SystemController {
  std::unique_ptr<Controller> controller;
  double period = 0;  // s, between its samples; 0: asked before every step
};

// A system built from a scenario, ready to be run.
struct CaptureSystem {
  Model model;
  Structure structure;           // of `model`; its channels must include common_channels of the bodies below
  std::int32_t spacecraft = -1;  // index into Model::bodies; -1: none
  std::int32_t target = -1;      // likewise
  // Number of equal sectors of the model around the y axis, numbered as model/sector_model.h says; 0: it has none.
  int sectors = 0;
  std::vector<SystemController> controllers;
  // Fills the channels that only this kind of system has. All else in the snapshot has just been captured from the
  // system. May be empty.
  std::function<void(const CableSystem& system, Snapshot& snapshot)> fill_channels;
  // Which events the run has awaited in vain until a time (s), as a part of a sentence; empty text: none. May be empty.
  std::function<std::string(double time)> awaited;
};

struct CaptureSystemKind {
  const SystemParameters* parameters = nullptr;  // must live as long as the program
  // The scenario must pass check_scenario. Throws std::runtime_error with one sentence when a file that the scenario
  // names has become unreadable since that check.
  CaptureSystem (*build)(const Scenario& scenario) = nullptr;
  // The phases of a capture by this scenario, in their order.
  std::vector<Phase> (*phases)(const Scenario& scenario) = nullptr;
};

// A kind that builds what cannot be run; one sentence.
class SystemFault : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

// Throws std::invalid_argument when a kind of this name exists.
void register_capture_system(const CaptureSystemKind& kind);

// The phases of a capture by this scenario.
std::vector<Phase> capture_phases(const Scenario& scenario);

// The kind that a scenario names. Throws std::invalid_argument when there is none.
const CaptureSystemKind& capture_system_kind(const Scenario& scenario);
// Builds the system of a scenario; errors as CaptureSystemKind::build. Throws SystemFault when the model has a fault
// (Model::find_fault) or when the kind leaves out a common channel.
CaptureSystem build_capture_system(const Scenario& scenario);

}  // namespace netpocket
