#pragma once
// Finds the pairs of capsules on cords that may touch each other in the next steps.
//
// Three lists, each a subset of the one before:
// 1. Candidates: pairs of elements within broad_margin() of each other. Made seldom, by a sweep over boxes
// (near_pairs.h).
// 2. Near elements: candidates within a reach of a few centimetres. A candidate is measured again only when the motion
//    since the last measurement could have closed its gap.
// 3. Near capsules: pairs of capsules on near elements. The caller tests these at every step.
//
// Completeness. A list contains every pair within its margin at the time it was made. Two cords approach each other by
// at most twice the distance that any point has moved. That distance is measured after each step (note_way), not
// predicted. A list is made again before twice the distance exceeds its margin, so no pair that touches is missing.
// Predicted speeds only choose the size of margins.
//
// The lists may contain more pairs than needed, which depends on earlier steps. The order of pairs does not.

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

  // To be called when positions have changed in another way than by a step: after a displacement or a restored state.
  void forget();

  // To be called after each step. `way`: upper bound (m) of the distance that any point of a cord has moved in it.
  void note_way(double way);
  // Brings the lists up to date; to be called at every step before near() is used. Then near() contains all capsules
  // within `ahead` (m, at most broad_margin()) of each other. `element_length` in m, by element. `loop`: threads that
  // share the work of making candidates.
  void update(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double ahead,
              const DividedLoop& loop);
  double broad_margin() const { return broad_margin_; }
  // Whether update() with this `ahead` looks at coordinates.
  bool is_due(double ahead) const {
    return !is_fresh_ || !(2 * (travelled_ - travelled_at_refresh_) + ahead <= reach_);
  }

  std::span<const std::int32_t> near_elements() const { return near_elements_; }
  std::span<const NearSegments> near() const { return near_; }
  // Both sides of near(), in an order that is the same in every sector of a pocket (index = local * 8 + sector). Sorted
  // by the side's own local element, the other local element, the number of sectors between them, and their segments.
  std::span<const NearSide> sides() const { return sides_; }

 private:
  struct Candidate {
    std::int32_t first, second;
    double clear_until;  // value of travelled_ (m) up to which the two cannot touch
  };
  // Makes the lists of near elements and capsules again.
  void refresh(const CoordinateVectors& coordinates, const std::vector<double>& element_length, double ahead,
               const DividedLoop& loop);
  // Measures the candidate if it is due, and adds its capsules to near_ if they are within `reach` (m).
  void look_at(Candidate& candidate, const CoordinateVectors& coordinates, const std::vector<double>& element_length,
               double reach);
  // Whether the candidates contain all pairs within `reach` (m).
  bool has_candidates_for(double reach, const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                          const DividedLoop& loop);
  // Returns false if the state has diverged.
  bool find_candidates(const CoordinateVectors& coordinates, const std::vector<double>& element_length,
                       const DividedLoop& loop);
  // Lower bound (m) of the gap between two elements, from the distance of their chords and the deviations of the
  // curves.
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
  double broad_margin_;  // m, largest gap of the pairs among the candidates
  std::vector<Candidate> candidates_;
  std::vector<double> group_clear_until_;    // by group of kGroup candidates: the least clear_until
  double travelled_ = 0;                     // m, path length of any point since candidates_ were found
  double travelled_at_refresh_ = 0;          // m, travelled_ when near_ was found
  double displaced_ = 0;                     // m, upper bound of any point's displacement since candidates_ were found
  CoordinateVectors candidate_coordinates_;  // at which candidates_ were found
  std::vector<double> candidate_lengths_;    // m, by element, likewise
  bool has_candidates_ = false, is_fresh_ = false;
  double reach_ = 0;     // m, gap within which near_ was complete when it was found
  double last_way_ = 0;  // m, of the last step
  std::vector<std::int32_t> near_elements_;
  std::vector<std::int32_t> near_place_;  // by element: index into near_elements_, or -1
  std::vector<NearSegments> near_;
  std::vector<NearSide> sides_;
  std::vector<std::pair<std::uint64_t, NearSide>> keyed_sides_;  // for sorting
};

}  // namespace netpocket
