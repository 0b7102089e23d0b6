// The part of ContactSolver that tells what its contacts bear and how deep they are.

#include <algorithm>
#include <cmath>

#include "engine/dynamics/contact/contact_solver.h"

namespace netpocket {

using Eigen::Vector3d;

double ContactSolver::largest_compression() const {
  double largest = 0;
  for_each_contact([&](const ContactBlock& block, int lane) { largest = std::max(largest, block.penetration[lane]); });
  return largest;
}

double ContactSolver::largest_load(const std::vector<DynamicBody>& bodies) {
  double largest = 0;
  for_each_contact([&](const ContactBlock& block, int lane) {
    largest = std::max(largest, load_of(block, lane, bodies[static_cast<std::size_t>(block.body)].least_mass()));
  });
  return largest;
}

std::optional<ContactSolver::Depth> ContactSolver::deepest_contact() const {
  std::optional<Depth> deepest;
  for_each_contact([&](const ContactBlock& block, int lane) {
    if (deepest && deepest->penetration >= block.penetration[lane] + block.offset[lane]) return;
    deepest = Depth{block.element[lane], block.body, block.penetration[lane] + block.offset[lane]};
  });
  return deepest;
}

std::vector<ContactPoint> ContactSolver::contacts() const {
  std::vector<ContactPoint> result;
  for_each_contact([&](const ContactBlock& block, int lane) {
    const Vector3d force = lane_of(block.force, lane);
    if (force.squaredNorm() == 0) return;
    const double to_surface = model_.radius_of(block.element[lane]) - (block.penetration[lane] + block.offset[lane]);
    const Vector3d surface = lane_of(block.point, lane) - to_surface * lane_of(block.normal, lane);
    result.push_back({surface, -force, block.element[lane], block.body});
  });
  return result;
}

}  // namespace netpocket
