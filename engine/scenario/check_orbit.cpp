#include "engine/scenario/check_orbit.h"

#include <string>

#include "engine/orbit/gravity.h"

namespace netpocket {
namespace {

void add_problem(Diagnostics& problems, const char* key, const char* text) {
  problems.add({.key = key, .message = text});
}

}  // namespace

void check_orbit(const Scenario& scenario, Diagnostics& problems) {
  const OrbitParameters& orbit = scenario.orbit;
  if (!orbit.is_on()) return;
  if (!are_perpendicular(orbit.x_along, orbit.y_along)) {
    add_problem(problems, "orbit.x_along", "must be at a right angle to orbit.y_along");
  }
  if (orbit.model == OrbitModel::hill && orbit.eccentricity != 0) {
    add_problem(problems, "orbit.eccentricity", "must be 0 for the circular orbit of orbit.model \"hill\"");
  }
  if (!orbit.turns()) return;
  if (scenario.towing.mode == TowingMode::velocity) {
    add_problem(problems, "towing.mode",
                "\"velocity\" prescribes a component along the fixed Y axis, but orbit.axes is \"local\"");
  }
  if (scenario.spacecraft.station_keeping == StationKeeping::lateral) {
    add_problem(problems, "spacecraft.station_keeping",
                "\"lateral\" holds components along the fixed X and Z axes, but orbit.axes is \"local\"");
  }
}

std::optional<Orbit> orbit_of(const Scenario& scenario) {
  const OrbitParameters& given = scenario.orbit;
  if (!given.is_on()) return std::nullopt;
  const OrbitElements elements{.perigee_radius = kEarthRadius + given.altitude,
                               .eccentricity = given.eccentricity,
                               .inclination = given.inclination,
                               .argument_of_perigee = given.perigee,
                               .true_anomaly = given.anomaly};
  const auto field = static_cast<OrbitField>(static_cast<int>(given.model) - 1);
  return orbit_of(elements, field, given.x_along, given.y_along);
}

}  // namespace netpocket
