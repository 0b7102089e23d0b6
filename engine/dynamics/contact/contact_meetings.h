#pragma once
// Elements near parts of a body, and where their capsules are nearest and deepest. The capsules of all elements near
// one part are measured side by side (segment_batch.h).
//
// Thread contract: one thread at a time.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/contact/contact_part.h"
#include "engine/contact/segment_batch.h"
#include "engine/dynamics/contact/contact_holders.h"
#include "engine/dynamics/contact/cord_polyline.h"

namespace netpocket {

// An element near a part of the body. What measure() sets is marked so.
struct Meeting {
  using Chain = CordPolyline::Vertices;

  std::int32_t element, part;
  double radius;       // m, of the cord
  double ahead;        // m, distance from the cord's surface within which places count
  bool sums_contacts;  // whether each holder sums its contacts; else it has only the deepest one
  Chain world, local;  // m, vertices of the capsules, world frame and body axes
  std::array<SurfacePoint, CordPolyline::kSegments + 1> vertices;  // measured: nearest on the part, of `local`
  std::array<SegmentContact, CordPolyline::kSegments> contacts;    // measured: by capsule
  bool is_near;                                                    // measured: whether any capsule is
  // Measured: by side (whether its piece ends at the holder) and capsule, its place of largest weight * depth^2.5. Only
  // of capsules that touch, and if contacts are summed.
  std::array<std::array<SegmentPlace, CordPolyline::kSegments>, 2> deepest;

  bool is_touching(int segment) const {
    const SegmentContact& contact = contacts[static_cast<std::size_t>(segment)];
    return contact.is_near && contact.distance < radius;
  }
  // Least distance (m) of the cord's surface from the part; infinite where no distance is a number.
  double clearance() const;
};

class ContactMeetings {
 public:
  void clear() { count_ = 0; }
  // The new meeting has any content.
  Meeting& append();
  void measure(std::span<const ContactPart> parts, const ContactHolders& holders);
  std::span<const Meeting> found() const { return {meetings_.data(), count_}; }

 private:
  std::span<Meeting> all() { return {meetings_.data(), count_}; }
  void find_nearest_places(std::int32_t part, const ContactPart& solid);
  void find_deepest_places(std::int32_t part, const ContactPart& solid, const ContactHolders& holders);

  std::vector<Meeting> meetings_;  // those behind the first count_ keep their memory
  std::size_t count_ = 0;
  std::vector<PointTask> point_tasks_;
  std::vector<NearestTask> nearest_tasks_;
  std::vector<DeepestTask> deepest_tasks_;
};

}  // namespace netpocket
