#pragma once
// What of a model does not change during a run: which nodes the elements join and what the bodies look like. Together
// with a Snapshot it is all that drawing, exporting and reading a recording need.

#include <cstdint>
#include <string>
#include <vector>

#include "engine/bodies/shape.h"

namespace netpocket {

enum class ElementKind : std::uint8_t { net = 0, rod = 1, closing_rope = 2, cable = 3 };

// A two-node cable element: cubic Hermite curve between node[0] and node[1] with slopes gradient[0], gradient[1]
// (dr/dp, dimensionless) over `length` metres of material. Indices are columns of Snapshot::positions / ::gradients.
struct StructureElement {
  std::int32_t node[2];
  std::int32_t gradient[2];
  ElementKind kind = ElementKind::cable;
  std::int32_t thread = 0;  // index into Structure::threads
  std::int32_t rope = -1;   // >= 0: variable length, current length is Snapshot::rope_element_length[rope]
  double length = 0;        // m, material length (at the start for variable elements)
  double radius = 0;        // m, outer radius of the cord or rod
};

enum class BodyRole : std::uint8_t { spacecraft = 0, target = 1, other = 2 };

struct StructureBody {
  std::string name;  // "spacecraft", "target", ...
  BodyRole role = BodyRole::other;
  Shape shape;      // drawn and touched; body axes, centred at the centre of mass
  double mass = 0;  // kg
};

struct Structure {
  std::int32_t node_count = 0;
  std::int32_t gradient_count = 0;
  std::vector<StructureElement> elements;
  std::vector<std::string> threads;  // names, e.g. "rod 3", "panel 2 row 4"
  std::vector<StructureBody> bodies;
  std::vector<std::int32_t> rod_roots;  // node of each rod's clamped end, by rod
  std::vector<std::int32_t> rod_kinks;  // node of each rod's kink
  std::vector<std::int32_t> rod_tips;   // node of each rod's tip: retractors sit here
  std::int32_t rope_count = 0;          // variable-length ropes
};

}  // namespace netpocket
