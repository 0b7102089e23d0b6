#pragma once
// Triangle meshes of known bodies, and files of them.

#include <string>

#include "engine/bodies/triangle_mesh.h"

namespace netpocket::samples {

// Corners on the sphere; 20 frequency^2 triangles of nearly equal size (an icosahedron's faces, divided).
MeshData geodesic_sphere(double radius, int frequency);
// As geodesic_sphere, with the volume of the sphere of `radius`.
MeshData equal_volume_sphere(double radius, int frequency);
MeshData box(const Eigen::Vector3d& size);
// Along y; the flank's corners on the cylinder.
MeshData cylinder(double radius, double length, int sides);
// About y.
MeshData torus(double radius, double tube_radius, int sides, int tube_sides);
// A thin, slanted wedge with edges of 8 degrees and needle-like corners.
MeshData wedge();

MeshData moved(MeshData data, const Eigen::Vector3d& by);
MeshData turned_inside_out(MeshData data);
MeshData joined(MeshData first, const MeshData& second);

// The mesh; ends the test program when it is refused.
std::shared_ptr<const TriangleMesh> checked_mesh(const MeshData& data);

// What a review says of it first; empty when it finds nothing.
std::string verdict(const MeshData& data);

std::string binary_stl(const MeshData& data);
std::string ascii_stl(const MeshData& data);
std::string obj(const MeshData& data);
void write_file(const std::string& path, const std::string& bytes);

}  // namespace netpocket::samples
