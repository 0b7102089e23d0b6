#pragma once
// Finds the places where cords touch one body. A cord is a chain of capsules (cord_polyline.h); contact may occur
// anywhere on it. Which places of it bear force: holder_touches.h.
//
// Completeness. A point of a cord approaches the body by at most the distance passed to note_way, which is measured
// after each step, not predicted. An element cannot touch the body before this distance exceeds its clearance. See
// THEORY.md, section 6.
//
// World frame, m. Thread contract: one thread at a time.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/contact/contact_part.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contact_meetings.h"
#include "engine/dynamics/contact/cord_touch.h"
#include "engine/dynamics/contact/holder_touches.h"
#include "engine/dynamics/contact/sphere_touches.h"
#include "engine/model/model.h"

namespace netpocket {

class ContactSearch {
 public:
  // `next`: by element, the element that continues its cord, or -1.
  ContactSearch(const Model& model, std::span<const std::int32_t> next, std::int32_t body);

  // To be called when anything has moved in another way than note_way was told: after a displacement or a restored
  // state.
  void forget();
  // To be called after each step. `way`: upper bound (m) of the distance by which any point of a cord has approached
  // any point of the body in it.
  void note_way(double way) { approach_ += way; }

  // Finds all places where cords touch the body or are within `ahead` (m) of it: those on a large sphere without a
  // search ahead are sphere_touches(), others replace `touches`. `batch`: the model's elements with their present
  // lengths. The order of the places does not depend on earlier calls and is the same in every sector.
  void find(const CoordinateVectors& coordinates, const ElementBatch& batch, const DynamicBody& body, double ahead,
            std::vector<CordTouch>& touches);

  const SphereTouches& sphere_touches() const { return sphere_touches_; }

  const std::vector<ContactPart>& parts() const { return parts_; }
  const std::vector<contact_kernel::Vertex>& vertices() const { return vertices_; }  // of the capsule chains
  const ContactHolders& holders() const { return touches_.holders(); }
  double bounding_radius() const { return bounding_radius_; }
  // `element`: an index of the model's elements or of what fills their last block.
  bool can_touch(std::int32_t element) const { return radius_[static_cast<std::size_t>(element)] > 0; }
  double radius_of(std::int32_t element) const { return radius_[static_cast<std::size_t>(element)]; }  // m, of its cord
  double smallest_radius() const { return smallest_radius_; }                                          // of the cords

 private:
  using Chain = Meeting::Chain;

  void look_at_block(std::int32_t block, const CoordinateVectors& coordinates, const ElementBatch& batch,
                     const DynamicBody& body, double ahead);
  // For the elements of a block whose vertices are in rows_.
  void look_at_sphere(std::int32_t block, const DynamicBody& body);
  void look_at_lanes(std::int32_t block, const DynamicBody& body, double ahead);
  Chain chain_of_lane(int lane) const;
  void look_at_element(std::int32_t element, const Chain& world, const DynamicBody& body, double ahead);
  void look_at_part(std::int32_t element, std::int32_t part, const Chain& world, const Chain& local, double ahead);
  // Measures the elements near the body, and enters where they touch it.
  void measure_meetings(const DynamicBody& body);
  void set_due(std::int32_t block);
  // Enters that the element is at least this distance (m) from a part of the body.
  void note_clearance(std::int32_t element, double clearance);

  std::vector<ContactPart> parts_;
  AlignedVector<double> radius_;  // m, by element, in whole blocks; negative: the element cannot touch the body
  double bounding_radius_, smallest_radius_;
  bool is_large_sphere_;  // whether the body is a sphere much larger than a capsule
  std::vector<contact_kernel::Vertex> vertices_;
  AlignedVector<double> due_;        // m, by element, in whole blocks: value of approach_ up to which it cannot touch
  AlignedVector<double> thickness_;  // m, by element: radius of the body's bounding sphere plus that of the cord
  std::vector<double> block_due_;    // by block, in whole blocks of blocks: the least due_
  double least_due_ = 0;             // the least due_ of all elements
  double approach_ = 0;              // m, sum of note_way since forget()
  AlignedVector<double> rows_;       // vertices of one block
  std::vector<std::int32_t> looked_at_;  // blocks of this search
  ContactMeetings meetings_;             // of this search
  HolderTouches touches_;
  SphereTouches sphere_touches_;
};

}  // namespace netpocket
