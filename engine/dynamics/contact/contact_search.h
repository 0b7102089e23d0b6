#pragma once
// Where cords touch one body. A cord is a chain of capsules (cord_polyline.h), and every place of it counts.
//
// Which places bear force. Points half an element apart, its nodes and its middle, share the cord between them: each
// has a weight that falls in a straight line from one to zero at its neighbours. It touches where weight * depth^2.5,
// which its spring's energy is proportional to, is largest. The weights add up to one. So a cord on an edge, which is
// touched in one place, is touched by the same spring wherever that is, in the middle of an element or at a node, and a
// cord that lies on a face is touched once by each point. The force is the derivative of the springs' energy, since the
// energy does not depend on the place to first order.
//
// The search is complete. No point of a cord comes nearer to the body than by the way that note_way is told of, which
// is what has really moved; an element whose clearance is not used up cannot touch. See THEORY.md, section 6.
//
// World frame, m. Thread contract: one thread at a time.

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/contact/contact_part.h"
#include "engine/contact/segment_contact.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/cord_polyline.h"
#include "engine/model/model.h"

namespace netpocket {

// A place where a cord touches the body.
struct CordTouch {
  std::int32_t element = 0;
  std::int32_t part = 0;     // of the body
  std::int32_t segment = 0;  // of the element
  double t = 0;              // of the way along the segment
  double share = 0;          // weight, 0 to 1
  double penetration = 0;    // m; negative: still apart
  bool is_cord_end = false;  // whether it belongs to an end of the cord
  double score = 0;          // grows with share * penetration^2.5; of places still apart it is negative
  Eigen::Vector3d normal;    // outward from the body
  Eigen::Vector3d point;     // of the axis
};

class ContactSearch {
 public:
  // Half elements: between a node and the middle.
  static constexpr int kHalves = 2;

  // `next`: by element, the one that goes on with its cord, or -1.
  ContactSearch(const Model& model, std::span<const std::int32_t> next, std::int32_t body);

  // To be called when anything has moved other than by what note_way was told.
  void forget();
  // No point of a cord has come nearer to any point of the body than by `way` since the last call.
  void note_way(double way) { approach_ += way; }

  // All places where cords touch the body, and those that are within `ahead` of it. `batch`: the model's elements with
  // their present lengths. Their order does not depend on what was asked before and is the same in every sector.
  void find(const CoordinateVectors& coordinates, const ElementBatch& batch, const DynamicBody& body, double ahead,
            std::vector<CordTouch>& touches);

  const std::vector<ContactPart>& parts() const { return parts_; }
  double bounding_radius() const { return bounding_radius_; }
  double smallest_radius() const { return smallest_radius_; }  // of the cords

 private:
  // The points that share an element: its first node, its middle, its second node.
  enum Holder : std::uint8_t { kFirst, kMiddle, kSecond };
  struct Candidate {
    int segment = -1;  // -1: none
    PieceWeight weight;
    double score;  // estimated, as CordTouch::score
  };
  using Contacts = std::array<SegmentContact, CordPolyline::kSegments>;
  using Chain = std::array<Eigen::Vector3d, CordPolyline::kSegments + 1>;

  // Of a block whose vertices are in rows_.
  void look_at_sphere(std::int32_t block, const DynamicBody& body, std::vector<CordTouch>& touches);
  void look_at_lanes(std::int32_t block, const DynamicBody& body, double ahead, std::vector<CordTouch>& touches);
  Chain chain_of_lane(int lane) const;
  static bool is_touchable(const Model& model, std::int32_t element, std::int32_t body);
  void set_due(std::int32_t block);
  double look_at_element(std::int32_t element, const Chain& world, const DynamicBody& body, double ahead,
                         std::vector<CordTouch>& touches);
  double look_at_part(std::int32_t element, std::int32_t part, const Chain& world, const Chain& local,
                      const DynamicBody& body, double ahead, std::vector<CordTouch>& touches);
  static Candidate best_in_half(const Contacts& contacts, double radius, double ahead, int half, bool towards_end);
  // An element and a part of the body near it.
  struct Meeting {
    std::int32_t element, part;
    const Chain &world, &local;
    const Contacts& contacts;
    const DynamicBody& body;
    double ahead;  // m
  };
  void touch(const Meeting& meeting, Holder holder, const Candidate& candidate, std::vector<CordTouch>& touches);
  void add(Holder holder, CordTouch touch, std::vector<CordTouch>& touches);
  std::size_t holder_index(std::int32_t element, Holder holder) const;

  std::vector<ContactPart> parts_;
  double bounding_radius_, smallest_radius_;
  std::vector<contact_kernel::Vertex> vertices_;
  std::vector<std::int32_t> next_, previous_;
  AlignedVector<double> radius_;   // m, by element; negative: it cannot touch the body; whole blocks
  AlignedVector<double> due_;      // by element: value of approach_ up to which it cannot touch, m; whole blocks
  std::vector<double> block_due_;  // by block: the least of these
  bool is_large_sphere_ = false;   // the body, against the capsules
  double least_due_ = 0;           // of all
  double approach_ = 0;            // m
  AlignedVector<double> rows_;     // of one block
  // By part and holder: place in the touches that are being found, or -1.
  std::vector<std::vector<std::int32_t>> holder_touch_;
  std::vector<std::pair<std::int32_t, std::size_t>> taken_;  // part and holder of these
};

}  // namespace netpocket
