#include "engine/scenario/thrown_net_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/math/elementary.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/system_parameters.h"
#include "engine/scenario/tether_drum.h"

namespace netpocket {
namespace {

using namespace std::string_view_literals;

constexpr std::array kNetShapes = {"square"sv, "hexagonal"sv, "radial"sv};
constexpr std::array kDrawstringStarts = {"never"sv, "time"sv, "contact"sv};
constexpr std::array kPassages = {"even"sv, "rings"sv};

constexpr Limits within_limits(double least, double most) { return {least, most}; }
constexpr Limits above_limit(double least, double most) { return {least, most, true}; }

// The default of an own parameter, as the function that the table wants.
template <auto Value>
ParameterValue initial() {
  return ParameterValue(Value);
}

constexpr auto kZenit = "published set-up, net thrown at a stage of 9 t"sv;
constexpr auto kAssumed = "assumption"sv;
constexpr auto kUsers = "user's choice"sv;

std::vector<Parameter> parameters_before_drum() {
  return {
      own_parameter("net.shape", initial<Choice{0}>, {}, "",
                    "square: square meshes; hexagonal: a hexagon of triangular meshes; radial: spokes and rings, as a "
                    "spider's web",
                    kUsers, kNetShapes),
      own_parameter("net.side", initial<22.0>, within_limits(0.1, 200), "m",
                    "side of the square or the hexagon; length of a spoke", kZenit),
      own_parameter("net.cells", initial<std::int64_t{22}>, within_limits(1, 100), "",
                    "meshes along a side; rings of a radial net", kZenit),
      own_parameter("net.spokes", initial<std::int64_t{8}>, within_limits(3, 64), "",
                    "of a radial net, with a mass at the end of each", kAssumed),
      own_parameter("net.elements_per_side", initial<std::int64_t{1}>, within_limits(1, 10), "",
                    "cable elements on a side of a mesh", kAssumed),
      own_parameter("net.diameter", initial<0.001>, within_limits(1e-5, 0.1), "m", "diameter of a cord", kZenit),
      own_parameter("net.density", initial<1390.0>, within_limits(1, 3e4), "kg/m^3", "density", kZenit),
      own_parameter("net.youngs_modulus", initial<70e9>, within_limits(1e3, 1e13), "Pa", "Young's modulus", kZenit),
      own_parameter("net.poisson_ratio", initial<0.36>, above_limit(-1, 0.5), "",
                    "Poisson's ratio, for the contact stiffness", kZenit),
      own_parameter("net.axial_damping", initial<3e-5>, within_limits(0, 1), "s",
                    "c of the axial force EA (eps + c epsdot)",
                    "damping ratio 0.106 of a mesh side of 1 m: 2 zeta L sqrt(rho/E)"),
      own_parameter("net.bending_damping", initial<1.6e-3>, within_limits(0, 10), "s",
                    "c of the bending moment EI (kappa + c kappadot)",
                    "damping ratio 0.014 of a mesh side of 1 m: 2 zeta/(pi/L)^2 sqrt(rho A/(E I))"),

      own_parameter("throw.corner_mass", initial<0.5>, within_limits(1e-4, 1e3), "kg", "mass at each corner", kZenit),
      own_parameter("throw.corner_thread", initial<1.4142>, within_limits(0, 100), "m",
                    "thread from a corner of the net to its mass; 0: the masses are at the corners", kZenit),
      own_parameter("throw.corner_thread_diameter", initial<0.00141421>, within_limits(1e-5, 0.1), "m",
                    "diameter of these threads; otherwise as the net's cords", kZenit),
      own_parameter("throw.speed", initial<2.5>, within_limits(0, 100), "m/s",
                    "speed of the corner masses at the start", kZenit),
      own_parameter("throw.angle", initial<0.6435>, within_limits(0, 1.5), "rad",
                    "between their velocities and the axis, outwards along the diagonals", kZenit),
      own_parameter("throw.spin", initial<0.0>, within_limits(-100, 100), "rad/s",
                    "angular velocity of the folded net and its masses about the axis", kAssumed),
      own_parameter("throw.folding", initial<0.05>, within_limits(0.01, 1), "",
                    "size of the folded net by that of the net; its cords are slack", kZenit),
      own_parameter("throw.gap", initial<0.5>, within_limits(0.01, 1e3), "m",
                    "from the spacecraft's +y face to the folded net", kAssumed),
      own_parameter("throw.recoil", initial<true>, {}, "", "the spacecraft starts with the opposite momentum",
                    kAssumed),

      own_parameter("tether.attached", initial<true>, {}, "",
                    "a tether joins the middle of the net to the spacecraft's +y face", kZenit),
      own_parameter("tether.length", initial<30.0>, within_limits(0.1, 1e4), "m", "length", kZenit),
      own_parameter("tether.elements", initial<std::int64_t{15}>, within_limits(1, 1000), "", "cable elements",
                    kAssumed),
      own_parameter("tether.diameter", initial<0.004>, within_limits(1e-5, 0.1), "m", "diameter", kZenit),
      own_parameter("tether.density", initial<1390.0>, within_limits(1, 3e4), "kg/m^3", "density", kZenit),
      own_parameter("tether.youngs_modulus", initial<70e9>, within_limits(1e3, 1e13), "Pa", "Young's modulus", kZenit),
      own_parameter("tether.axial_damping", initial<3e-5>, within_limits(0, 1), "s",
                    "c of the axial force EA (eps + c epsdot)", kAssumed),
  };
}

std::vector<Parameter> drawstring_parameters() {
  return {
      own_parameter(
          "drawstring.starts_at", initial<Choice{0}>, {}, "",
          "never: no drawstring, the perimeter is of the net's cord; time: at drawstring.start; contact: after the "
          "first touch of the target",
          kUsers, kDrawstringStarts),
      own_parameter("drawstring.start", initial<15.0>, within_limits(0, 1e5), "s", "time at which the winches begin",
                    kZenit),
      own_parameter("drawstring.delay", initial<0.0>, within_limits(0, 1e5), "s",
                    "from the first touch until the winches begin", kUsers),
      own_parameter("drawstring.duration", initial<10.0>, within_limits(1e-2, 1e5), "s", "of the winding, by a cycloid",
                    kAssumed),
      own_parameter("drawstring.closed_length", initial<2.0>, above_limit(0, 1e3), "m",
                    "of a side's drawstring when closed", kAssumed),
      own_parameter("drawstring.passage", initial<Choice{0}>, {}, "",
                    "even: the drawstring is the perimeter's cord and stays evenly spread over its knots; rings: it "
                    "runs along the perimeter's own cord through rings at its knots, with friction",
                    kUsers, kPassages),
      own_parameter("drawstring.ring_friction", initial<0.2>, within_limits(0, 10), "",
                    "coefficient of friction mu at a ring, where one tension is at most exp(mu angle) times the other",
                    "published friction of net on net, static"),
      own_parameter("drawstring.ring_angle", initial<0.0>, within_limits(0, 100), "rad",
                    "angle by which the drawstring wraps each ring, besides the angle by which it turns there",
                    kAssumed),
      own_parameter("drawstring.ring_spacing", initial<0.05>, above_limit(0, 10), "m",
                    "drawstring that stays between two rings which are drawn together", kAssumed),
      own_parameter("drawstring.diameter", initial<0.002>, within_limits(1e-5, 0.1), "m", "diameter", kAssumed),
      own_parameter("drawstring.density", initial<1140.0>, within_limits(1, 3e4), "kg/m^3", "density",
                    "assumption: polyamide"),
      own_parameter("drawstring.youngs_modulus", initial<1e9>, within_limits(1e3, 1e13), "Pa", "Young's modulus",
                    "assumption: braided polyamide"),
      own_parameter("drawstring.axial_damping", initial<3e-5>, within_limits(0, 1), "s",
                    "c of the axial force EA (eps + c epsdot)", kAssumed),
  };
}

std::vector<Parameter> own_parameters() {
  std::vector<Parameter> all = parameters_before_drum();
  for (const auto& more : {tether_drum_parameters(), drawstring_parameters()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

class OwnValues {
 public:
  explicit OwnValues(const Scenario& scenario) : scenario_(scenario) {}

  double number(std::string_view key) const { return std::get<double>(value(key)); }
  int integer(std::string_view key) const { return static_cast<int>(std::get<std::int64_t>(value(key))); }
  bool flag(std::string_view key) const { return std::get<bool>(value(key)); }
  int choice(std::string_view key) const { return std::get<Choice>(value(key)).index; }

 private:
  ParameterValue value(std::string_view key) const { return find_parameter(key, kThrownNetSystem)->get(scenario_); }

  const Scenario& scenario_;
};

// Cords pull and do not push: the folded net, whose cords are shorter than their material, is then free of stress.
CordParameters cord_of(const OwnValues& own, const std::string& table) {
  CordParameters cord;
  cord.diameter = own.number(table + ".diameter");
  cord.density = own.number(table + ".density");
  cord.youngs_modulus = own.number(table + ".youngs_modulus");
  cord.poisson_ratio = own.number("net.poisson_ratio");
  cord.axial_damping = own.number(table + ".axial_damping");
  cord.bending_damping = own.number("net.bending_damping");
  cord.compression = 0;
  return cord;
}

class ThrownNetChecker {
 public:
  ThrownNetChecker(const Scenario& scenario, const Shape* target, Diagnostics& problems)
      : scenario_(scenario), net_(thrown_net_parameters(scenario)), target_(target), problems_(problems) {}

  void run() {
    check_size();
    check_tether();
    check_drawstring();
    check_winches();
    check_towing();
    check_place();
  }

 private:
  void add(std::string_view key, std::string message) {
    problems_.add({.key = std::string(key), .message = std::move(message)});
  }

  void check_size() {
    const double elements = net_.elements_of_the_net() + net_.tether_elements;
    if (elements > kLargestElementCount) {
      add("net.cells",
          fmt::format("cells and elements make {:.3g} elements; {:.0f} are allowed", elements, kLargestElementCount));
    }
    const double element = net_.smallest_mesh_side() / net_.elements_per_side;
    if (element < net_.cord.diameter) {
      add("net.diameter", fmt::format("elements of {:.3g} m are shorter than the cord is thick", element));
    }
  }

  void check_tether() {
    if (!net_.tethered) return;
    if (net_.shape == NetShape::square && net_.cells % 2 != 0) {
      add("net.cells", fmt::format("{} cells leave no knot in the middle for the tether; use an even number or "
                                   "tether.attached = false",
                                   net_.cells));
    }
    if (net_.tether_length < net_.gap) {
      add("tether.length", fmt::format("{} m do not reach the folded net {} m away", net_.tether_length, net_.gap));
    }
    check_tether_drum(scenario_, net_.has_drawstring(), problems_);
  }

  void check_drawstring() {
    if (!net_.has_drawstring()) return;
    const double closed = net_.drawstring.closed_length;
    const double side = net_.side_of_perimeter();
    if (closed >= side) {
      add("drawstring.closed_length", fmt::format("must be shorter than the side of {:.6g} m, not {} m", side, closed));
    }
    if (net_.passage == DrawstringPassage::rings) return check_rings(side);
    const double elements = std::lround(side * net_.cells / net_.side) * net_.elements_per_side;
    const double thick = net_.drawstring_cord.diameter * elements;
    if (closed < thick) {
      add("drawstring.closed_length",
          fmt::format("{} m have elements shorter than the drawstring is thick; at least {:.3g} m are needed", closed,
                      thick));
    }
  }

  void check_rings(double side) {
    const double parts = net_.parts_of_a_side();
    if (net_.ring_spacing > 0.5 * side / parts) {
      add("drawstring.ring_spacing", fmt::format("{} m are more than half of the {:.3g} m between two rings of the "
                                                 "open net",
                                                 net_.ring_spacing, side / parts));
    } else if (net_.drawstring.closed_length < net_.ring_spacing * parts) {
      add("drawstring.closed_length",
          fmt::format("{} m are less than the drawstring.ring_spacing of {} m leaves between rings, {:.3g} m",
                      net_.drawstring.closed_length, net_.ring_spacing, net_.ring_spacing * parts));
    }
  }

  void check_winches() {
    const WinchParameters& winch = scenario_.winch;
    for (const auto& [key, rows] : {std::pair("winch.late", winch.late), {"winch.jammed", winch.jammed}}) {
      if (!rows.empty() && winch.drive == WinchDrive::prescribed) {
        add(key, "needs a winch.drive other than \"prescribed\", whose ropes follow the drawstring's law exactly");
      }
      for (const Eigen::Vector2d& row : rows) {
        if (row.x() >= 1 && row.x() <= net_.corner_count() && row.x() == std::floor(row.x())) continue;
        add(key, fmt::format("the drawstring has the ropes 1 to {}, and {:g} is none of them", net_.corner_count(),
                             row.x()));
      }
    }
  }

  void check_towing() {
    const TowingParameters& towing = scenario_.towing;
    if (towing.mode == TowingMode::controlled) add("towing.mode", "a thrown net has no controllers that could pull");
    if (towing.mode != TowingMode::none && towing.starts_at == TowingStart::closed && !net_.has_drawstring()) {
      add("towing.starts_at", "without a drawstring the net is never closed; give towing.start");
    }
  }

  void check_place() {
    if (target_ == nullptr) return;
    const double plane = scenario_.spacecraft.position.y() + 0.5 * scenario_.spacecraft.size.y() + net_.gap;
    const double nearest = scenario_.target.position.y() - bounding_radius(*target_);
    if (nearest <= plane) {
      add("target.position",
          fmt::format("the target reaches down to y = {:.4g} m, but the folded net is at y = {:.4g} m", nearest,
                      plane));
    }
  }

  const Scenario& scenario_;
  ThrownNetParameters net_;
  const Shape* target_;
  Diagnostics& problems_;
};

void check_thrown_net(const Scenario& scenario, const Shape* target, Diagnostics& problems) {
  ThrownNetChecker(scenario, target, problems).run();
}

bool acts_at_once_in_thrown_net(std::string_view key) {
  const bool is_of_winches =
      key.starts_with("winch.") && key != "winch.drive" && !key.starts_with("winch.drum_") && key != "winch.late";
  return is_of_winches || drum_acts_at_once(key) || key.starts_with("towing.") || key == "spacecraft.station_keeping" ||
         key == "drawstring.start" || key == "drawstring.duration" || key == "drawstring.closed_length" ||
         key == "target.thrust" || key == "target.torque" || key.starts_with("target.acts_");
}

}  // namespace

double ThrownNetParameters::side_of_perimeter() const {
  return shape == NetShape::radial ? 2 * side * sine(std::numbers::pi / spokes) : side;
}

// The innermost ring of a radial net has the shortest sides.
double ThrownNetParameters::smallest_mesh_side() const {
  const double mesh = side / cells;
  return shape == NetShape::radial ? std::min(mesh, side_of_perimeter() / cells) : mesh;
}

double ThrownNetParameters::parts_of_a_side() const { return shape == NetShape::radial ? 1 : cells; }

// A ring of a radial net has about as many elements as meshes of a spoke's go into its circumference.
double ThrownNetParameters::elements_of_the_net() const {
  const double n = cells;
  const double of_square = 2 * n * (n + 1), of_hexagon = 9 * n * n + 3 * n;
  if (shape != NetShape::radial) return elements_per_side * (shape == NetShape::square ? of_square : of_hexagon);
  const double per_ring = std::max(1.0, side_of_perimeter() / side * 0.5 * (n + 1));
  return elements_per_side * spokes * n * (1 + per_ring);
}

ThrownNetParameters thrown_net_parameters(const Scenario& scenario) {
  const OwnValues own(scenario);
  const auto draws_at = static_cast<DrawstringStart>(own.choice("drawstring.starts_at"));
  ThrownNetParameters net{.shape = static_cast<NetShape>(own.choice("net.shape")),
                          .side = own.number("net.side"),
                          .cells = own.integer("net.cells"),
                          .spokes = own.integer("net.spokes"),
                          .elements_per_side = own.integer("net.elements_per_side"),
                          .cord = cord_of(own, "net"),
                          .corner_mass = own.number("throw.corner_mass"),
                          .corner_thread = own.number("throw.corner_thread"),
                          .corner_thread_diameter = own.number("throw.corner_thread_diameter"),
                          .speed = own.number("throw.speed"),
                          .angle = own.number("throw.angle"),
                          .spin = own.number("throw.spin"),
                          .folding = own.number("throw.folding"),
                          .gap = own.number("throw.gap"),
                          .recoil = own.flag("throw.recoil"),
                          .tethered = own.flag("tether.attached"),
                          .tether_length = own.number("tether.length"),
                          .tether_elements = own.integer("tether.elements"),
                          .tether = cord_of(own, "tether"),
                          .drum = tether_drum(scenario),
                          .draws_at = draws_at,
                          .drawstring = {},
                          .draw_delay = own.number("drawstring.delay"),
                          .passage = static_cast<DrawstringPassage>(own.choice("drawstring.passage")),
                          .ring_friction = own.number("drawstring.ring_friction"),
                          .ring_angle = own.number("drawstring.ring_angle"),
                          .ring_spacing = own.number("drawstring.ring_spacing"),
                          .drawstring_cord = cord_of(own, "drawstring")};
  net.drawstring.start = own.number("drawstring.start");
  net.drawstring.duration = own.number("drawstring.duration");
  net.drawstring.closed_length = own.number("drawstring.closed_length");
  return net;
}

const SystemParameters& thrown_net_system_parameters() {
  static const SystemParameters kThrownNet = {
      .name = kThrownNetSystem,
      .title = "Thrown net",
      .help = "Corner masses spread a thrown net that wraps the target; a drawstring closes it and a tether tows.",
      .shared_groups = {"spacecraft", "target", "contact", "towing", "winch"},
      .groups =
          {{"net", "Net", "A net of equal meshes, and its cords, which pull and do not push."},
           {"throw", "Throw", "The corner masses, and how the folded net starts along +Y."},
           {"tether", "Tether", "The line from the middle of the net to the spacecraft."},
           {"drawstring", "Drawstring",
            "The rope round the net's perimeter, which winches at the net's corners wind in; table winch says how."}},
      .parameters = own_parameters(),
      .check = check_thrown_net,
      .acts_at_once = acts_at_once_in_thrown_net};
  return kThrownNet;
}

}  // namespace netpocket
