#pragma once
// Points on the surface and in the volume of a shape, evenly spread and always the same. Body axes, m. Pure functions:
// any thread may call them.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/shape.h"

namespace netpocket {

struct SurfaceSample {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  // unit, outward
};

// About `count` points with equal shares of the surface. They are the surface points nearest to points of a thin layer
// above the surface (1 % of the bounding radius), in which the points of a Sobol sequence are evenly spread. The method
// needs nothing but distances, so it serves every shape. Edges receive too many points, by about the layer's thickness.
std::vector<SurfaceSample> surface_samples(const Shape& shape, int count);

// About `count` points with equal shares of the volume.
std::vector<Eigen::Vector3d> volume_samples(const Shape& shape, int count);

// Surface (m^2). For a satellite the sum over its parts, without the small areas where they touch.
double surface_area(const Shape& shape);

// Characteristic length (m) as used for space debris: the mean of the extents along three axes, here the body's.
double characteristic_length(const Shape& shape);

}  // namespace netpocket
