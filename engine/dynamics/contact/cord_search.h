#pragma once
// Looks for the places where cords may touch each other during the next steps.
//
// In three stages, each of which is asked again only when motion demands it: pairs of elements within a margin of each
// other (near_pairs.h, seldom), those of them that are near (each only when the way travelled since could have used up
// its clearance), and the pairs of capsules on near elements (tested at every step by the caller). Nothing near costs
// nothing.
//
// The answer holds all that may touch: each list has a margin, and is made anew before the way that note_way has been
// told of, which is what has really moved, has used it up. How fast things move only decides how wide margins are. What
// the answer holds beyond depends on the history; its order does not.

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/divided_loop.h"
#include "engine/dynamics/assembly/motion_bound.h"
#include "engine/dynamics/contact/cord_pairs.h"
#include "engine/dynamics/contact/cord_polyline.h"

namespace netpocket {

// Two capsules that may touch: segment `first_segment` of the element near_elements()[first] and likewise of another.
struct NearSegments {
  std::int32_t first, second;
  std::int32_t first_segment, second_segment;
};

// One side of NearSegments: near()[pair] seen from its first or its second element.
struct NearSide {
  std::int32_t pair;
  bool second;
};

class CordSearch {
 public:
  CordSearch(const Model& model, const CordPolyline& polyline, const CordPairs& pairs);

  // To be called when positions have changed other than by steps.
  void forget();

  // No point of a cord has moved by more than `way` (m) since the last call.
  void note_way(double way);
  // To be called at every step, before what it finds is asked for: all that is within `ahead` (m), no more than what
  // broad_margin() is. `element_length` in m, by element; `loop`: whose threads share what takes long, seldom.
  void update(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double ahead,
              const DividedLoop& loop);
  double broad_margin() const { return broad_margin_; }

  std::span<const std::int32_t> near_elements() const { return near_elements_; }
  std::span<const NearSegments> near() const { return near_; }
  // Both sides of near(), in an order that is the same in every sector of a pocket (index = local * 8 + sector): by
  // what the side's own element and the other one are locally, how many sectors lie between, and their segments.
  std::span<const NearSide> sides() const { return sides_; }

 private:
  struct Candidate {
    std::int32_t first, second;
    double clear_until;  // m of travel, as travelled_ counts it, up to which the two cannot touch
  };
  // Finds what is near anew.
  void refresh(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double ahead,
               const DividedLoop& loop);
  // Finds its near segments if it is due.
  void look_at(Candidate& candidate, const CoordinateVectors& coordinates, const std::vector<double>& element_length,
               double reach);
  // Whether the candidates hold all pairs within `reach` (m): no point is so far from where it was then.
  bool has_candidates_for(double reach, const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                          const DividedLoop& loop);
  // False when the state is lost: then there is nothing to look for.
  bool find_candidates(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                       const DividedLoop& loop);
  // Least gap that two elements can have, by their chords and how far the curves are off them, m.
  double least_gap(const CoordinateVectors& coordinates, const std::vector<double>& element_length, std::int32_t first,
                   std::int32_t second) const;
  void add_near_segments(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                         const Candidate& candidate, double reach);
  std::int32_t near_index(std::int32_t element);
  void sort_sides();

  const Model& model_;
  const CordPolyline& polyline_;
  const CordPairs& pairs_;
  MotionBound motion_;
  double broad_margin_;  // m, of the pairs among which candidates are
  std::vector<Candidate> candidates_;
  std::vector<double> group_clear_until_;    // by kGroup candidates: the least clear_until
  double travelled_ = 0;                     // m, way of any point
  double travelled_at_refresh_ = 0;          // when what is near was found
  double displaced_ = 0;                     // m, bound of how far any point is from where it was at candidates_
  CoordinateVectors candidate_coordinates_;  // when candidates_ were found
  std::vector<double> candidate_lengths_;    // m, by element, then
  bool has_candidates_ = false, is_fresh_ = false;
  double reach_ = 0;     // m, within which everything was found near then
  double last_way_ = 0;  // m, of the last step
  std::vector<std::int32_t> near_elements_;
  std::vector<std::int32_t> near_place_;  // by element: in near_elements_, or -1
  std::vector<NearSegments> near_;
  std::vector<NearSide> sides_;
  std::vector<std::pair<std::uint64_t, NearSide>> keyed_sides_;  // for sorting
};

}  // namespace netpocket
