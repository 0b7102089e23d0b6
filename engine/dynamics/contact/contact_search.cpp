#include "engine/dynamics/contact/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/dynamics/contact/cord_chain.h"
#include "engine/dynamics/contact/cord_polyline.h"
#include "engine/math/instruction_set.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kSegments = CordPolyline::kSegments;

// A sphere is large if its radius exceeds this many lengths of the longest element. Then parabolas approximate its
// surface along a capsule.
constexpr double kLargeSphere = 1;

// Cords that may pass more than this part of a solid's thickness in a step are to be stopped. Each holder then has only
// the place where it is deepest.
constexpr double kFastWay = 0.5;

// Elements beside an attachment cannot touch the body if the cord between is shorter than this many diameters.
constexpr double kNeighbourhood = 2;

struct SearchKernels {
  contact_kernel::VertexKernel vertices;
  sphere_kernel::PlacesKernel sphere;
};

const SearchKernels& search_kernels() {
  static const SearchKernels chosen = {NETPOCKET_VARIANT_OF(contact_kernel, vertices),
                                       NETPOCKET_VARIANT_OF(sphere_kernel, places)};
  return chosen;
}

// Of eight values, without long chains of comparisons. A value that is no number may be missed.
double least_of(const double* values) {
  double least[4];
  for (int i = 0; i < 4; ++i) least[i] = values[i + 4] < values[i] ? values[i + 4] : values[i];
  for (int i = 0; i < 2; ++i) least[i] = least[i + 2] < least[i] ? least[i + 2] : least[i];
  return least[1] < least[0] ? least[1] : least[0];
}

}  // namespace

bool are_locked(const Model& model, std::int32_t a, std::int32_t b) {
  return std::ranges::any_of(model.locks, [&](const BodyLock& lock) {
    return (lock.carrier == a && lock.carried == b) || (lock.carrier == b && lock.carried == a);
  });
}

namespace {

// Takes off what an element joins to the body, and what continues it within kNeighbourhood diameters.
void exclude(const Model& model, std::int32_t element, std::span<const std::int32_t> continuation,
             AlignedVector<double>& radius) {
  const double reach = kNeighbourhood * 2 * model.radius_of(element);
  double way = 0;
  do {
    radius[static_cast<std::size_t>(element)] = -1;
    way += model.elements[static_cast<std::size_t>(element)].length;
    element = continuation[static_cast<std::size_t>(element)];
  } while (element >= 0 && way < reach);
}

// By element, in whole blocks, the radius (m) of those that can touch the body, else -1. An element with a node on the
// body, or on one that is locked to it at the start, is excluded: its attachment already connects it with the body. So
// are those beside it: a thick rod that stands on a face is in that face there.
AlignedVector<double> touchable_radii(const Model& model, std::span<const std::int32_t> next, std::int32_t body) {
  AlignedVector<double> radius((model.elements.size() + kBlockSize - 1) / kBlockSize * kBlockSize, -1.0);
  if (!model.bodies[static_cast<std::size_t>(body)].touches_cables) return radius;
  const std::vector<std::int32_t> previous = previous_elements({next.begin(), next.end()});
  const auto is_attached = [&](std::int32_t node) {
    const ModelNode& n = model.nodes[static_cast<std::size_t>(node)];
    return n.support == Support::body && (n.body == body || are_locked(model, n.body, body));
  };
  const auto count = static_cast<std::int32_t>(model.elements.size());
  for (std::int32_t i = 0; i < count; ++i) {
    if (model.radius_of(i) > 0) radius[static_cast<std::size_t>(i)] = model.radius_of(i);
  }
  for (std::int32_t i = 0; i < count; ++i) {
    const ModelElement& element = model.elements[static_cast<std::size_t>(i)];
    if (is_attached(element.node1)) exclude(model, i, next, radius);
    if (is_attached(element.node2)) exclude(model, i, previous, radius);
  }
  return radius;
}

// Length (m) of the longest element that can touch the body.
double longest_element(const Model& model, const AlignedVector<double>& radius) {
  double longest = 0;
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    if (radius[i] > 0) longest = std::max(longest, model.elements[i].length);
  }
  return longest;
}

int pieces_of(double longest_element, const std::vector<ContactPart>& parts) {
  double thinnest = kNever;
  for (const ContactPart& part : parts) thinnest = std::min(thinnest, part.thickness);
  return longest_element > ContactHolders::kHalves * thinnest ? kSegments : ContactHolders::kHalves;
}

}  // namespace

ContactSearch::ContactSearch(const Model& model, std::span<const std::int32_t> next, std::int32_t body)
    : parts_(contact_parts(model.bodies[static_cast<std::size_t>(body)].shape, model.contact.edge_radius)),
      radius_(touchable_radii(model, next, body)),
      bounding_radius_(netpocket::bounding_radius(model.bodies[static_cast<std::size_t>(body)].shape)),
      smallest_radius_(kNever),
      is_large_sphere_(std::holds_alternative<Sphere>(parts_.front().solid) &&
                       bounding_radius_ > kLargeSphere * longest_element(model, radius_)),
      touches_(ContactHolders(next, pieces_of(longest_element(model, radius_), parts_)), parts_.size(),
               is_large_sphere_),
      sphere_touches_(holders().next_elements(), holders().previous_elements()) {
  for (int i = 0; i <= kSegments; ++i) {
    const NodalWeights weights = shape(2.0 * i / kSegments - 1, 1.0);
    vertices_.push_back({weights[0], weights[1], weights[2], weights[3]});
  }
  due_.assign(radius_.size(), kNever);
  const std::size_t blocks = radius_.size() / kBlockSize;
  block_due_.assign((blocks + kBlockSize - 1) / kBlockSize * kBlockSize, kNever);
  for (const double radius : radius_) {
    if (radius > 0) smallest_radius_ = std::min(smallest_radius_, radius);
    thickness_.push_back(bounding_radius_ + std::max(radius, 0.0));
  }
  rows_.resize(static_cast<std::size_t>((kSegments + 1) * kVectorRows + 1) * kBlockSize);
  forget();
}

void ContactSearch::forget() {
  approach_ = 0;
  for (std::size_t i = 0; i < due_.size(); ++i) due_[i] = radius_[i] > 0 ? 0 : kNever;
  for (std::size_t block = 0; block < due_.size() / kBlockSize; ++block) set_due(static_cast<std::int32_t>(block));
  least_due_ = 0;
}

void ContactSearch::set_due(std::int32_t block) {
  block_due_[static_cast<std::size_t>(block)] = least_of(due_.data() + static_cast<std::ptrdiff_t>(block) * kBlockSize);
}

void ContactSearch::look_at_block(std::int32_t block, const CoordinateVectors& coordinates, const ElementBatch& batch,
                                  const DynamicBody& body, double ahead) {
  const Vector3d centre = body.centre();
  search_kernels().vertices(batch.block(block), vertices_.data(), vertices_.size(), coordinates.rows(), centre.data(),
                            rows_.data());
  if (is_large_sphere_ && ahead == 0 && holders().pieces() == ContactHolders::kHalves) {
    look_at_sphere(block, body);
  } else {
    look_at_lanes(block, body, ahead);
  }
  looked_at_.push_back(block);
}

void ContactSearch::find(const CoordinateVectors& coordinates, const ElementBatch& batch, const DynamicBody& body,
                         double ahead, std::vector<CordTouch>& touches) {
  touches.clear();
  sphere_touches_.clear();
  const double limit = approach_ + ahead;
  if (least_due_ > limit) return;
  for (std::size_t first = 0; first < block_due_.size(); first += kBlockSize) {
    if (least_of(&block_due_[first]) > limit) continue;
    // In a diverged state even the padding is due.
    const std::size_t last = std::min(first + kBlockSize, due_.size() / kBlockSize);
    for (std::size_t block = first; block < last; ++block) {
      if (block_due_[block] > limit) continue;
      look_at_block(static_cast<std::int32_t>(block), coordinates, batch, body, ahead);
    }
  }
  measure_meetings(body);
  for (const std::int32_t block : looked_at_) set_due(block);
  looked_at_.clear();
  least_due_ = kNever;
  for (std::size_t first = 0; first < block_due_.size(); first += kBlockSize) {
    least_due_ = std::min(least_due_, least_of(&block_due_[first]));
  }
  touches_.take(touches);
}

void ContactSearch::measure_meetings(const DynamicBody& body) {
  meetings_.measure(parts_, holders());
  for (const Meeting& meeting : meetings_.found()) {
    note_clearance(meeting.element, meeting.clearance());
    if (!meeting.is_near) continue;
    touches_.add(meeting, parts_[static_cast<std::size_t>(meeting.part)], body.rigid().rotation());
  }
  meetings_.clear();
}

ContactSearch::Chain ContactSearch::chain_of_lane(int lane) const {
  Chain chain;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double* row = rows_.data() + i * kVectorRows * kBlockSize + lane;
    chain[i] = {row[0], row[kBlockSize], row[2 * kBlockSize]};
  }
  return chain;
}

// Equals look_at_lanes to round-off, for eight elements at once.
void ContactSearch::look_at_sphere(std::int32_t block, const DynamicBody& body) {
  const Vector3d centre = body.centre();
  const std::size_t first = static_cast<std::size_t>(block) * kBlockSize;
  const double* thickness = thickness_.data() + first;
  bool is_near = false;
  const double* from_centre = rows_.data() + (kSegments + 1) * kVectorRows * kBlockSize;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const std::size_t element = first + static_cast<std::size_t>(lane);
    const double clearance = from_centre[lane] - thickness[lane];
    is_near = is_near || (radius_[element] > 0 && !(clearance > 0));
    if (radius_[element] > 0) due_[element] = approach_ + std::max(clearance, 0.0);
  }
  if (!is_near) return;
  sphere_kernel::SpherePlaces places;
  search_kernels().sphere(rows_.data(), centre.data(), thickness, places);
  std::uint32_t near = 0;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const std::size_t element = first + static_cast<std::size_t>(lane);
    if (radius_[element] < 0) continue;
    const double clearance = places.clearance[lane];
    due_[element] = clearance > 0 ? approach_ + clearance : approach_;
    if (!(clearance > 0)) near |= 1U << lane;
  }
  if (near != 0) sphere_touches_.add(block, places, near);
}

void ContactSearch::look_at_lanes(std::int32_t block, const DynamicBody& body, double ahead) {
  const double* from_centre = rows_.data() + (kSegments + 1) * kVectorRows * kBlockSize;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const std::int32_t element = block * kBlockSize + lane;
    const double radius = radius_[static_cast<std::size_t>(element)];
    if (radius < 0 || due_[static_cast<std::size_t>(element)] > approach_ + ahead) continue;
    due_[static_cast<std::size_t>(element)] = kNever;
    const double clearance = from_centre[lane] - bounding_radius_ - radius;
    if (clearance > ahead) {
      note_clearance(element, clearance);
    } else {
      look_at_element(element, chain_of_lane(lane), body, ahead);
    }
  }
}

// A clearance that is no number leaves the element due.
void ContactSearch::note_clearance(std::int32_t element, double clearance) {
  double& due = due_[static_cast<std::size_t>(element)];
  due = std::min(due, clearance > 0 ? approach_ + clearance : approach_);
}

void ContactSearch::look_at_element(std::int32_t element, const Chain& world, const DynamicBody& body, double ahead) {
  Chain local;
  for (std::size_t i = 0; i < local.size(); ++i) {
    local[i] = symmetric_transposed_product(body.rigid().rotation(), world[i] - body.centre());
  }
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    look_at_part(element, static_cast<std::int32_t>(part), world, local, ahead);
  }
}

void ContactSearch::look_at_part(std::int32_t element, std::int32_t part, const Chain& world, const Chain& local,
                                 double ahead) {
  const ContactPart& solid = parts_[static_cast<std::size_t>(part)];
  const double radius = radius_[static_cast<std::size_t>(element)];
  if (parts_.size() > 1) {
    double nearest = kNever, longest = 0;
    for (std::size_t i = 0; i < local.size(); ++i) {
      nearest = std::min(nearest, symmetric_norm(local[i] - solid.centre));
      if (i > 0) longest = std::max(longest, symmetric_norm(local[i] - local[i - 1]));
    }
    const double clearance = nearest - 0.5 * longest - solid.bounding_radius - radius;
    if (clearance > ahead) {
      note_clearance(element, clearance);
      return;
    }
  }
  Meeting& meeting = meetings_.append();
  meeting.element = element;
  meeting.part = part;
  meeting.radius = radius;
  meeting.ahead = ahead;
  meeting.sums_contacts = !is_large_sphere_ && ahead <= kFastWay * solid.thickness;
  meeting.world = world;
  meeting.local = local;
}

}  // namespace netpocket
