// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace. Notation of segment_contact.h.

#include "engine/dynamics/contact/sphere_kernel.h"

#include "engine/ancf/element_coordinates.h"
#include "engine/math/simd.h"

namespace netpocket::sphere_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

NETPOCKET_INLINE SimdVector broadcast3(const double* vector) {
  return {broadcast(vector[0]), broadcast(vector[1]), broadcast(vector[2])};
}
NETPOCKET_INLINE SimdDouble smaller(const SimdDouble& a, const SimdDouble& b) { return a < b ? a : b; }

// A capsule's axis, relative to the sphere.
struct Piece {
  SimdVector start, along;      // from the sphere's centre
  SimdDouble nearest;           // fraction along the axis, 0 to 1
  SimdDouble depth;             // depth at `nearest`
  SimdDouble slope;             // of the depth at `nearest`; 0 between the ends
  SimdDouble at_start, at_end;  // depths
};

// A place on a piece, its weight and its score.
struct Estimate {
  SimdDouble t, weight, score;
};

NETPOCKET_INLINE Piece make_piece(const SimdVector& start, const SimdVector& end, const SimdDouble& at_start,
                                  const SimdDouble& at_end, const SimdDouble& thickness) {
  const SimdDouble zero = broadcast(0.0), one = broadcast(1.0);
  Piece piece{start, end - start, zero, zero, zero, at_start, at_end};
  const SimdDouble square = dot(piece.along, piece.along);
  const SimdDouble way = -dot(start, piece.along) / larger(square, broadcast(1e-300));
  piece.nearest = smaller(larger(way, zero), one);
  const SimdVector arm = start + piece.nearest * piece.along;
  const SimdDouble distance = square_root(dot(arm, arm));
  piece.depth = thickness - distance;
  if (!is_any_positive(piece.depth)) return piece;  // its slope is not needed
  const SimdDouble slope = -dot(arm, piece.along) / distance;
  piece.slope = way > zero && way < one ? zero : slope;
  return piece;
}

// As estimate_deepest of segment_contact.h, in the same notation. The weight changes by one half along the piece.
NETPOCKET_INLINE Estimate estimate(const Piece& piece, double at_start, double at_end) {
  const SimdDouble zero = broadcast(0.0);
  if (!is_any_positive(piece.depth)) return {zero, zero, broadcast(-1.0)};
  const SimdDouble rise = broadcast(at_end - at_start), here = broadcast(at_start) + rise * piece.nearest;
  const SimdDouble end = broadcast(at_end > at_start ? 1.0 : 0.0),
                   known = at_end > at_start ? piece.at_end : piece.at_start;
  const SimdDouble way = end - piece.nearest;
  const SimdDouble square_way = way * way;
  const SimdDouble bend =
      smaller((known - piece.depth - piece.slope * way) / larger(square_way, broadcast(1e-30)), zero);
  const SimdDouble square = broadcast(6.0) * rise * bend;
  const SimdDouble linear = broadcast(3.5) * rise * piece.slope + broadcast(5.0) * here * bend;
  const SimdDouble constant = rise * piece.depth + broadcast(2.5) * here * piece.slope;
  const SimdDouble root = square_root(larger(linear * linear - broadcast(4.0) * square * constant, zero));
  const SimdDouble divisor = root - linear;
  const SimdDouble found = broadcast(2.0) * constant / (divisor == zero ? broadcast(1e-300) : divisor);
  const SimdDouble x = smaller(larger(found, smaller(way, zero)), larger(way, zero));
  const SimdDouble depth = piece.depth + piece.slope * x + bend * x * x;
  const SimdDouble weight = here + rise * x;
  const SimdDouble score = weight * weight * ((depth * depth) * (depth * depth) * depth);
  return {piece.nearest + x, weight, piece.depth > zero ? score : broadcast(-1.0)};
}

// The piece with the higher score, and its index.
struct Choice {
  Estimate estimate;
  SimdDouble number;
};
NETPOCKET_INLINE Choice better(const Choice& a, const Choice& b) {
  const auto second = b.estimate.score > a.estimate.score;
  return {{second ? b.estimate.t : a.estimate.t, second ? b.estimate.weight : a.estimate.weight,
           second ? b.estimate.score : a.estimate.score},
          second ? b.number : a.number};
}

NETPOCKET_INLINE SimdVector chosen(const SimdDouble& number, int index, const SimdVector& value,
                                   const SimdVector& otherwise) {
  const auto is_it = number == broadcast(static_cast<double>(index));
  return {is_it ? value.x : otherwise.x, is_it ? value.y : otherwise.y, is_it ? value.z : otherwise.z};
}

// The vertices of the chain and the sphere.
struct Chain {
  SimdVector vertex[5], centre;
  SimdDouble thickness;
};

NETPOCKET_INLINE void store_choice(const Chain& chain, const Piece* pieces, const Choice& choice, int part,
                                   TouchRows& out) {
  const SimdDouble zero = broadcast(0.0), one = broadcast(1.0);
  SimdVector start = pieces[0].start, along = pieces[0].along;
  for (int i = 1; i < 4; ++i) {
    start = chosen(choice.number, i, pieces[i].start, start);
    along = chosen(choice.number, i, pieces[i].along, along);
  }
  const SimdVector estimated = start + choice.estimate.t * along;
  const SimdDouble found = chain.thickness - square_root(dot(estimated, estimated));
  const SimdDouble depth = choice.estimate.score > zero ? found : zero, weight = choice.estimate.weight;
  store(out.depth, part, depth);
  if (!is_any_positive(depth)) return;
  store(out.share, part, weight);
  store(out.score, part, weight * weight * ((depth * depth) * (depth * depth) * depth));
  // The end of a capsule counts as the start of the next.
  const SimdDouble place = choice.number + choice.estimate.t;
  SimdDouble segment = zero;
  SimdVector first = chain.vertex[0], second = chain.vertex[1];
  for (int i = 1; i < 4; ++i) {
    segment = place >= broadcast(static_cast<double>(i)) ? segment + one : segment;
    first = chosen(segment, i, chain.vertex[i], first);
    second = chosen(segment, i, chain.vertex[i + 1], second);
  }
  const SimdDouble t = place - segment;
  const SimdVector point = first + t * (second - first), arm = point - chain.centre;
  const SimdDouble distance = square_root(dot(arm, arm));
  store(out.segment, part, segment);
  store(out.t, part, t);
  store3(out.point[0], 0, part, point);
  store3(out.normal[0], 0, part, {arm.x / distance, arm.y / distance, arm.z / distance});
}

}  // namespace

void places(const double* vertices, const double* centre, const double* thickness, SpherePlaces& places) {
  for (int part = 0; part < kParts; ++part) {
    const SimdDouble thick = load(thickness, part);
    Chain chain;
    chain.centre = broadcast3(centre);
    chain.thickness = thick;
    SimdVector arm[5];
    SimdDouble depth[5];
    for (int i = 0; i < 5; ++i) {
      const double* row = vertices + i * kVectorRows * kBlock;
      chain.vertex[i] = {load(row, part), load(row + kBlock, part), load(row + 2 * kBlock, part)};
      arm[i] = chain.vertex[i] - chain.centre;
      depth[i] = thick - square_root(dot(arm[i], arm[i]));
    }
    Piece pieces[4];
    SimdDouble deepest = depth[0];
    for (int i = 0; i < 4; ++i) {
      pieces[i] = make_piece(arm[i], arm[i + 1], depth[i], depth[i + 1], thick);
      deepest = larger(deepest, pieces[i].depth);
    }
    store(places.clearance, part, -deepest);
    if (are_all_negative(deepest)) {
      for (TouchRows& rows : places.holder) store(rows.depth, part, broadcast(0.0));
      continue;
    }
    const auto choose = [&](int first, double a, double b, double c) {
      return better({estimate(pieces[first], a, b), broadcast(static_cast<double>(first))},
                    {estimate(pieces[first + 1], b, c), broadcast(static_cast<double>(first + 1))});
    };
    store_choice(chain, pieces, choose(0, 1, 0.5, 0), part, places.holder[0]);
    store_choice(chain, pieces, better(choose(0, 0, 0.5, 1), choose(2, 1, 0.5, 0)), part, places.holder[1]);
    store_choice(chain, pieces, choose(2, 0, 0.5, 1), part, places.holder[2]);
  }
}

namespace {

// Shape functions at a vertex of the capsule chains.
struct VertexWeights {
  SimdDouble of[4];
};
NETPOCKET_INLINE VertexWeights weights_at(const contact_kernel::Vertex* vertices, int first,
                                          const SimdDouble& segment) {
  VertexWeights weights = {};
  for (int i = 0; i < 4; ++i) {
    const contact_kernel::Vertex& vertex = vertices[first + i];
    const auto is_it = segment == broadcast(static_cast<double>(i));
    weights.of[0] = is_it ? broadcast(vertex.position1) : weights.of[0];
    weights.of[1] = is_it ? broadcast(vertex.gradient1) : weights.of[1];
    weights.of[2] = is_it ? broadcast(vertex.position2) : weights.of[2];
    weights.of[3] = is_it ? broadcast(vertex.gradient2) : weights.of[3];
  }
  return weights;
}

}  // namespace

void place(const TouchRows& touches, std::uint32_t used, const LawRows& laws, const contact_kernel::Vertex* vertices,
           const double* length, ContactBlock& contacts) {
  alignas(64) double uses[kBlock];
  for (int lane = 0; lane < kBlock; ++lane) uses[lane] = (used >> lane & 1U) != 0 ? 1.0 : 0.0;
  const SimdDouble zero = broadcast(0.0), one = broadcast(1.0);
  for (int part = 0; part < kParts; ++part) {
    const auto is_used = load(uses, part) > zero;
    const auto keep = [&](double* row, const SimdDouble& value) { store(row, part, is_used ? value : zero); };
    const SimdDouble segment = load(touches.segment, part), t = load(touches.t, part), here = load(length, part);
    const VertexWeights start = weights_at(vertices, 0, segment), end = weights_at(vertices, 1, segment);
    for (int corner = 0; corner < 4; ++corner) {
      const bool is_gradient = corner % 2 == 1;
      const SimdDouble a = is_gradient ? here * start.of[corner] : start.of[corner];
      const SimdDouble b = is_gradient ? here * end.of[corner] : end.of[corner];
      keep(contacts.weight[corner], (one - t) * a + t * b);
    }
    for (int axis = 0; axis < 3; ++axis) {
      keep(contacts.point[axis], load(touches.point[axis], part));
      keep(contacts.normal[axis], load(touches.normal[axis], part));
    }
    keep(contacts.penetration, load(touches.depth, part));
    store(contacts.offset, part, zero);
    keep(contacts.stiffness, load(laws.stiffness, part));
    keep(contacts.damping, load(laws.damping, part));
    keep(contacts.deepest, smaller(load(laws.deepest, part), load(laws.impact, part)));
    keep(contacts.share, load(touches.share, part));
  }
}

}  // namespace netpocket::sphere_kernel::NETPOCKET_ISA_NAME
