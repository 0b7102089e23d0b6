#pragma once
// Collects meshes for a binary glTF 2.0 file.

#include <vtkActor.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace netpocket {

class GltfDocument {
 public:
  GltfDocument();

  // The actor's polygons or lines with their normals and colours, at its place. Nothing for an empty mesh.
  void add(const std::string& name, vtkActor& actor);

  // The bytes of a .glb file.
  std::string bytes() const;

 private:
  // Which of a mesh's points are used, in the order in which cells first name them.
  struct Corners;

  int add_material(vtkActor& actor, bool colored, bool lines);
  // Adds an accessor to `count` elements of `values`; its index.
  int add_floats(const std::vector<float>& values, int components, bool with_limits);
  int add_indices(const std::vector<std::uint32_t>& indices);
  int add_view(const void* data, std::size_t size, int target);

  nlohmann::ordered_json json_;
  std::string buffer_;
};

}  // namespace netpocket
