#include "gui/commands/mesh_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/bodies/mesh_crossings.h"
#include "engine/bodies/mesh_weld.h"
#include "engine/bodies/triangle_mesh.h"
#include "engine/scenario/mesh_unit.h"
#include "engine/scenario/parameters.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostParts = 20, kMostPlaces = 5;

std::string size_text(const Eigen::AlignedBox3d& box) {
  const Vector3d size = box.sizes();
  return fmt::format("{:.4g} x {:.4g} x {:.4g} m", size.x(), size.y(), size.z());
}

// Round-off about zero reads as zero.
double rounded(double value, double scale) { return std::abs(value) < 1e-12 * scale ? 0.0 : value; }

std::string place_in(const Vector3d& place, double extent) {
  return place_text({rounded(place.x(), extent), rounded(place.y(), extent), rounded(place.z(), extent)});
}

// Hollows face inwards; in a mesh without faults nothing else does.
std::string kind_text(const MeshPart& part, bool sound) {
  if (!part.closed) return fmt::format("open, {:.4g} m^2", part.area);
  if (part.flat) return fmt::format("encloses no volume, {:.4g} m^2", part.area);
  if (part.two_sided) return fmt::format("two-sided, {:.4g} m^2", part.area);
  if (part.volume > 0) return fmt::format("{:.6g} m^3", part.volume);
  return fmt::format("{} of {:.6g} m^3", sound ? "hollow" : "faces inwards, hollow or inverted,", -part.volume);
}

std::string part_lines(const MeshReview& review, double extent) {
  std::string text;
  for (std::size_t i = 0; i < std::min(review.parts.size(), kMostParts); ++i) {
    const MeshPart& part = review.parts[i];
    text += report_line(fmt::format("part {}", i + 1),
                        fmt::format("{} triangles, {} about {}: {}", part.triangles, size_text(part.bounds),
                                    place_in(part.bounds.center(), extent), kind_text(part, review.faults.empty())));
  }
  if (review.parts.size() > kMostParts)
    text += report_line("", fmt::format("and {} more", review.parts.size() - kMostParts));
  return text;
}

std::string inertia_text(const Eigen::Matrix3d& inertia) {
  const double scale = inertia.trace();
  return fmt::format("{:.6g}, {:.6g}, {:.6g}, I_xy {:.4g}, I_yz {:.4g}, I_zx {:.4g} m^2 (kg m^2 per kg of mass)",
                     inertia(0, 0), inertia(1, 1), inertia(2, 2), rounded(inertia(0, 1), scale),
                     rounded(inertia(1, 2), scale), rounded(inertia(2, 0), scale));
}

std::string self_crossings(const MeshReview& review) {
  const auto found = find_crossings(review.mesh, review.part_of, CrossingPairs::of_same_part,
                                    kTouchingTolerance * mesh_extent(review.mesh), kMostFaultPlaces);
  if (found.empty()) return "";
  return report_line(
      "remark",
      fmt::format("a part goes through itself at {}{} places, one of them {}; its volume counts "
                  "twice what it shares with itself",
                  found.size(), found.size() == kMostFaultPlaces ? " or more" : "", place_text(found[0].place)));
}

}  // namespace

std::string report_line(const std::string& label, const std::string& value) {
  return fmt::format("{:<15}{}\n", label, value);
}

std::string unit_name(MeshUnit unit) {
  return std::string(find_parameter("target.mesh_unit")->choices[static_cast<std::size_t>(unit)]);
}

std::vector<std::string> unit_names() {
  const auto& choices = find_parameter("target.mesh_unit")->choices;
  return {choices.begin(), choices.end()};
}

std::string unit_line(MeshUnit unit, bool chosen, double extent) {
  std::vector<std::string> others;
  for (const MeshUnit other :
       {MeshUnit::metre, MeshUnit::centimetre, MeshUnit::millimetre, MeshUnit::inch, MeshUnit::foot}) {
    if (other != unit) others.push_back(fmt::format("{} {:.4g} m", unit_name(other), metres(other) * extent));
  }
  return report_line("unit", fmt::format("{} ({}): {:.4g} m large; in {}", unit_name(unit),
                                         chosen ? "as told" : "likely; --unit says another", metres(unit) * extent,
                                         fmt::join(others, ", in ")));
}

std::string mesh_report(const MeshReview& review) {
  const MeshData& mesh = review.mesh;
  std::string text =
      report_line("triangles", fmt::format("{}, vertices {}", mesh.triangles.size(), mesh.vertices.size()));
  if (review.joined > 0) {
    text += report_line("joined", fmt::format("{} corners that differed by at most {:.3g} m ({:g} of the extent)",
                                              review.joined, review.weld_tolerance, kWeldTolerance));
  }
  if (review.parts.empty()) return text;
  Eigen::AlignedBox3d box;
  for (const MeshPart& part : review.parts) box.extend(part.bounds);
  const double extent = box.sizes().maxCoeff();
  text += report_line("extents", fmt::format("{}, from {} to {}", size_text(box), place_in(box.min(), extent),
                                             place_in(box.max(), extent)));
  text += report_line("parts", fmt::format("{}", review.parts.size()));
  text += part_lines(review, extent);
  if (review.faults.empty()) {
    const auto solid = TriangleMesh::of_closed(mesh);
    text += report_line("volume", fmt::format("{:.6g} m^3", solid->volume()));
    text += report_line("centre of mass", place_in(solid->centre_in_file(), extent));
    text += report_line("inertia", inertia_text(solid->unit_inertia()));
  }
  return text + self_crossings(review);
}

std::string fault_lines(const MeshReview& review) {
  if (review.faults.empty()) return report_line("faults", "none");
  std::string text;
  for (const MeshFault& fault : review.faults) {
    text += report_line("fault", fault.text);
    if (fault.places.size() < 2) continue;
    std::vector<std::string> places;
    for (std::size_t i = 0; i < std::min(fault.places.size(), kMostPlaces); ++i)
      places.push_back(place_text(fault.places[i]));
    text += report_line("  at",
                        fmt::format("{}{}", fmt::join(places, ", "), fault.places.size() > kMostPlaces ? ", ..." : ""));
  }
  return text;
}

}  // namespace netpocket
