#pragma once
// Collects meshes, and how they move, for a binary glTF 2.0 file (Khronos glTF 2.0 specification).

#include <vtkActor.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/scene/color.h"

namespace netpocket {

// How a node moves: a value for each key of the document.
struct GltfTrack {
  std::string name;
  std::vector<float> translations;  // m, 3 for each key
  std::vector<float> rotations;     // unit quaternions x, y, z, w, 4 for each key; none: it does not turn

  void add(const Eigen::Vector3d& position);
  // Of the two quaternions of the attitude: the one nearer to that before, so that it turns the short way.
  void add(const Eigen::Vector3d& position, const Eigen::Quaterniond& attitude);
};

// Triangles whose points each follow one joint of a skin, as placed at the first key.
struct GltfSkinnedPart {
  std::vector<float> positions;  // m, 3 for each point
  std::vector<float> normals;    // 3 for each point; none: unlit, both sides
  std::vector<std::uint16_t> joints;
  std::vector<std::uint32_t> triangles;
  Color color;
};

class GltfDocument {
 public:
  GltfDocument();

  // The actor's polygons or lines with their normals and colours, at its place. Nothing for an empty mesh.
  void add(const std::string& name, vtkActor& actor);
  // The same as a mesh that nodes may show; nothing for an empty one.
  std::optional<std::size_t> add_mesh(const std::string& name, vtkActor& actor);

  // Times of the keys, s. Before anything that moves.
  void set_keys(const std::vector<float>& times);
  // Meshes that move along a track.
  void add_moving(const GltfTrack& track, const std::vector<std::size_t>& meshes);
  // A mesh of several parts that follows joints.
  void add_skinned(const std::string& name, const std::vector<GltfTrack>& joints,
                   const std::vector<GltfSkinnedPart>& parts);

  // The bytes of a .glb file.
  std::string bytes() const;

 private:
  // Which of a mesh's points are used, in the order in which cells first name them.
  struct Corners;

  std::size_t add_node(nlohmann::ordered_json node);
  std::size_t add_track(const GltfTrack& track, nlohmann::ordered_json node);
  void animate(std::size_t node, const char* path, const std::vector<float>& values, const char* type);
  nlohmann::ordered_json skinned_primitive(const GltfSkinnedPart& part);
  std::size_t add_material(vtkActor& actor, bool colored, bool lines);
  std::size_t add_material(nlohmann::ordered_json material);
  // Each adds an accessor; its index.
  std::size_t add_floats(const std::vector<float>& values, const char* type, bool with_limits, bool of_points = true);
  std::size_t add_indices(const std::vector<std::uint32_t>& indices);
  std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type);
  std::size_t add_view(const void* data, std::size_t size, int target);

  nlohmann::ordered_json json_;
  std::string buffer_;
  std::size_t keys_ = 0;  // accessor of their times
};

}  // namespace netpocket
