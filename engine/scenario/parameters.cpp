#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "engine/scenario/control_table.h"
#include "engine/scenario/parameter_row.h"
#include "engine/scenario/shared_parameters.h"

namespace netpocket {

using namespace std::string_view_literals;

namespace parameter_rows {

template <>
constexpr std::array kNames<TargetShape> = {"sphere"sv, "box"sv, "cylinder"sv, "satellite"sv, "mesh"sv};
template <>
constexpr std::array kNames<MeshUnit> = {"m"sv, "cm"sv, "mm"sv, "inch"sv, "foot"sv};
template <>
constexpr std::array kNames<InertiaSource> = {"given"sv, "shape"sv};
template <>
constexpr std::array kNames<ClosingLaw> = {"cycloid"sv, "quintic"sv, "trapezoid"sv, "linear"sv, "table"sv};
template <>
constexpr std::array kNames<TowingMode> = {"none"sv, "force"sv, "acceleration"sv, "velocity"sv, "controlled"sv};
template <>
constexpr std::array kNames<StationKeeping> = {"free"sv, "attitude"sv, "lateral"sv};
template <>
constexpr std::array kNames<Evaluation> = {"mean_strain"sv, "full"sv};
template <>
constexpr std::array kNames<Fidelity> = {"full"sv, "draft"sv};
template <>
constexpr std::array kNames<Symmetry> = {"off"sv, "auto"sv};
template <>
constexpr std::array kNames<ClosingStart> = {"time"sv, "target_inside"sv, "distance"sv};
template <>
constexpr std::array kNames<TowingStart> = {"time"sv, "closed"sv};
template <>
constexpr std::array kNames<OrbitModel> = {"off"sv, "hill"sv, "two_body"sv, "two_body_j2"sv};
template <>
constexpr std::array kNames<OrbitAxes> = {"fixed"sv, "local"sv};
template <>
constexpr std::array kNames<LocalAxis> = {"v_bar"sv, "-v_bar"sv, "r_bar"sv, "-r_bar"sv, "h_bar"sv, "-h_bar"sv};

}  // namespace parameter_rows

namespace {

using namespace parameter_rows;

ParameterValue read_system(const Scenario& scenario, const Parameter& parameter) {
  const auto found = std::ranges::find(parameter.choices, scenario.system);
  if (found == parameter.choices.end()) throw std::invalid_argument("no kind of capture system is " + scenario.system);
  return Choice{static_cast<int>(found - parameter.choices.begin())};
}

void write_system(Scenario& scenario, const Parameter& parameter, const ParameterValue& value) {
  scenario.system = parameter.choices[static_cast<std::size_t>(std::get<Choice>(value).index)];
}

// The kinds of capture systems. The table of each kind gets the names of all.
constexpr Parameter kind_of_system(std::string_view key, std::string_view help, std::string_view source) {
  return {.key = key,
          .type = ParameterType::choice,
          .limits = {},
          .unit = "",
          .help = help,
          .source = source,
          .choices = {},
          .read = read_system,
          .write = write_system};
}

using S = Scenario;
constexpr auto kPocket = &S::pocket;
constexpr auto kNet = &S::net;
constexpr auto kRope = &S::rope;
constexpr auto kRods = &S::rods;
constexpr auto kSpacecraft = &S::spacecraft;
constexpr auto kTarget = &S::target;
constexpr auto kContact = &S::contact;
constexpr auto kClosing = &S::closing;
constexpr auto kTowing = &S::towing;
constexpr auto kOrbit = &S::orbit;
constexpr auto kSolver = &S::solver;
constexpr auto kOutput = &S::output;
using Pocket = PocketParameters;
using Cord = CordParameters;
using Rod = RodParameters;
using Spacecraft = SpacecraftParameters;
using Target = TargetParameters;
using Contact = ContactParameters;
using Closing = ClosingParameters;
using Towing = TowingParameters;
using OfOrbit = OrbitParameters;
using Solver = SolverParameters;
using Output = OutputParameters;

constexpr auto kTable1 = "paper, Table 1"sv;
constexpr auto kTable2 = "paper, Table 2"sv;
constexpr auto kModulusSource = "paper, Table 2, printed without unit, taken as GPa"sv;
constexpr auto kRopeSource = "assumption: as the net"sv;

constexpr std::array kGroups = {
    ParameterGroup{"", "Scenario", "What the scenario is called, and what kind of system it describes."},
    ParameterGroup{"pocket", "Pocket", "Rods and meshes of the netted pocket."},
    ParameterGroup{"net", "Net cords", "Material of the net's cords."},
    ParameterGroup{"rope", "Closing ropes", "Material of the ropes between adjacent rod tips."},
    ParameterGroup{"rods", "Rods", "Shape, section and material of the inflatable rods."},
    ParameterGroup{"spacecraft", "Spacecraft", "The service spacecraft; the rods' roots are clamped to it."},
    ParameterGroup{"target", "Target", "The body to be captured."},
    ParameterGroup{
        "contact", "Contact",
        "Contact of cords, ropes and rods with target and spacecraft and among themselves, and of these two."},
    ParameterGroup{"closing", "Closing", "How the retractors at the rod tips draw the mouth together."},
    ParameterGroup{"towing", "Towing", "How the spacecraft pulls the captured target towards -Y."},
    ParameterGroup{"orbit", "Orbit",
                   "The orbit of the world's origin, whose gravity acts on everything near it as a tide."},
    ParameterGroup{"solver", "Solver", "Evaluation of the elements and integration in time."},
    ParameterGroup{"output", "Output", "Length of the run and what is recorded."},
};

// clang-format off
constexpr std::array kParameters = {
    parameter<&S::name>("name", within(1, 100), "", "name of the scenario, on figures and in tables; default: the file's name", "user's choice"),
    parameter<&S::description>("description", within(0, 2000), "", "what the scenario shows", "user's choice"),
    kind_of_system("system", "kind of capture system; it decides which tables a scenario has", "user's choice"),

    parameter<kPocket, &Pocket::rod_count>("pocket.rod_count", within(3, 64), "", "rods, on a regular polygon", "paper, section 2"),
    parameter<kPocket, &Pocket::mesh_columns>("pocket.mesh_columns", within(1, 100), "", "cells across a panel at the kink; also rows of its triangular part", kAssumption),
    parameter<kPocket, &Pocket::mesh_rows>("pocket.mesh_rows", within(1, 100), "", "rows of the square part of a panel, from kink to tip", kAssumption),
    parameter<kPocket, &Pocket::elements_per_side>("pocket.elements_per_side", within(1, 20), "", "cable elements on a side of a mesh", kAssumption),
    parameter<kPocket, &Pocket::bow>("pocket.bow", within(0, 0.05), "", "rise of a mesh side at its middle, part of its length: no cord is straight; 0 leaves it to round-off how cords buckle", "assumption: sensitivity to imperfections, Koiter 1945"),

    parameter<kNet, &Cord::diameter>("net.diameter", within(1e-5, 0.1), "m", "diameter of a cord", kTable2),
    parameter<kNet, &Cord::density>("net.density", within(1, 3e4), "kg/m^3", "density", kTable2),
    parameter<kNet, &Cord::youngs_modulus>("net.youngs_modulus", within(1e3, 1e13), "Pa", "Young's modulus", kModulusSource),
    parameter<kNet, &Cord::poisson_ratio>("net.poisson_ratio", above(-1, 0.5), "", "Poisson's ratio, for the contact stiffness", kTable2),
    parameter<kNet, &Cord::axial_damping>("net.axial_damping", within(0, 1), "s", "c of the axial force EA (eps + c epsdot)", kAssumption),
    parameter<kNet, &Cord::bending_damping>("net.bending_damping", within(0, 10), "s", "c of the bending moment EI (kappa + c kappadot)", "assumption: about the loss of stranded rope"),
    parameter<kNet, &Cord::compression>("net.compression", within(0, 1), "", "fraction of EA that acts in compression; 0: tension only", "paper, Eq. 11: no difference between tension and compression"),

    parameter<kRope, &Cord::diameter>("rope.diameter", within(1e-5, 0.1), "m", "diameter of a rope", kRopeSource),
    parameter<kRope, &Cord::density>("rope.density", within(1, 3e4), "kg/m^3", "density", kRopeSource),
    parameter<kRope, &Cord::youngs_modulus>("rope.youngs_modulus", within(1e3, 1e13), "Pa", "Young's modulus", kRopeSource),
    parameter<kRope, &Cord::poisson_ratio>("rope.poisson_ratio", above(-1, 0.5), "", "Poisson's ratio, for the contact stiffness", kRopeSource),
    parameter<kRope, &Cord::axial_damping>("rope.axial_damping", within(0, 1), "s", "c of the axial force EA (eps + c epsdot)", kRopeSource),
    parameter<kRope, &Cord::bending_damping>("rope.bending_damping", within(0, 10), "s", "c of the bending moment EI (kappa + c kappadot)", kRopeSource),
    parameter<kRope, &Cord::compression>("rope.compression", within(0, 1), "", "fraction of EA that acts in compression; 0: tension only", kRopeSource),

    parameter<kRods, &Rod::profile>("rods.profile", within(0, 1000), "m, m", "[distance from the axis, height y] of root, kink and tip of a rod", "tip: paper, section 2, diameter 15.12 m, depth 12 m; root and kink: assumption"),
    parameter<kRods, &Rod::outer_diameter>("rods.outer_diameter", within(1e-3, 10), "m", "outer diameter", "paper, section 2; Table 2 prints 0.01 m"),
    parameter<kRods, &Rod::wall_lower>("rods.wall_lower", within(1e-5, 5), "m", "thickness of the wall from root to kink; half the outer diameter: solid", kAssumption),
    parameter<kRods, &Rod::wall_upper>("rods.wall_upper", within(1e-5, 5), "m", "thickness of the wall from kink to tip; half the outer diameter: solid", kAssumption),
    parameter<kRods, &Rod::density>("rods.density", within(1, 3e4), "kg/m^3", "density of the wall", kTable2),
    parameter<kRods, &Rod::youngs_modulus>("rods.youngs_modulus", within(1e3, 1e13), "Pa", "Young's modulus of the wall", kModulusSource),
    parameter<kRods, &Rod::poisson_ratio>("rods.poisson_ratio", above(-1, 0.5), "", "Poisson's ratio, for the contact stiffness", kTable2),
    parameter<kRods, &Rod::axial_damping>("rods.axial_damping", within(0, 1), "s", "c of the axial force EA (eps + c epsdot)", kAssumption),
    parameter<kRods, &Rod::bending_damping>("rods.bending_damping", within(0, 10), "s", "c of the bending moment EI (kappa + c kappadot)", kAssumption),
    parameter<kRods, &Rod::elements_per_side>("rods.elements_per_side", within(0, 64), "", "elements of a rod between two rows of the net; 0: as pocket.elements_per_side", kAssumption),
    parameter<kRods, &Rod::pressure>("rods.pressure", within(0, 1e8), "Pa", "pressure of the gas inside, beyond whose wrinkling moment pi p r^3/2 a rod softens; 0: does not wrinkle", "assumption; law: Comer & Levy 1963"),
    parameter<kRods, &Rod::hinge_stiffness>("rods.hinge_stiffness", within(0, 1e9), "N m/rad", "stiffness of the joint at the kink", kAssumption),
    parameter<kRods, &Rod::hinge_damping>("rods.hinge_damping", within(0, 1e6), "N m s/rad", "damping of the joint at the kink", kAssumption),
    parameter<kRods, &Rod::tip_mass>("rods.tip_mass", within(0, 1e4), "kg", "mass of the retractor at each rod tip", kAssumption),

    parameter<kSpacecraft, &Spacecraft::mass>("spacecraft.mass", within(1e-3, 1e7), "kg", "mass", kTable1),
    parameter<kSpacecraft, &Spacecraft::inertia>("spacecraft.inertia", within(1e-6, 1e10), "kg m^2", "principal moments of inertia about the centre of mass, body axes", kTable1),
    parameter<kSpacecraft, &Spacecraft::position>("spacecraft.position", within(-1e4, 1e4), "m", "centre of mass at the start", "paper, section 4.2"),
    parameter<kSpacecraft, &Spacecraft::size>("spacecraft.size", within(1e-2, 1e3), "m", "edges of the bus, a box about the centre of mass", kAssumption),
    parameter<kSpacecraft, &Spacecraft::station_keeping>("spacecraft.station_keeping", kNone, "", "free: nothing held; attitude: attitude held; lateral: attitude, x and z held", kAssumption),

    parameter<kTarget, &Target::shape>("target.shape", kNone, "", "shape", kAssumption),
    parameter<kTarget, &Target::radius>("target.radius", within(1e-2, 1e3), "m", "radius of a sphere or cylinder", kAssumption),
    parameter<kTarget, &Target::size>("target.size", within(1e-2, 1e3), "m", "edges of a box or of a satellite's bus", kAssumption),
    parameter<kTarget, &Target::length>("target.length", within(1e-2, 1e3), "m", "length of a cylinder, along its y axis", kAssumption),
    parameter<kTarget, &Target::span>("target.span", within(1e-2, 1e3), "m", "length of a satellite from tip to tip of its solar panels, along its x axis", kAssumption),
    parameter<kTarget, &Target::panel_width>("target.panel_width", within(1e-2, 1e3), "m", "width of a satellite's solar panels, along its y axis", kAssumption),
    parameter<kTarget, &Target::dish_diameter>("target.dish_diameter", within(1e-2, 1e3), "m", "diameter of a satellite's dish, at the +y side of its bus", kAssumption),
    parameter<kTarget, &Target::mesh_file>("target.mesh_file", within(0, 1000), "", "mesh: STL or OBJ file in the scenario's folder or below; its centre of mass becomes the body's", "user's choice"),
    parameter<kTarget, &Target::mesh_unit>("target.mesh_unit", kNone, "", "mesh: unit of the file's coordinates", kAssumption),
    parameter<kTarget, &Target::mass>("target.mass", within(1e-3, 1e7), "kg", "mass", kTable1),
    parameter<kTarget, &Target::inertia>("target.inertia", within(1e-6, 1e10), "kg m^2", "principal moments of inertia about the centre of mass, body axes", kTable1),
    parameter<kTarget, &Target::inertia_from>("target.inertia_from", kNone, "", "given: target.inertia; shape: that of the shape filled evenly with the mass", kAssumption),
    parameter<kTarget, &Target::position>("target.position", within(-1e4, 1e4), "m", "centre of mass at the start", "paper, section 4.2"),
    parameter<kTarget, &Target::attitude>("target.attitude", within(-10, 10), "rad", "rotation vector that turns the world axes into the body axes at the start", kAssumption),
    parameter<kTarget, &Target::velocity>("target.velocity", within(-100, 100), "m/s", "velocity of the centre of mass at the start", "paper, section 4.2: at rest"),
    parameter<kTarget, &Target::spin>("target.spin", within(-100, 100), "rad/s", "angular velocity at the start, world axes", "paper, section 4.2: at rest"),
    parameter<kTarget, &Target::thrust>("target.thrust", within(-1e5, 1e5), "N", "thrust of its own through the centre of mass, body axes", kAssumption),
    parameter<kTarget, &Target::torque>("target.torque", within(-1e6, 1e6), "N m", "torque of its own, body axes", kAssumption),
    parameter<kTarget, &Target::acts_from>("target.acts_from", within(0, 1e5), "s", "time at which thrust and torque of its own begin", kAssumption),
    parameter<kTarget, &Target::acts_until>("target.acts_until", within(0, 1e5), "s", "time at which they end", kAssumption),
    parameter<kTarget, &Target::youngs_modulus>("target.youngs_modulus", within(1e3, 1e13), "Pa", "Young's modulus, for the contact stiffness", "assumption: aluminium"),
    parameter<kTarget, &Target::poisson_ratio>("target.poisson_ratio", above(-1, 0.5), "", "Poisson's ratio, for the contact stiffness", "assumption: aluminium"),

    parameter<kContact, &Contact::restitution>("contact.restitution", within(0, 1), "", "Newton's coefficient of restitution c_r of the paper's section 3.3", kAssumption),
    parameter<kContact, &Contact::friction>("contact.friction", within(0, 10), "", "Coulomb's coefficient of friction mu of the paper's section 3.3", kAssumption),
    parameter<kContact, &Contact::friction_velocity>("contact.friction_velocity", within(1e-6, 1), "m/s", "sliding speed at which friction is fully developed", kAssumption),
    parameter<kContact, &Contact::edge_radius>("contact.edge_radius", within(0, 1), "m", "radius of the edges of boxes, cylinders and satellites where cords touch them, at most a quarter of a part's thickness; 0: sharp. A cord that a load presses deeper than its own radius slips off a sharp edge", kAssumption),
    parameter<kContact, &Contact::spacecraft>("contact.spacecraft", kNone, "", "cords touch the spacecraft too", kAssumption),
    parameter<kContact, &Contact::cords>("contact.cords", kNone, "", "net, closing ropes and rods touch each other; false: they pass through each other", kAssumption),
    parameter<kContact, &Contact::bodies>("contact.bodies", kNone, "", "target and spacecraft touch each other; false: they pass through each other", kAssumption),

    parameter<kClosing, &Closing::law>("closing.law", kNone, "", "how the rope length goes from open to closed; table: as closing.table says", kAssumption),
    parameter<kClosing, &Closing::starts_at>("closing.starts_at", kNone, "", "what starts the closing: the time closing.start; the target's centre being inside the pocket; spacecraft and target being within closing.distance", kAssumption),
    parameter<kClosing, &Closing::start>("closing.start", within(0, 1e5), "s", "time at which closing starts, or before which no event starts it", "paper, section 4.2"),
    parameter<kClosing, &Closing::distance>("closing.distance", within(1e-3, 1e4), "m", "distance between the centres of mass of spacecraft and target that starts the closing, for starts_at distance", kAssumption),
    parameter<kClosing, &Closing::duration>("closing.duration", within(1e-2, 1e5), "s", "time from open to closed; not used by the law table", "paper, section 4.2, case 1; 7.5 s in case 2, 5 s in case 3"),
    parameter<kClosing, &Closing::closed_length>("closing.closed_length", within(1e-3, 1e3), "m", "rope between adjacent rod tips when closed; not used by the law table", "paper, section 4.1"),
    parameter<kClosing, &Closing::table>("closing.table", within(0, 1e5), "s, m", "[time after start, rope length] from open to closed, for the law table; may pay out again, up to the open length", "user's choice"),
    parameter<kClosing, &Closing::elements>("closing.elements", within(1, 64), "", "variable-length elements in each rope", kAssumption),

    parameter<kTowing, &Towing::mode>("towing.mode", kNone, "", "none; force on the spacecraft; acceleration: force per mass of spacecraft, pocket and target; velocity of the spacecraft; controlled: by a controller of the kind tow", kAssumption),
    parameter<kTowing, &Towing::starts_at>("towing.starts_at", kNone, "", "what starts the towing: the time towing.start, or the end of the closing", kAssumption),
    parameter<kTowing, &Towing::start>("towing.start", within(0, 1e5), "s", "time at which towing starts, for starts_at time", "paper, section 4.2"),
    parameter<kTowing, &Towing::duration>("towing.duration", within(1e-3, 1e5), "s", "length of the thrust or of the ramp", kAssumption),
    parameter<kTowing, &Towing::size>("towing.size", within(0, 1e5), "N, m/s^2 or m/s by mode", "size of the force, acceleration or velocity, towards -Y", kAssumption),
    parameter<kTowing, &Towing::offset>("towing.offset", within(-100, 100), "m", "distance of the line of thrust from the axis", kAssumption),
    parameter<kTowing, &Towing::offset_angle>("towing.offset_angle", within(-10, 10), "rad", "direction in which the line of thrust is off the axis, from +X towards +Z; along an axis the pocket keeps a plane of symmetry", kAssumption),
    parameter<kTowing, &Towing::abort_force>("towing.abort_force", within(0, 1e9), "N", "force of the pocket on the target that ends the towing; 0: none does", kAssumption),

    parameter<kOrbit, &OfOrbit::model>("orbit.model", kNone, "", "off: far from all gravity; hill: circular orbit, after Hill, Clohessy and Wiltshire; two_body: any orbit about a point mass; two_body_j2: likewise about the oblate Earth", kChoice),
    parameter<kOrbit, &OfOrbit::altitude>("orbit.altitude", within(1e5, 1e9), "m", "of the perigee above the equatorial radius of 6378137 m", kAssumption),
    parameter<kOrbit, &OfOrbit::eccentricity>("orbit.eccentricity", within(0, 0.95), "", "eccentricity; 0 for hill", kAssumption),
    parameter<kOrbit, &OfOrbit::inclination>("orbit.inclination", within(0, 3.15), "rad", "angle between the orbit's plane and the equator; matters to two_body_j2 only", kAssumption),
    parameter<kOrbit, &OfOrbit::perigee>("orbit.perigee", within(-10, 10), "rad", "angle from the ascending node to the perigee", kAssumption),
    parameter<kOrbit, &OfOrbit::anomaly>("orbit.anomaly", within(-10, 10), "rad", "angle from the perigee to the place at the start: the true anomaly", kAssumption),
    parameter<kOrbit, &OfOrbit::x_along>("orbit.x_along", kNone, "", "direction of the X axis at the start: v_bar ahead, r_bar to the Earth, h_bar against the orbit's angular momentum", kAssumption),
    parameter<kOrbit, &OfOrbit::y_along>("orbit.y_along", kNone, "", "direction of the Y axis at the start, along which the net is thrown or the mouth opens; at a right angle to orbit.x_along", kAssumption),
    parameter<kOrbit, &OfOrbit::axes>("orbit.axes", kNone, "", "axes in which velocities at the start, towing thrust and held attitude count: fixed, the world's, which do not turn; local, V-bar, R-bar and H-bar, which turn with the orbit", kChoice),

    parameter<kSolver, &Solver::evaluation>("solver.evaluation", kNone, "", "mean_strain: one axial strain per element, lumped mass; full: Gauss points, consistent mass", "assumption; strain and curvature of full: Gerstmayr & Shabana 2006"),
    parameter<kSolver, &Solver::pair_strains>("solver.pair_strains", kNone, "", "the elements of a mesh side share their axial strain two by two, which allows larger steps; mean_strain and cords of full compression only", "assumption; ancf/strain_pair.h"),
    parameter<kSolver, &Solver::time_step>("solver.time_step", within(0, 0.1), "s", "integration step; 0: chosen from the stiffest element and contact", kAssumption),
    parameter<kSolver, &Solver::safety>("solver.safety", above(0, 1), "", "fraction of the stable step that is used", kAssumption),
    parameter<kSolver, &Solver::gravity>("solver.gravity", within(-100, 100), "m/s^2", "gravity", "assumption: none in orbit"),
    parameter<kSolver, &Solver::perturbation>("solver.perturbation", within(0, 0.01), "m", "largest random displacement of a free node at the start", kAssumption),
    parameter<kSolver, &Solver::seed>("solver.seed", within(0, 2147483647), "", "seed of the random displacements", kAssumption),
    parameter<kSolver, &Solver::most_steps>("solver.most_steps", within(0, 2147483647), "", "number of steps after which a run ends, wherever it is; 0: no limit. For campaigns, where a capture now and then takes a thousand times as long as the others", "user's choice"),
    parameter<kSolver, &Solver::fidelity>("solver.fidelity", kNone, "", "full; draft, for maps of many captures: at most three meshes across and three rows, one element a side, axial stiffness divided by 30, in pockets of the evaluation mean_strain only. Results of a draft state its measured bias", "assumption; THEORY.md 7.4"),
    parameter<kSolver, &Solver::symmetry>("solver.symmetry", kNone, "", "auto: while all sectors of a pocket are alike and nothing acts across its axis, one sector is computed for all, in less than half the time and with the same result but for round-off; off: the whole is computed always", "user's choice"),

    parameter<kOutput, &Output::end_time>("output.end_time", within(1e-3, 1e5), "s", "simulated time at which the run ends", kAssumption),
    parameter<kOutput, &Output::frame_rate>("output.frame_rate", within(1e-2, 1e5), "1/s", "recorded frames per simulated second", kAssumption),
};
// clang-format on

}  // namespace

std::span<const Parameter> shared_parameters() {
  static const std::vector<Parameter> kAll = [] {
    std::vector<Parameter> all(kParameters.begin(), kParameters.end());
    const auto control = control_parameters();
    all.insert(all.end(), control.begin(), control.end());
    return all;
  }();
  return kAll;
}

// Those of control precede the last three.
std::span<const ParameterGroup> shared_groups() {
  static const std::vector<ParameterGroup> kAll = [] {
    std::vector<ParameterGroup> all(kGroups.begin(), kGroups.end());
    const auto control = control_groups();
    all.insert(all.end() - 3, control.begin(), control.end());
    return all;
  }();
  return kAll;
}

std::span<const ParameterList> shared_lists() { return control_lists(); }

}  // namespace netpocket
