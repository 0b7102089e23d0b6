#pragma once
// A place where a cord touches a body. Result of ContactSearch.

#include <Eigen/Core>
#include <cstdint>

namespace netpocket {

struct CordTouch {
  CordTouch() {}  // not defaulted: with that, all members would first be set to zero

  std::int32_t element = 0;
  std::int32_t part = 0;     // index into ContactSearch::parts()
  std::int32_t holder = 0;   // see ContactHolders::index
  std::int32_t segment = 0;  // index of the element's capsule
  // The element and its place (0: first node) whose touch was found first at this holder. Two elements share the holder
  // at their node.
  std::int32_t first_element = 0, first_place = 0;
  double t = 0;              // position along the segment, 0 to 1
  double share = 0;          // weight of the holder there, -1 to 2; negative: it takes back what others count twice
  bool is_extra = false;     // whether the holder has another place with a higher score
  double penetration = 0;    // m; negative: still apart
  bool is_cord_end = false;  // whether its holder is an end of the cord
  double score = 0;          // increases with share * penetration^2.5; negative for places still apart
  Eigen::Vector3d normal;    // outward from the body, world axes
  Eigen::Vector3d point;     // m, on the cord's axis, world frame
};

}  // namespace netpocket
