#pragma once
// Instruction-set variants of the searches of segment_contact.h on boxes, cylinders and spheres, for eight pieces of
// cords at once. Each lane computes what the functions of segment_contact.cpp and shape.cpp compute, to the last bit.
// Internal to segment_batch.
//
// Rows hold one value for each lane. Lanes that are not wanted may hold anything that is finite. Body axes, m.

#include "engine/math/block_size.h"
#include "engine/math/instruction_set.h"

namespace netpocket::segment_kernel {

enum class Kind { box, cylinder, sphere };

// The edges of boxes and cylinders (along y) may be round (contact_part.h).
struct Solid {
  Kind kind;
  double half[3];              // m, half the edges of the box
  double radius, half_length;  // m, of cylinder and sphere; of the cylinder
  double rounding;             // m
  double centre[3];            // m, body axes
};

struct alignas(64) Points {
  double point[3][kBlockSize];
  double distance[kBlockSize], normal[3][kBlockSize];  // result
};

// A point of a piece: position along it, signed distance, slope of the distance along the piece, normal.
struct alignas(64) TrialRows {
  double t[kBlockSize], distance[kBlockSize], slope[kBlockSize], normal[3][kBlockSize];
};

struct alignas(64) PieceRows {
  double start[3][kBlockSize], along[3][kBlockSize];  // m, from the start to the end
};

// The search for the nearest place between two places: the distance falls at `low` and rises at `high`. Both come
// closer to each other. `bound`: lower bound of the distance where it exceeds `reach`; then the search ended early.
struct alignas(64) Between {
  PieceRows piece;
  double reach[kBlockSize];
  TrialRows low, high;
  double bound[kBlockSize], is_far[kBlockSize];  // 1 if it ended early, else 0
};

// The search for the deepest place by weight, towards the end of the larger weight.
struct alignas(64) Deepest {
  PieceRows piece;
  double length[kBlockSize], radius[kBlockSize];
  double weight_at_start[kBlockSize], weight_at_end[kBlockSize];
  double nearest[kBlockSize], nearest_distance[kBlockSize];  // t and signed distance of the nearest place
  double slope[kBlockSize];         // of the distance at the nearest place, towards the end of the larger weight
  double end_distance[kBlockSize];  // at the end of the larger weight
  TrialRows found;                  // result; its slope is not set
  double is_nearest[kBlockSize];    // 1 if the result is the nearest place, and found is not set; else 0
};

// Points and places between others: of boxes and cylinders only.
using PointsKernel = void (*)(const Solid&, Points&);
using BetweenKernel = void (*)(const Solid&, Between&);
using DeepestKernel = void (*)(const Solid&, Deepest&);

NETPOCKET_VARIANTS(void points(const Solid&, Points&); void between(const Solid&, Between&);
                   void deepest(const Solid&, Deepest&);)

}  // namespace netpocket::segment_kernel
