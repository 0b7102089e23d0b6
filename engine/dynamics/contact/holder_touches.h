#pragma once
// The places of contact of the holders of cords (contact_holders.h) with one body. A holder's contacts are at the
// places of the capsules in its range where weight * depth^2.5 is largest, a product that the energy of a spring is
// proportional to, and, with a negative share, at the vertices between these capsules. What is counted at a vertex for
// both sides cancels. So a cord on an edge, which it touches in one place, meets the same spring in the middle of an
// element as at a node, and a cord that lies on a face touches it once for each holder. The force is the derivative of
// the springs' energy, which has no kinks. See THEORY.md, section 6.
//
// On spheres larger than an element, and where cords may pass half of a solid's thickness within a step, a holder has
// one contact: where weight * depth^2.5 is largest of all capsules.
//
// World frame, m. Thread contract: one thread at a time.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/dynamics/contact/contact_holders.h"
#include "engine/dynamics/contact/contact_meetings.h"
#include "engine/dynamics/contact/cord_touch.h"

namespace netpocket {

class HolderTouches {
 public:
  // `parts`: number of the body's parts. `is_large_sphere`: whether the body is a sphere much larger than a capsule.
  HolderTouches(ContactHolders holders, std::size_t parts, bool is_large_sphere);

  const ContactHolders& holders() const { return holders_; }

  // Enters where a measured element touches a part or is within Meeting::ahead of it. `rotation`: of body axes.
  void add(const Meeting& meeting, const ContactPart& part, const Eigen::Matrix3d& rotation);
  // Replaces `touches` by those that were added, and forgets these. Touches of elements that are computed together come
  // together; otherwise they have the order of add.
  void take(std::vector<CordTouch>& touches);

 private:
  struct Candidate {
    int segment = -1;  // -1: no candidate
    PieceWeight weight{};
    double score = 0;  // estimate of CordTouch::score
  };
  // Half of a holder's range: one piece of an element.
  struct Side {
    int place, piece;  // of the holder; of the element
    bool is_before;    // whether the piece ends at the holder; else it starts there
  };
  // A place and how often the energy there counts.
  struct CountedPlace {
    int segment;
    SegmentPlace place;
    double weight;
    int count, number;  // `number` tells the places of a holder apart
  };
  // By vertex of a piece: number of capsules whose deepest place it is.
  using Ends = std::array<int, CordPolyline::kSegments + 1>;
  // A holder whose contacts are being found.
  struct Open {
    std::int32_t best = -1;       // index of the touch with the highest score
    std::int32_t at_holder = -1;  // index into at_holders_: the contact at the holder itself; -1: none
    int sides = 0, ends = 0;      // sides in contact there; those whose deepest place it is
  };

  Candidate best_in_piece(const Meeting& meeting, int piece, bool towards_end) const;
  void add_best(const Meeting& meeting, int place, const Candidate& candidate);
  void add_side(const Meeting& meeting, const Side& side);
  Ends add_capsules(const Meeting& meeting, const Side& side);
  void add_vertices(const Meeting& meeting, const Side& side, const Ends& ends);
  void add_place(const Meeting& meeting, const Side& side, const CountedPlace& counted);
  void append(Open& open, const CordTouch& touch);
  CordTouch* claim(const Meeting& meeting, int place, double score);
  // The entry of a holder; a new one has no touch.
  Open& open(std::int32_t part, std::size_t holder);
  void add_vertices_at_holders();
  void sort_by_block(std::size_t found);

  ContactHolders holders_;
  bool is_large_sphere_;
  const ContactPart* part_ = nullptr;          // of the element that is being added
  const Eigen::Matrix3d* rotation_ = nullptr;  // likewise
  std::vector<CordTouch> touches_;
  std::vector<Open> open_;
  std::vector<CordTouch> at_holders_, sorted_;
  // By part and holder: index into open_, or -1.
  std::vector<std::vector<std::int32_t>> entry_;
  std::vector<std::pair<std::int32_t, std::size_t>> taken_;  // part and holder of these entries
};

}  // namespace netpocket
