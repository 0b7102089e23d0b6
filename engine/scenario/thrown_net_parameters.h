#pragma once
// The parameters of the thrown net as plain numbers. The parameter table (thrown_net_parameters.cpp) declares each with
// its TOML key, unit, limits, help and source. SI units. The net is thrown along +Y from the spacecraft's +y face.

#include <string_view>

#include "engine/scenario/scenario.h"
#include "engine/scenario/tether_drum.h"

namespace netpocket {

struct SystemParameters;

inline constexpr std::string_view kThrownNetSystem = "thrown_net";

enum class DrawstringStart { never, time, contact };
enum class DrawstringPassage { even, rings };
enum class NetShape { square, hexagonal, radial };

struct ThrownNetParameters {
  // Table "net": how its cords run (net_pattern.h).
  NetShape shape;
  double side;            // m, of a square or a hexagon; the length of a spoke
  int cells;              // meshes along a side; rings of a radial net
  int spokes;             // of a radial net
  int elements_per_side;  // cable elements on a side of a mesh
  CordParameters cord;    // of the meshes
  // Table "throw".
  double corner_mass;             // kg, each
  double corner_thread;           // m, from a corner of the net to its mass
  double corner_thread_diameter;  // m
  double speed;                   // m/s, of the corner masses at the start
  double angle;                   // rad, between their velocities and the axis, outwards
  double spin;                    // rad/s, of net and masses about the axis at the start
  double folding;                 // size of the folded net by that of the net
  double gap;                     // m, from the spacecraft's face to the folded net
  bool recoil;                    // whether the spacecraft takes the opposite momentum
  // Table "tether", from the middle of the net to the spacecraft.
  bool tethered;
  double tether_length;  // m
  int tether_elements;
  CordParameters tether;
  TetherDrum drum;
  // Table "drawstring", round the perimeter.
  DrawstringStart draws_at;
  ClosingParameters drawstring;  // by side of the net; `start` of `draws_at`
  double draw_delay;             // s, from the first contact, for draws_at = contact
  DrawstringPassage passage;     // how rope passes the knots of the perimeter
  double ring_friction;          // coefficient, for passage = rings; likewise the next two
  double ring_angle;             // rad, wrap at each ring besides the rope's turn
  double ring_spacing;           // m, of rope that stays between two rings
  CordParameters drawstring_cord;

  bool is_wound() const { return tethered && drum.attached; }
  bool has_drawstring() const { return draws_at != DrawstringStart::never; }
  int corner_count() const { return shape == NetShape::square ? 4 : shape == NetShape::hexagonal ? 6 : spokes; }
  double side_of_perimeter() const;    // m
  double parts_of_a_side() const;      // of the perimeter, between knots
  double smallest_mesh_side() const;   // m
  double elements_of_the_net() const;  // number of cable elements
};

// The parameters of a scenario of the system "thrown_net".
ThrownNetParameters thrown_net_parameters(const Scenario& scenario);

// What scenarios of this system consist of (system_parameters.h).
const SystemParameters& thrown_net_system_parameters();

}  // namespace netpocket
