#pragma once
// Finds the places where cords touch one body. A cord is a chain of capsules (cord_polyline.h); contact may occur
// anywhere on it.
//
// Places that bear force. The nodes and middles of elements, half an element apart, are the holders of contact. Where
// halves of elements are longer than the body is thick, holders are a quarter of an element apart. Otherwise one holder
// could have to bear at two edges of the body. Each holder has a weight that falls linearly from one at the holder to
// zero at its neighbours; the weights add up to one. Its contacts are at the places of the capsules in its range where
// weight * depth^2.5 is largest, a product that the energy of a spring is proportional to, and, with a negative share,
// at the vertices between these capsules. What is counted at a vertex for both sides cancels. So a cord on an edge,
// which it touches in one place, meets the same spring in the middle of an element as at a node, and a cord that lies
// on a face touches it once for each holder. The force is the derivative of the springs' energy, which has no kinks.
//
// On spheres larger than an element, and where cords may pass half of a solid's thickness within a step, a holder has
// one contact: where weight * depth^2.5 is largest of all capsules.
//
// Completeness. A point of a cord approaches the body by at most the distance passed to note_way, which is measured
// after each step, not predicted. An element cannot touch the body before this distance exceeds its clearance. See
// THEORY.md, section 6.
//
// World frame, m. Thread contract: one thread at a time.

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/contact/contact_part.h"
#include "engine/contact/segment_batch.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/cord_polyline.h"
#include "engine/dynamics/contact/sphere_touches.h"
#include "engine/model/model.h"

namespace netpocket {

// A place where a cord touches the body.
struct CordTouch {
  CordTouch() {}  // not defaulted: with that, all members would first be set to zero

  std::int32_t element = 0;
  std::int32_t part = 0;     // index into parts()
  std::int32_t holder = 0;   // index of the holder, less than holder_count()
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
  Eigen::Vector3d normal;    // outward from the body
  Eigen::Vector3d point;     // on the cord's axis
};

class ContactSearch {
 public:
  // Usual number of pieces of an element, between a node and the middle.
  static constexpr int kHalves = 2;

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
  std::size_t holder_count() const { return static_cast<std::size_t>(pieces_ + 1) * next_.size(); }
  // The holders before and behind a holder on its cord; -1 for none.
  std::array<std::int32_t, 2> neighbours(std::int32_t holder) const;
  double bounding_radius() const { return bounding_radius_; }
  // `element`: an index of the model's elements or of what fills their last block.
  bool can_touch(std::int32_t element) const { return radius_[static_cast<std::size_t>(element)] > 0; }
  double radius_of(std::int32_t element) const { return radius_[static_cast<std::size_t>(element)]; }  // m, of its cord
  double smallest_radius() const { return smallest_radius_; }                                          // of the cords

 private:
  struct Candidate {
    int segment = -1;  // -1: no candidate
    PieceWeight weight;
    double score;  // estimate of CordTouch::score
  };
  using Contacts = std::array<SegmentContact, CordPolyline::kSegments>;
  using Chain = std::array<Eigen::Vector3d, CordPolyline::kSegments + 1>;

  void look_at_block(std::int32_t block, const CoordinateVectors& coordinates, const ElementBatch& batch,
                     const DynamicBody& body, double ahead);
  // For the elements of a block whose vertices are in rows_.
  void look_at_sphere(std::int32_t block, const DynamicBody& body);
  void look_at_lanes(std::int32_t block, const DynamicBody& body, double ahead);
  Chain chain_of_lane(int lane) const;
  static bool is_touchable(const Model& model, std::int32_t element, std::int32_t body);
  void set_due(std::int32_t block);
  // Enters that the element is at least this distance (m) from a part of the body.
  void note_clearance(std::int32_t element, double clearance);
  void look_at_element(std::int32_t element, const Chain& world, const DynamicBody& body, double ahead);
  void look_at_part(std::int32_t element, std::int32_t part, const Chain& world, const Chain& local,
                    const DynamicBody& body, double ahead);
  Candidate best_in_piece(const Contacts& contacts, double radius, double ahead, int piece, bool towards_end) const;
  // An element near a part of the body.
  struct Meeting {
    std::int32_t element, part;
    const DynamicBody* body;
    double ahead;                                                    // m
    Chain world, local;                                              // world and body axes
    std::array<SurfacePoint, CordPolyline::kSegments + 1> vertices;  // nearest on the part, of `local`
    Contacts contacts;                                               // by capsule
    bool is_near;
    // By side (Side::is_before) and capsule: its place of largest weight * depth^2.5. Only of capsules that touch.
    std::array<std::array<SegmentPlace, CordPolyline::kSegments>, 2> deepest;
  };
  // Pieces of elements side by side: see segment_batch.h.
  void measure_meetings(std::vector<CordTouch>& touches);
  void find_nearest_places(std::int32_t part);
  void find_deepest_places(std::int32_t part);
  // Whether each holder sums its contacts. Else it has only the deepest one.
  bool sums_contacts(const Meeting& meeting) const;
  void add_touches_of(const Meeting& meeting, std::vector<CordTouch>& touches);
  std::span<Meeting> meetings() { return {meetings_.data(), meeting_count_}; }
  void touch(const Meeting& meeting, int holder, const Candidate& candidate, std::vector<CordTouch>& touches);
  // Half of a holder's range: one piece of an element.
  struct Side {
    int holder, piece;
    bool is_before;  // whether the piece ends at the holder; else it starts there
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
  void touch_side(const Meeting& meeting, const Side& side, std::vector<CordTouch>& touches);
  Ends add_capsules(const Meeting& meeting, const Side& side, std::vector<CordTouch>& touches);
  void add_vertices(const Meeting& meeting, const Side& side, const Ends& ends, std::vector<CordTouch>& touches);
  double weight_at(bool is_before, int vertex) const;
  bool is_touching(const Meeting& meeting, int segment) const;
  void add_place(const Meeting& meeting, const Side& side, const CountedPlace& counted,
                 std::vector<CordTouch>& touches);
  // A holder whose contacts are being found.
  struct Open {
    std::int32_t best = -1;       // index of the touch with the highest score
    std::int32_t at_holder = -1;  // index into at_holders_: the contact at the holder itself; -1: none
    int sides = 0, ends = 0;      // sides in contact there; those whose deepest place it is
  };
  static void append(Open& open, const CordTouch& touch, std::vector<CordTouch>& touches);
  void finish_holders(std::vector<CordTouch>& touches);
  void sort_by_block(std::vector<CordTouch>& touches, std::size_t found);
  CordTouch* claim(std::int32_t element, std::int32_t part, int place, double score, std::vector<CordTouch>& touches);
  std::size_t holder_index(std::int32_t element, int holder) const;

  std::vector<ContactPart> parts_;
  double bounding_radius_, smallest_radius_;
  std::vector<contact_kernel::Vertex> vertices_;
  std::vector<std::int32_t> next_, previous_;
  AlignedVector<double> radius_;     // m, by element, in whole blocks; negative: the element cannot touch the body
  AlignedVector<double> due_;        // m, by element, in whole blocks: value of approach_ up to which it cannot touch
  AlignedVector<double> thickness_;  // m, by element: radius of the body's bounding sphere plus that of the cord
  std::vector<double> block_due_;    // by block, in whole blocks of blocks: the least due_
  int pieces_ = kHalves;             // of an element, between its holders: halves or quarters
  bool is_large_sphere_ = false;     // whether the body is a sphere much larger than a capsule
  double least_due_ = 0;             // the least due_ of all elements
  double approach_ = 0;              // m, sum of note_way since forget()
  AlignedVector<double> rows_;       // vertices of one block
  SphereTouches sphere_touches_;
  std::vector<std::int32_t> looked_at_;  // blocks of this search
  std::vector<Meeting> meetings_;        // the first meeting_count_ are of this search; the others keep their memory
  std::size_t meeting_count_ = 0;
  std::vector<PointTask> point_tasks_;
  std::vector<NearestTask> nearest_tasks_;
  std::vector<DeepestTask> deepest_tasks_;
  std::vector<Open> open_;
  std::vector<CordTouch> at_holders_, sorted_;
  // By part and holder: index into open_, or -1.
  std::vector<std::vector<std::int32_t>> holder_touch_;
  std::vector<std::pair<std::int32_t, std::size_t>> taken_;  // part and holder of these entries
};

}  // namespace netpocket
