#include "engine/dynamics/contact/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/dynamics/contact/cord_chain.h"
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

// Below the scores of places that touch, in the same order.
double score_apart(const WeightedPlace& place) {
  return -1 / (std::numeric_limits<double>::min() + std::max(place.score(), 0.0));
}

}  // namespace

ContactSearch::ContactSearch(const Model& model, std::span<const std::int32_t> next, std::int32_t body)
    : parts_(contact_parts(model.bodies[static_cast<std::size_t>(body)].shape, model.contact.edge_radius)),
      bounding_radius_(netpocket::bounding_radius(model.bodies[static_cast<std::size_t>(body)].shape)),
      smallest_radius_(kNever),
      next_(next.begin(), next.end()),
      previous_(previous_elements(next_)),
      sphere_touches_(next_, previous_) {
  for (int i = 0; i <= kSegments; ++i) {
    const NodalWeights weights = shape(2.0 * i / kSegments - 1, 1.0);
    vertices_.push_back({weights[0], weights[1], weights[2], weights[3]});
  }
  const std::size_t padded = (model.elements.size() + kBlockSize - 1) / kBlockSize * kBlockSize;
  radius_.assign(padded, -1.0);
  due_.assign(padded, kNever);
  const std::size_t blocks = padded / kBlockSize;
  block_due_.assign((blocks + kBlockSize - 1) / kBlockSize * kBlockSize, kNever);
  double longest = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(model.elements.size()); ++i) {
    if (!is_touchable(model, i, body)) continue;
    radius_[static_cast<std::size_t>(i)] = model.radius_of(i);
    smallest_radius_ = std::min(smallest_radius_, model.radius_of(i));
    longest = std::max(longest, model.elements[static_cast<std::size_t>(i)].length);
  }
  for (const double radius : radius_) thickness_.push_back(bounding_radius_ + std::max(radius, 0.0));
  rows_.resize(static_cast<std::size_t>((kSegments + 1) * kVectorRows + 1) * kBlockSize);
  is_large_sphere_ = std::holds_alternative<Sphere>(parts_.front().solid) && bounding_radius_ > kLargeSphere * longest;
  double thinnest = kNever;
  for (const ContactPart& part : parts_) thinnest = std::min(thinnest, part.thickness);
  pieces_ = longest > kHalves * thinnest ? kSegments : kHalves;
  holder_touch_.resize(parts_.size());
  forget();
}

bool are_locked(const Model& model, std::int32_t a, std::int32_t b) {
  return std::ranges::any_of(model.locks, [&](const BodyLock& lock) {
    return (lock.carrier == a && lock.carried == b) || (lock.carrier == b && lock.carried == a);
  });
}

// An element with a node on the body, or on one that is locked to it at the start, is excluded: its attachment already
// connects it with the body.
bool ContactSearch::is_touchable(const Model& model, std::int32_t element, std::int32_t body) {
  const ModelElement& e = model.elements[static_cast<std::size_t>(element)];
  const auto is_attached = [&](std::int32_t node) {
    const ModelNode& n = model.nodes[static_cast<std::size_t>(node)];
    return n.support == Support::body && (n.body == body || are_locked(model, n.body, body));
  };
  return model.bodies[static_cast<std::size_t>(body)].touches_cables && !is_attached(e.node1) &&
         !is_attached(e.node2) && model.radius_of(element) > 0;
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
  if (is_large_sphere_ && ahead == 0 && pieces_ == kHalves) {
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
  measure_meetings(touches);
  for (const std::int32_t block : looked_at_) set_due(block);
  looked_at_.clear();
  least_due_ = kNever;
  for (std::size_t first = 0; first < block_due_.size(); first += kBlockSize) {
    least_due_ = std::min(least_due_, least_of(&block_due_[first]));
  }
  if (!is_large_sphere_) finish_holders(touches);
  open_.clear();
  at_holders_.clear();
  for (const auto& [part, holder] : taken_) holder_touch_[static_cast<std::size_t>(part)][holder] = -1;
  taken_.clear();
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

// In a diverged state the clearance is NaN. The element then stays due.
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
    look_at_part(element, static_cast<std::int32_t>(part), world, local, body, ahead);
  }
}

void ContactSearch::look_at_part(std::int32_t element, std::int32_t part, const Chain& world, const Chain& local,
                                 const DynamicBody& body, double ahead) {
  const ContactPart& solid = parts_[static_cast<std::size_t>(part)];
  if (parts_.size() > 1) {
    double nearest = kNever, longest = 0;
    for (std::size_t i = 0; i < local.size(); ++i) {
      nearest = std::min(nearest, symmetric_norm(local[i] - solid.centre));
      if (i > 0) longest = std::max(longest, symmetric_norm(local[i] - local[i - 1]));
    }
    const double radius = radius_[static_cast<std::size_t>(element)];
    const double clearance = nearest - 0.5 * longest - solid.bounding_radius - radius;
    if (clearance > ahead) {
      note_clearance(element, clearance);
      return;
    }
  }
  if (meeting_count_ == meetings_.size()) meetings_.emplace_back();
  Meeting& meeting = meetings_[meeting_count_++];
  meeting.element = element;
  meeting.part = part;
  meeting.body = &body;
  meeting.ahead = ahead;
  meeting.world = world;
  meeting.local = local;
}

// The segment with the highest score in one piece of the element, for the holder at that piece's end or start.
ContactSearch::Candidate ContactSearch::best_in_piece(const Contacts& contacts, double radius, double ahead, int piece,
                                                      bool towards_end) const {
  Candidate best{};
  best.segment = -1;
  if (piece < 0 || piece >= pieces_) return best;
  const int segments = kSegments / pieces_;
  for (int i = 0; i < segments; ++i) {
    const int segment = piece * segments + i;
    const SegmentContact& contact = contacts[static_cast<std::size_t>(segment)];
    if (!contact.is_near) continue;
    const double from = static_cast<double>(i) / segments, to = static_cast<double>(i + 1) / segments;
    const PieceWeight weight = towards_end ? PieceWeight{from, to} : PieceWeight{1 - from, 1 - to};
    const double score = contact.distance < radius ? estimate_deepest(contact, radius, weight).score()
                                                   : score_apart(estimate_deepest(contact, radius + ahead, weight));
    if (best.segment < 0 || score > best.score) best = {segment, weight, score};
  }
  return best;
}

// Elements that continue each other share the holder at their node. An element owns the holders at its first node and
// its middle, and at its second node only where its cord ends.
std::size_t ContactSearch::holder_index(std::int32_t element, int holder) const {
  const auto holders = static_cast<std::size_t>(pieces_ + 1);
  const std::int32_t next = next_[static_cast<std::size_t>(element)];
  if (holder == pieces_ && next >= 0) return static_cast<std::size_t>(next) * holders;
  return static_cast<std::size_t>(element) * holders + static_cast<std::size_t>(holder);
}

std::array<std::int32_t, 2> ContactSearch::neighbours(std::int32_t holder) const {
  const std::int32_t element = holder / (pieces_ + 1), place = holder % (pieces_ + 1);
  const std::int32_t previous = previous_[static_cast<std::size_t>(element)];
  const std::int32_t before = place > 0 ? holder - 1 : previous >= 0 ? previous * (pieces_ + 1) + pieces_ - 1 : -1;
  const std::int32_t behind = place < pieces_ ? static_cast<std::int32_t>(holder_index(element, place + 1)) : -1;
  return {before, behind};
}

void ContactSearch::touch(const Meeting& meeting, int holder, const Candidate& candidate,
                          std::vector<CordTouch>& touches) {
  if (candidate.segment < 0) return;
  const auto segment = static_cast<std::size_t>(candidate.segment);
  const auto element = static_cast<std::size_t>(meeting.element), part = static_cast<std::size_t>(meeting.part);
  const SegmentContact& contact = meeting.contacts[segment];
  const Segment piece{meeting.local[segment], meeting.local[segment + 1]};
  const double radius = radius_[element];
  // A place that is still apart is judged as if the cord were thicker by `ahead`.
  const bool is_apart = contact.distance >= radius;
  const double thickness = is_apart ? radius + meeting.ahead : radius;
  // On a large sphere the parabola of the kernel is used, so that a search ahead changes nothing.
  const WeightedPlace estimate = estimate_deepest(contact, thickness, candidate.weight);
  const SegmentPlace place = !is_large_sphere_ ? find_deepest(parts_[part], piece, contact, thickness, candidate.weight)
                             : estimate.is_nearest ? contact.nearest
                                                   : place_on_segment(parts_[part], piece, estimate.t);
  const WeightedPlace found{place.t, candidate.weight.at(place.t), thickness - place.distance};
  if (!(found.weight > 0)) return;
  CordTouch* touch =
      claim(meeting.element, meeting.part, holder, is_apart ? score_apart(found) : found.score(), touches);
  if (touch == nullptr) return;
  touch->segment = candidate.segment;
  touch->t = place.t;
  touch->share = found.weight;
  touch->penetration = radius - place.distance;
  touch->normal = symmetric_product(meeting.body->rigid().rotation(), place.normal);
  touch->point = meeting.world[segment] + place.t * (meeting.world[segment + 1] - meeting.world[segment]);
}

// At a node, the side with the higher score bears the force. Returns the touch to be filled in, or null where the other
// side has a higher score.
CordTouch* ContactSearch::claim(std::int32_t element, std::int32_t part, int place, double score,
                                std::vector<CordTouch>& touches) {
  const auto i = static_cast<std::size_t>(element);
  std::vector<std::int32_t>& of_part = holder_touch_[static_cast<std::size_t>(part)];
  if (of_part.empty()) of_part.assign(holder_count(), -1);
  const std::size_t holder = holder_index(element, place);
  CordTouch* touch = nullptr;
  if (of_part[holder] < 0) {
    of_part[holder] = static_cast<std::int32_t>(open_.size());
    open_.emplace_back().best = static_cast<std::int32_t>(touches.size());
    taken_.emplace_back(part, holder);
    touch = &touches.emplace_back();
    touch->first_element = element;
    touch->first_place = place;
    touch->part = part;
    touch->holder = static_cast<std::int32_t>(holder);
  } else {
    touch = &touches[static_cast<std::size_t>(open_[static_cast<std::size_t>(of_part[holder])].best)];
    if (!(score > touch->score)) return nullptr;
  }
  touch->element = element;
  touch->is_cord_end = (place == 0 && previous_[i] < 0) || (place == pieces_ && next_[i] < 0);
  touch->score = score;
  return touch;
}

}  // namespace netpocket
