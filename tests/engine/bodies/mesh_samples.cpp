#include "tests/engine/bodies/mesh_samples.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <numbers>

#include "engine/bodies/mesh_review.h"
#include "engine/bodies/mesh_weld.h"

namespace netpocket::samples {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 2 * std::numbers::pi;

void add(MeshData& data, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto first = static_cast<std::int32_t>(data.vertices.size());
  data.vertices.insert(data.vertices.end(), {a, b, c});
  data.triangles.push_back({first, first + 1, first + 2});
}

double volume(const MeshData& data) {
  double sum = 0;
  for (const Triangle& t : data.triangles)
    sum += data.vertices[t[0]].dot(data.vertices[t[1]].cross(data.vertices[t[2]])) / 6;
  return sum;
}

void append(std::string& bytes, const void* value, std::size_t size) {
  bytes.append(static_cast<const char*>(value), size);
}

}  // namespace

MeshData geodesic_sphere(double radius, int frequency) {
  const double golden = std::numbers::phi;
  const std::array<Vector3d, 12> corners = {Vector3d{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                                            {0, -1, golden},         {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                                            {golden, 0, -1},         {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
  constexpr std::array<Triangle, 20> kFaces = {Triangle{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                               {1, 5, 9},          {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                               {3, 9, 4},          {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                               {4, 9, 5},          {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  MeshData data;
  for (const Triangle& face : kFaces) {
    // Exactly symmetric in the three corners, so that neighbouring faces share their points to the last bit.
    const auto point = [&](int i, int j) -> Vector3d {
      const int k = frequency - i - j;
      std::array<std::pair<int, int>, 3> parts = {std::pair(face[0], k), {face[1], i}, {face[2], j}};
      std::sort(parts.begin(), parts.end());
      Vector3d sum = Vector3d::Zero();
      for (const auto& [corner, weight] : parts) sum += weight * corners[corner];
      return radius * sum.normalized();
    };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        add(data, point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j < frequency - 1) add(data, point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
      }
    }
  }
  return weld(data, 0).mesh;
}

MeshData equal_volume_sphere(double radius, int frequency) {
  MeshData data = geodesic_sphere(radius, frequency);
  const double scale = std::cbrt(4 * std::numbers::pi / 3 * radius * radius * radius / volume(data));
  for (Vector3d& vertex : data.vertices) vertex *= scale;
  return data;
}

MeshData box(const Vector3d& size) {
  MeshData data;
  for (int i = 0; i < 8; ++i)
    data.vertices.push_back(size.cwiseProduct(Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1)) - size / 2);
  data.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return data;
}

MeshData cylinder(double radius, double length, int sides) {
  MeshData data;
  const Vector3d top(0, length / 2, 0);
  const auto rim = [&](int i) {
    const double angle = kTurn * (i % sides) / sides;
    return Vector3d(radius * std::cos(angle), 0, radius * std::sin(angle));
  };
  for (int i = 0; i < sides; ++i) {
    const Vector3d here = rim(i), next = rim(i + 1);
    add(data, here - top, here + top, next + top);
    add(data, here - top, next + top, next - top);
    add(data, top, next + top, here + top);
    add(data, -top, here - top, next - top);
  }
  return weld(data, 0).mesh;
}

MeshData torus(double radius, double tube_radius, int sides, int tube_sides) {
  MeshData data;
  const auto point = [&](int i, int j) {
    const double u = kTurn * (i % sides) / sides, v = kTurn * (j % tube_sides) / tube_sides;
    const double r = radius + tube_radius * std::cos(v);
    return Vector3d(r * std::cos(u), tube_radius * std::sin(v), r * std::sin(u));
  };
  for (int i = 0; i < sides; ++i) {
    for (int j = 0; j < tube_sides; ++j) {
      add(data, point(i, j), point(i, j + 1), point(i + 1, j + 1));
      add(data, point(i, j), point(i + 1, j + 1), point(i + 1, j));
    }
  }
  return weld(data, 0).mesh;
}

MeshData wedge() {
  const Vector3d a(0, 0, 0), b(4, 0, 0), c(2, 0, 3), d(3.5, 0.4, 0.6);
  MeshData data;
  add(data, a, b, c);
  add(data, a, d, b);
  add(data, b, d, c);
  add(data, c, d, a);
  return weld(data, 0).mesh;
}

MeshData moved(MeshData data, const Vector3d& by) {
  for (Vector3d& vertex : data.vertices) vertex += by;
  return data;
}

MeshData turned_inside_out(MeshData data) {
  for (Triangle& t : data.triangles) std::swap(t[1], t[2]);
  return data;
}

MeshData joined(MeshData first, const MeshData& second) {
  const auto offset = static_cast<std::int32_t>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const Triangle& t : second.triangles) first.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return first;
}

std::shared_ptr<const TriangleMesh> checked_mesh(const MeshData& data) {
  auto mesh = TriangleMesh::make(data);
  if (const auto* problem = std::get_if<std::string>(&mesh)) {
    std::cerr << "the sample mesh " << *problem << "\n";
    std::abort();
  }
  return std::get<std::shared_ptr<const TriangleMesh>>(mesh);
}

std::string verdict(const MeshData& data) {
  const MeshReview review = review_mesh(data);
  return review.faults.empty() ? "" : review.faults.front().text;
}

std::string binary_stl(const MeshData& data) {
  std::string bytes = "solid but binary all the same";
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(data.triangles.size());
  append(bytes, &count, sizeof(count));
  for (const Triangle& t : data.triangles) {
    const float normal[3] = {0, 0, 0};
    append(bytes, normal, sizeof(normal));
    for (const std::int32_t corner : t) {
      const Eigen::Vector3f vertex = data.vertices[corner].cast<float>();
      append(bytes, vertex.data(), 3 * sizeof(float));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ascii_stl(const MeshData& data) {
  std::string text = "solid sample\n";
  for (const Triangle& t : data.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::int32_t corner : t) {
      const Vector3d& v = data.vertices[corner];
      text += fmt::format("      vertex {} {} {}\n", v.x(), v.y(), v.z());
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid sample\n";
}

std::string obj(const MeshData& data) {
  std::string text = "# a sample\no sample\n";
  for (const Vector3d& v : data.vertices) text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : data.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace netpocket::samples
