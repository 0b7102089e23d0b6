#include "engine/contact/broad_phase.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/bodies/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// An object of FCL that is nothing but a bounding box. FCL asks for a geometry; all boxes share one that is not used.
class BoxObject : public fcl::CollisionObjectd {
 public:
  explicit BoxObject(int index = -1) : fcl::CollisionObjectd(unused_geometry()), index_(index) {}

  void set_box(const AlignedBox3d& box, double margin) {
    aabb.min_ = box.min().array() - margin;
    aabb.max_ = box.max().array() + margin;
  }
  int index() const { return index_; }

 private:
  static const std::shared_ptr<fcl::CollisionGeometryd>& unused_geometry() {
    static const std::shared_ptr<fcl::CollisionGeometryd> geometry = std::make_shared<fcl::Sphered>(1.0);
    return geometry;
  }

  int index_;
};

int index_of(const fcl::CollisionObjectd* object) { return static_cast<const BoxObject*>(object)->index(); }

// Whether the ball round the element's box comes within `margin` of the shape.
bool is_near(const PlacedShape& body, const AlignedBox3d& element, double margin) {
  const Vector3d centre = body.rotation.transpose() * (element.center() - body.position);
  const double reach = 0.5 * element.diagonal().norm() + margin;
  return is_nearer(body.shape, centre, reach);  // a non-finite place counts as near
}

// Bounds on how far any point has moved from where it was at `before`.
double displacement_of(const AlignedBox3d& before, const AlignedBox3d& now) {
  return (now.min() - before.min()).cwiseAbs().cwiseMax((now.max() - before.max()).cwiseAbs()).norm();
}
double displacement_of(const PlacedShape& before, const PlacedShape& now) {
  const double turn = (now.rotation - before.rotation).norm();  // Frobenius: not below the spectral norm
  return (now.position - before.position).norm() + turn * bounding_radius(now.shape);
}

struct BodyQuery {
  const PlacedShape& body;
  std::span<const AlignedBox3d> elements;
  double margin;
  std::vector<int>& found;
};

bool collect_candidate(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  auto& query = *static_cast<BodyQuery*>(data);
  const int element = std::max(index_of(a), index_of(b));  // the body's own index is -1
  if (is_near(query.body, query.elements[static_cast<std::size_t>(element)], query.margin))
    query.found.push_back(element);
  return false;  // go on
}

bool collect_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  auto& found = *static_cast<std::vector<std::pair<int, int>>*>(data);
  found.emplace_back(std::minmax(index_of(a), index_of(b)));
  return false;
}

}  // namespace

struct BroadPhase::Tree {
  explicit Tree(int element_count) {
    elements.reserve(static_cast<std::size_t>(element_count));
    for (int i = 0; i < element_count; ++i) elements.emplace_back(i);
  }

  // The tree wants to see its boxes when it first takes them in, so that it starts balanced.
  void take_boxes() {
    if (registered) {
      manager.update();
      return;
    }
    std::vector<fcl::CollisionObjectd*> objects;
    for (BoxObject& element : elements) objects.push_back(&element);
    manager.registerObjects(objects);
    manager.setup();
    registered = true;
  }

  std::vector<BoxObject> elements;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  bool registered = false;
};

BroadPhase::BroadPhase(int element_count, double margin)
    : margin_(margin), travelled_(std::numeric_limits<double>::infinity()) {
  if (element_count < 0) throw std::invalid_argument("the broad phase needs a number of elements that is not negative");
  if (!(margin > 0)) throw std::invalid_argument("the broad phase needs a positive margin");
  tree_ = std::make_unique<Tree>(element_count);
}

BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

bool BroadPhase::advance(double distance) {
  travelled_ += distance;
  return !(travelled_ <= 0.5 * margin_);
}

double BroadPhase::displacement(std::span<const AlignedBox3d> elements, std::span<const PlacedShape> bodies) const {
  double largest = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
    largest = std::max(largest, displacement_of(built_elements_[i], elements[i]));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    largest = std::max(largest, displacement_of(built_bodies_[i], bodies[i]));
  return largest;
}

bool BroadPhase::update(std::span<const AlignedBox3d> elements, std::span<const PlacedShape> bodies) {
  if (elements.size() == built_elements_.size() && bodies.size() == built_bodies_.size() && rebuild_count_ > 0) {
    travelled_ = displacement(elements, bodies);
    // Half of what is allowed: lists kept with less in hand would ask for the next update too soon.
    if (travelled_ <= 0.25 * margin_) return false;
  }
  rebuild(elements, bodies);
  return true;
}

void BroadPhase::rebuild(std::span<const AlignedBox3d> elements, std::span<const PlacedShape> bodies) {
  if (elements.size() != tree_->elements.size())
    throw std::invalid_argument("the broad phase was given boxes for another number of elements");
  // Half the margin on either side, so that bodies and pairs follow the same rule.
  for (std::size_t i = 0; i < elements.size(); ++i) tree_->elements[i].set_box(elements[i], 0.5 * margin_);
  tree_->take_boxes();

  candidates_.resize(bodies.size());
  BoxObject box;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    box.set_box(bounding_box(bodies[i].shape, bodies[i].position, bodies[i].rotation), 0.5 * margin_);
    candidates_[i].clear();
    BodyQuery query{bodies[i], elements, margin_, candidates_[i]};
    tree_->manager.collide(&box, &query, &collect_candidate);
    std::sort(candidates_[i].begin(), candidates_[i].end());
  }
  built_elements_.assign(elements.begin(), elements.end());
  built_bodies_.assign(bodies.begin(), bodies.end());
  travelled_ = 0;
  pairs_current_ = false;
  ++rebuild_count_;
}

std::span<const std::pair<int, int>> BroadPhase::pairs() {
  if (!pairs_current_) {
    pairs_.clear();
    tree_->manager.collide(&pairs_, &collect_pair);
    std::sort(pairs_.begin(), pairs_.end());
    pairs_current_ = true;
  }
  return pairs_;
}

}  // namespace netpocket
