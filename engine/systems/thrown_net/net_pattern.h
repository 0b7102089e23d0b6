#pragma once
// How the cords of a flat net run: its knots, the straight cords through them, the triangles that they span and its
// perimeter. Plane coordinates in m, about the net's middle; (x, z) of the world.
//
// - square: `cells` square meshes along a side.
// - hexagonal: a regular hexagon of triangular meshes, `cells` along a side. Cords run in three directions.
// - radial: straight spokes from the middle to a regular polygon, and `cells` rings round the middle, like a spider's
//   web. The size is the length of a spoke.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/scenario/thrown_net_parameters.h"

namespace netpocket {

struct NetCord {
  std::vector<std::int32_t> knots;  // at equal distances
  double length;                    // m
  int divisions;                    // between two knots: how often the length of a mesh goes into their distance
  bool is_side;                     // on the perimeter
  std::string name;
};

// One of eight parts of a net that look alike, e.g. strips of rows, and the knot's place in it.
struct KnotPart {
  std::int32_t part = -1, place = -1;
};

struct NetPattern {
  std::vector<Eigen::Vector2d> knots;  // m
  std::vector<KnotPart> parts;         // by knot; empty: the net is not divided
  std::vector<NetCord> cords;
  std::vector<std::array<std::int32_t, 3>> triangles;  // knots, all turning the same way
  std::vector<std::int32_t> perimeter;                 // knots, in their order round the net
  std::vector<std::int32_t> corners;                   // knots with a mass, likewise
  std::int32_t middle = -1;                            // knot in the middle; -1: there is none
  double area = 0;                                     // m^2
};

// `spokes`: of a radial net.
NetPattern net_pattern(NetShape shape, double size, int cells, int spokes);

}  // namespace netpocket
