#pragma once
// The control loops of a run, as data: what a loop controls, and which channels of the run tell what it does. Panels
// and figures of loops need nothing else, whatever the kind of the capture system.

#include <cstdint>
#include <string>
#include <vector>

namespace netpocket {

// Values of the channel ControlLoopInfo::state.
enum class LoopState : std::uint8_t {
  waiting,  // for its phase
  active,
  over,   // its phase is over, or its task is done
  off,    // it never acts
  jammed  // it has failed and does nothing
};

// Names of channels; none where the loop has no such quantity. A vector has three, in the order x, y, z.
struct ControlLoopInfo {
  std::string name;      // unique in the run: "Tow"
  std::string acts_on;   // "spacecraft", "closing rope 3"
  std::string quantity;  // that it controls: "speed"
  std::string table;     // of its parameters in the scenario: "controller.0", "winch"; empty: it has none
  std::vector<std::string> state = {};
  std::vector<std::string> set_point = {}, actual = {};
  std::vector<std::string> error = {};  // none: actual minus set point
  std::vector<std::string> commanded = {}, delivered = {};
  std::vector<std::string> load = {};  // part of the limit that is asked for; 1 or more: saturated; none: no limit
  std::vector<std::string> disturbance = {};  // estimate of an observer

  bool operator==(const ControlLoopInfo&) const = default;
};

// A quantity of a loop and what it is called. Code that treats all of them alike goes through kLoopQuantities.
struct LoopQuantity {
  const char* name;  // "set_point"
  const char* words;
  std::vector<std::string> ControlLoopInfo::*channels;
};

inline constexpr LoopQuantity kLoopQuantities[] = {
    {"state", "state: 0 waiting, 1 active, 2 over, 3 off, 4 jammed", &ControlLoopInfo::state},
    {"set_point", "set point", &ControlLoopInfo::set_point},
    {"actual", "actual value", &ControlLoopInfo::actual},
    {"error", "error", &ControlLoopInfo::error},
    {"commanded", "commanded force or torque", &ControlLoopInfo::commanded},
    {"delivered", "delivered force or torque", &ControlLoopInfo::delivered},
    {"load", "part of the limit that is asked for", &ControlLoopInfo::load},
    {"disturbance", "estimated disturbance", &ControlLoopInfo::disturbance},
};

}  // namespace netpocket
