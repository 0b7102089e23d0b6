#include "engine/scenario/pocket_tether.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <variant>

#include "engine/scenario/system_parameters.h"

namespace netpocket {
namespace {

using namespace std::string_view_literals;

constexpr std::array kReleases = {"time"sv, "closed"sv};
constexpr auto kTetherAssumption = "assumption"sv;
constexpr auto kPublishedTether = "published set-up of a thrown net"sv;

template <auto Value>
ParameterValue first_value() {
  return ParameterValue(Value);
}

constexpr Limits from_to(double least, double most) { return {least, most}; }

ParameterValue value_of(const Scenario& scenario, const char* key) {
  return find_parameter(key, scenario)->get(scenario);
}

double number_of(const Scenario& scenario, const char* key) { return std::get<double>(value_of(scenario, key)); }

}  // namespace

const ParameterGroup& pocket_tether_group() {
  static const ParameterGroup group{"tether", "Tether",
                                    "A hub with the rods that the spacecraft lets go, and the line on which it tows."};
  return group;
}

std::vector<Parameter> pocket_tether_parameters() {
  std::vector<Parameter> all = {
      own_parameter("tether.attached", first_value<false>, {}, "",
                    "the rods stand on a hub, which the spacecraft lets go and tows on a tether", "user's choice"),
      own_parameter("tether.released_at", first_value<Choice{1}>, {}, "",
                    "when the spacecraft lets the hub go. time: at tether.release_time; closed: tether.release_delay "
                    "after the end of the closing",
                    "user's choice", kReleases),
      own_parameter("tether.release_time", first_value<10.0>, from_to(0, 1e5), "s", "for released_at = \"time\"",
                    kTetherAssumption),
      own_parameter("tether.release_delay", first_value<0.0>, from_to(0, 1e5), "s", "for released_at = \"closed\"",
                    kTetherAssumption),
      own_parameter("tether.length", first_value<10.0>, from_to(0.5, 1e4), "m",
                    "from the spacecraft's +y face to the hub", kTetherAssumption),
      own_parameter("tether.elements", first_value<std::int64_t{10}>, from_to(1, 1000), "", "cable elements",
                    kTetherAssumption),
      own_parameter("tether.diameter", first_value<0.004>, from_to(1e-5, 0.1), "m", "diameter", kPublishedTether),
      own_parameter("tether.density", first_value<1380.0>, from_to(1, 3e4), "kg/m^3", "density", kTetherAssumption),
      own_parameter("tether.youngs_modulus", first_value<5e9>, from_to(1e3, 1e13), "Pa", "Young's modulus",
                    "assumption: braided polyester"),
      own_parameter("tether.axial_damping", first_value<3e-5>, from_to(0, 1), "s",
                    "c of the axial force EA (eps + c epsdot)", kTetherAssumption),
      own_parameter("tether.bending_damping", first_value<1.6e-3>, from_to(0, 10), "s",
                    "c of the bending moment EI (kappa + c kappadot)", kTetherAssumption),
  };
  for (const Parameter& parameter : tether_drum_parameters()) all.push_back(parameter);
  const Parameter of_the_hub[] = {
      own_parameter("tether.hub_mass", first_value<20.0>, from_to(1e-2, 1e5), "kg",
                    "mass of the hub, a plate as wide as the rods' roots", kTetherAssumption),
      own_parameter("tether.hub_thickness", first_value<0.1>, from_to(1e-2, 10), "m", "thickness of that plate",
                    kTetherAssumption),
  };
  all.insert(all.end(), std::begin(of_the_hub), std::end(of_the_hub));
  return all;
}

PocketTether pocket_tether(const Scenario& scenario) {
  PocketTether tether{
      .attached = std::get<bool>(value_of(scenario, "tether.attached")),
      .released_at = static_cast<ReleaseEvent>(std::get<Choice>(value_of(scenario, "tether.released_at")).index),
      .release_time = number_of(scenario, "tether.release_time"),
      .release_delay = number_of(scenario, "tether.release_delay"),
      .length = number_of(scenario, "tether.length"),
      .elements = static_cast<int>(std::get<std::int64_t>(value_of(scenario, "tether.elements"))),
      .cord = {},
      .drum = tether_drum(scenario),
      .hub_mass = number_of(scenario, "tether.hub_mass"),
      .hub_thickness = number_of(scenario, "tether.hub_thickness")};
  tether.cord.diameter = number_of(scenario, "tether.diameter");
  tether.cord.density = number_of(scenario, "tether.density");
  tether.cord.youngs_modulus = number_of(scenario, "tether.youngs_modulus");
  tether.cord.poisson_ratio = scenario.net.poisson_ratio;
  tether.cord.axial_damping = number_of(scenario, "tether.axial_damping");
  tether.cord.bending_damping = number_of(scenario, "tether.bending_damping");
  tether.cord.compression = 0;
  return tether;
}

void check_pocket_tether(const Scenario& scenario, Diagnostics& problems) {
  const PocketTether tether = pocket_tether(scenario);
  if (!tether.attached) return;
  const auto add = [&](const char* key, std::string message) {
    problems.add({.key = key, .message = std::move(message)});
  };
  if (!scenario.controllers.empty()) {
    add("tether.attached", "controllers take the pocket as fixed to the spacecraft; use one or the other");
  }
  if (tether.length / tether.elements < tether.cord.diameter) {
    add("tether.elements",
        fmt::format("elements of {:.3g} m are shorter than the tether is thick", tether.length / tether.elements));
  }
  check_tether_drum(scenario, true, problems);
  // The tether starts between the face and the hub's far side.
  const double face = scenario.spacecraft.position.y() + 0.5 * scenario.spacecraft.size.y();
  const double side = scenario.rods.profile.front().y() + tether.hub_thickness;
  if (side - face < kLeastStowed || side - face > tether.length) {
    add("tether.length",
        fmt::format("a tether of {} m does not fit between the spacecraft's face at y = {:.3g} m and the hub's side at "
                    "y = {:.3g} m",
                    tether.length, face, side));
  }
}

}  // namespace netpocket
