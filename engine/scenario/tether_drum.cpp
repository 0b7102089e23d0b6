#include "engine/scenario/tether_drum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include "engine/scenario/system_parameters.h"

namespace netpocket {
namespace {

using namespace std::string_view_literals;

constexpr std::array kDrumDrives = {"brake"sv, "rate"sv, "tension"sv, "drag"sv};
constexpr std::array kDrumEvents = {"time"sv, "contact"sv, "closed"sv};
constexpr auto kDrumAssumption = "assumption"sv;
constexpr auto kDrumChoice = "user's choice"sv;

template <auto Value>
ParameterValue at_first() {
  return ParameterValue(Value);
}

constexpr Limits between(double least, double most) { return {least, most}; }

ParameterValue drum_value(const Scenario& scenario, std::string_view key) {
  return find_parameter(key, scenario)->get(scenario);
}
double drum_number(const Scenario& scenario, std::string_view key) {
  return std::get<double>(drum_value(scenario, key));
}
int drum_choice(const Scenario& scenario, std::string_view key) {
  return std::get<Choice>(drum_value(scenario, key)).index;
}

}  // namespace

std::vector<Parameter> tether_drum_parameters() {
  return {
      own_parameter("tether.winch", at_first<false>, {}, "",
                    "the tether is wound by a drum on the spacecraft; it is then a straight line without inertia, and "
                    "half of its mass stays at either end",
                    kDrumChoice),
      own_parameter("tether.drive", at_first<Choice{0}>, {}, "",
                    "brake: the drum is held, but for its clutch; rate: pays out by tether.rate; tension: keeps "
                    "tether.tension; drag: a light brake lets it run out where the tension exceeds tether.tension",
                    kDrumChoice, kDrumDrives),
      own_parameter("tether.rate", at_first<0.0>, between(-100, 100), "m/s", "for drive = \"rate\"; negative: reels in",
                    kDrumAssumption),
      own_parameter("tether.tension", at_first<10.0>, between(0, 1e5), "N", "for drive = \"tension\" and \"drag\"",
                    kDrumAssumption),
      own_parameter("tether.drive_starts_at", at_first<Choice{0}>, {}, "",
                    "when the drive begins; the drum is braked before. time: at tether.drive_delay; contact: that long "
                    "after the first touch of the target; closed: that long after the end of the closing",
                    kDrumChoice, kDrumEvents),
      own_parameter("tether.drive_delay", at_first<0.0>, between(0, 1e5), "s",
                    "from that event; for \"time\" from the start of the run", kDrumAssumption),
      own_parameter("tether.slip_tension", at_first<50.0>, between(0, 1e6), "N",
                    "tension at which the drum's clutch slips, braked or driven", kDrumAssumption),
      own_parameter("tether.brake_starts_at", at_first<Choice{0}>, {}, "",
                    "from when on the drum is braked for good. time: from tether.brake_at; contact: tether.brake_delay "
                    "after the first touch of the target; closed: that long after the end of the closing",
                    kDrumChoice, kDrumEvents),
      own_parameter("tether.brake_at", at_first<1e5>, between(0, 1e5), "s", "from when on the drum is braked for good",
                    kDrumAssumption),
      own_parameter("tether.brake_delay", at_first<0.0>, between(0, 1e5), "s",
                    "for brake_starts_at = \"contact\" and \"closed\"", kDrumAssumption),
      own_parameter("tether.drum_radius", at_first<0.1>, between(1e-3, 10), "m", "radius of the drum", kDrumAssumption),
      own_parameter("tether.drum_inertia", at_first<0.01>, between(1e-6, 1e4), "kg m^2",
                    "moment of inertia of all that turns with the drum", kDrumAssumption),
      own_parameter("tether.motor_torque", at_first<10.0>, between(0, 1e5), "N m", "largest torque of its motor",
                    kDrumAssumption),
      own_parameter("tether.fastest", at_first<1.0>, between(0, 100), "m/s", "largest rate that its motor aims at",
                    kDrumAssumption),
      own_parameter("tether.reserve", at_first<20.0>, between(0, 1e4), "m",
                    "tether on the drum at the start, besides tether.length", kDrumAssumption),
      own_parameter("tether.least_length", at_first<0.5>, between(0.01, 1e4), "m", "at which the drum stops reeling in",
                    kDrumAssumption),
  };
}

TetherDrum tether_drum(const Scenario& scenario) {
  const auto number = [&](std::string_view key) { return drum_number(scenario, key); };
  return {.attached = std::get<bool>(drum_value(scenario, "tether.winch")),
          .drive = static_cast<TetherDrive>(drum_choice(scenario, "tether.drive")),
          .rate = number("tether.rate"),
          .tension = number("tether.tension"),
          .slip_tension = number("tether.slip_tension"),
          .drive_event = static_cast<DrumEvent>(drum_choice(scenario, "tether.drive_starts_at")),
          .drive_delay = number("tether.drive_delay"),
          .brake_event = static_cast<DrumEvent>(drum_choice(scenario, "tether.brake_starts_at")),
          .brake_at = number("tether.brake_at"),
          .brake_delay = number("tether.brake_delay"),
          .radius = number("tether.drum_radius"),
          .inertia = number("tether.drum_inertia"),
          .motor_torque = number("tether.motor_torque"),
          .fastest = number("tether.fastest"),
          .length = number("tether.length"),
          .reserve = number("tether.reserve"),
          .least_length = number("tether.least_length")};
}

bool drum_acts_at_once(std::string_view key) {
  constexpr std::array kOfTheRun = {"tether.drive"sv,           "tether.rate"sv,        "tether.tension"sv,
                                    "tether.drive_starts_at"sv, "tether.drive_delay"sv, "tether.slip_tension"sv,
                                    "tether.brake_starts_at"sv, "tether.brake_at"sv,    "tether.brake_delay"sv,
                                    "tether.motor_torque"sv,    "tether.fastest"sv};
  return std::ranges::find(kOfTheRun, key) != kOfTheRun.end();
}

void check_tether_drum(const Scenario& scenario, bool closes, Diagnostics& problems) {
  const TetherDrum drum = tether_drum(scenario);
  if (!drum.attached) return;
  if (drum.least_length > drum.length) {
    problems.add({.key = "tether.least_length",
                  .message = fmt::format("{} m are more than the tether.length of {} m at the start", drum.least_length,
                                         drum.length)});
  }
  if (closes) return;
  for (const auto& [key, event] :
       {std::pair("tether.drive_starts_at", drum.drive_event), std::pair("tether.brake_starts_at", drum.brake_event)}) {
    if (event != DrumEvent::closed) continue;
    problems.add({.key = key, .message = "without a drawstring the net is never closed; use \"time\" or \"contact\""});
  }
}

}  // namespace netpocket
