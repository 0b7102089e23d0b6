#include "engine/contact/segment_batch.h"

#include <algorithm>
#include <optional>

#include "engine/contact/segment_kernel.h"
#include "engine/contact/segment_trial.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using segment_kernel::Solid;

struct SegmentKernels {
  segment_kernel::PointsKernel points;
  segment_kernel::BetweenKernel between;
  segment_kernel::DeepestKernel deepest;
};

const SegmentKernels& segment_kernels() {
  static const SegmentKernels chosen = {NETPOCKET_VARIANT_OF(segment_kernel, points),
                                        NETPOCKET_VARIANT_OF(segment_kernel, between),
                                        NETPOCKET_VARIANT_OF(segment_kernel, deepest)};
  return chosen;
}

// Empty where the kernels do not know the solid.
std::optional<Solid> solid_of(const ContactPart& part) {
  Solid solid{};
  solid.rounding = part.rounding;
  std::copy_n(part.centre.data(), 3, solid.centre);
  if (const auto* box = std::get_if<Box>(&part.solid)) {
    solid.kind = segment_kernel::Kind::box;
    for (int axis = 0; axis < 3; ++axis) solid.half[axis] = 0.5 * box->size[axis];
    return solid;
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&part.solid)) {
    solid.kind = segment_kernel::Kind::cylinder;
    solid.radius = cylinder->radius;
    solid.half_length = 0.5 * cylinder->length;
    return solid;
  }
  if (const auto* sphere = std::get_if<Sphere>(&part.solid)) {
    solid.kind = segment_kernel::Kind::sphere;
    solid.radius = sphere->radius;
    return solid;
  }
  return std::nullopt;
}

// Nearest places on spheres have closed formulas.
bool needs_search(const std::optional<Solid>& solid) { return solid && solid->kind != segment_kernel::Kind::sphere; }

using Row = double[kBlockSize];

void set_lane(Row* rows, int lane, const Vector3d& vector) {
  for (int axis = 0; axis < 3; ++axis) rows[axis][lane] = vector[axis];
}
Vector3d vector_in_lane(const Row* rows, int lane) { return {rows[0][lane], rows[1][lane], rows[2][lane]}; }

void set_lane(segment_kernel::PieceRows& rows, int lane, const Segment& segment) {
  set_lane(rows.start, lane, segment.start);
  set_lane(rows.along, lane, segment.end - segment.start);
}

void set_lane(segment_kernel::TrialRows& rows, int lane, const Trial& trial) {
  rows.t[lane] = trial.t;
  rows.distance[lane] = trial.distance;
  rows.slope[lane] = trial.slope;
  set_lane(rows.normal, lane, trial.normal);
}
Trial trial_in_lane(const segment_kernel::TrialRows& rows, int lane) {
  return {rows.t[lane], rows.distance[lane], rows.slope[lane], vector_in_lane(rows.normal, lane)};
}

// Calls solve(tasks) for groups of eight. Lanes that are left over in the last group hold its first task.
template <typename Task, typename Solve>
void for_each_group(std::span<const Task> tasks, const Solve& solve) {
  for (; !tasks.empty(); tasks = tasks.subspan(std::min<std::size_t>(tasks.size(), kBlockSize))) {
    std::array<const Task*, kBlockSize> group;
    const std::size_t count = std::min<std::size_t>(tasks.size(), kBlockSize);
    for (std::size_t lane = 0; lane < kBlockSize; ++lane) group[lane] = &tasks[lane < count ? lane : 0];
    solve(group, static_cast<int>(count));
  }
}

void search_eight(const Solid& solid, const std::array<const NearestTask*, kBlockSize>& tasks, int count) {
  segment_kernel::Between search;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const NearestTask& task = *tasks[static_cast<std::size_t>(lane)];
    set_lane(search.piece, lane, task.segment);
    search.reach[lane] = task.reach;
    set_lane(search.low, lane, trial_of(*task.ends[0], task.segment, 0));
    set_lane(search.high, lane, trial_of(*task.ends[1], task.segment, 1));
  }
  segment_kernels().between(solid, search);
  for (int lane = 0; lane < count; ++lane) {
    const NearestTask& task = *tasks[static_cast<std::size_t>(lane)];
    const std::array<double, 2> at_ends = {task.ends[0]->distance, task.ends[1]->distance};
    if (search.is_far[lane] > 0) {
      *task.result = SegmentContact{};
      task.result->distance = search.bound[lane];
      task.result->at_ends = at_ends;
    } else {
      *task.result =
          enclosed_between(trial_in_lane(search.low, lane), trial_in_lane(search.high, lane), at_ends, task.reach);
    }
  }
}

void search_deepest_of_eight(const Solid& solid, const std::array<const DeepestTask*, kBlockSize>& tasks, int count) {
  segment_kernel::Deepest search;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const DeepestTask& task = *tasks[static_cast<std::size_t>(lane)];
    const SegmentContact& contact = *task.contact;
    const std::size_t heavier = task.weight.at_end > task.weight.at_start ? 1 : 0;
    set_lane(search.piece, lane, task.segment);
    search.length[lane] = symmetric_norm(task.segment.end - task.segment.start);
    search.radius[lane] = task.radius;
    search.weight_at_start[lane] = task.weight.at_start;
    search.weight_at_end[lane] = task.weight.at_end;
    search.nearest[lane] = contact.nearest.t;
    search.nearest_distance[lane] = contact.nearest.distance;
    search.slope[lane] = contact.slopes[heavier];
    search.end_distance[lane] = contact.at_ends[heavier];
  }
  segment_kernels().deepest(solid, search);
  for (int lane = 0; lane < count; ++lane) {
    const DeepestTask& task = *tasks[static_cast<std::size_t>(lane)];
    *task.result = search.is_nearest[lane] > 0 ? task.contact->nearest : place_of(trial_in_lane(search.found, lane));
  }
}

}  // namespace

void find_nearest_points(const ContactPart& part, std::span<const PointTask> tasks) {
  const std::optional<Solid> solid = solid_of(part);
  if (!needs_search(solid)) {
    for (const PointTask& task : tasks) *task.nearest = part.nearest(*task.point);
    return;
  }
  for_each_group(tasks, [&](const auto& group, int count) {
    segment_kernel::Points points;
    for (int lane = 0; lane < kBlockSize; ++lane) {
      set_lane(points.point, lane, *group[static_cast<std::size_t>(lane)]->point);
    }
    segment_kernels().points(*solid, points);
    for (int lane = 0; lane < count; ++lane) {
      *group[static_cast<std::size_t>(lane)]->nearest = {points.distance[lane], vector_in_lane(points.normal, lane)};
    }
  });
}

// Pieces along which the distance falls or rises only need no search.
void find_nearest(const ContactPart& part, std::span<const NearestTask> tasks) {
  const std::optional<Solid> solid = solid_of(part);
  std::array<const NearestTask*, kBlockSize> group;
  std::size_t waiting = 0;
  const auto search_group = [&] {
    std::fill(group.begin() + static_cast<std::ptrdiff_t>(waiting), group.end(), group.front());
    search_eight(*solid, group, static_cast<int>(waiting));
    waiting = 0;
  };
  for (const NearestTask& task : tasks) {
    const Vector3d along = task.segment.end - task.segment.start;
    if (needs_search(solid) && symmetric_dot(task.ends[0]->normal, along) < 0 &&
        symmetric_dot(task.ends[1]->normal, along) > 0) {
      group[waiting++] = &task;
      if (waiting == kBlockSize) search_group();
    } else {
      *task.result = nearest_on_segment(part, task.segment, task.ends, task.reach);
    }
  }
  if (waiting > 0) search_group();
}

void find_deepest(const ContactPart& part, std::span<const DeepestTask> tasks) {
  const std::optional<Solid> solid = solid_of(part);
  if (!solid) {
    for (const DeepestTask& task : tasks) {
      *task.result = find_deepest(part, task.segment, *task.contact, task.radius, task.weight);
    }
    return;
  }
  for_each_group(tasks, [&](const auto& group, int count) { search_deepest_of_eight(*solid, group, count); });
}

}  // namespace netpocket
