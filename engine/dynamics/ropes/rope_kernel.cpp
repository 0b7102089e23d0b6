// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace. The formulas and notation are those
// of ancf/variable_length.h and ancf/mean_strain_element.h.

#include "engine/dynamics/ropes/rope_kernel.h"

#include "engine/ancf/element_coordinates.h"
#include "engine/math/simd.h"

namespace netpocket::rope_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

struct Span {
  SimdDouble length, start_rate, end_rate;
};
NETPOCKET_INLINE Span load_span(const SpanRows& rows, int part) {
  return {load(rows.length, part), load(rows.start_rate, part), load(rows.end_rate, part)};
}

// Lumped mass of a node and of a gradient.
struct Mass {
  SimdDouble node, slope;
};
NETPOCKET_INLINE Mass lumped_mass(const SimdDouble& mass_per_length, const SimdDouble& length) {
  return {mass_per_length * length / broadcast(2.0), mass_per_length * length * length * length / broadcast(78.0)};
}

// Velocity of the material relative to each node.
struct Flow {
  SimdVector past1, past2;
};
NETPOCKET_INLINE Flow flow_past(const Span& span, const SimdVector& chord) {
  const SimdVector e = {chord.x / span.length, chord.y / span.length, chord.z / span.length};
  return {-span.start_rate * e, -span.end_rate * e};
}

NETPOCKET_INLINE SimdDouble squared_norm(const SimdVector& v) { return dot(v, v); }

NETPOCKET_INLINE SimdVector gather_corner(const CoordinateRows& rows, const RopeBlock& block, int corner, int part) {
  return gather_coordinates(rows.first, block.coordinate[corner], part);
}

// Velocities of nodes; squared norms of the rates of gradients.
struct Motion {
  SimdVector chord, v1, v2;
  SimdDouble slope1, slope2;
};

NETPOCKET_INLINE SimdDouble kinetic_energy(const SimdDouble& mass_per_length, const Span& span, const Motion& motion) {
  const Mass mass = lumped_mass(mass_per_length, span.length);
  const Flow flow = flow_past(span, motion.chord);
  return broadcast(0.5) * (mass.node * squared_norm(motion.v1 + flow.past1) + mass.slope * motion.slope1 +
                           mass.node * squared_norm(motion.v2 + flow.past2) + mass.slope * motion.slope2);
}

}  // namespace

void energy_change(const CoordinateRows& coordinates, const CoordinateRows& velocities, RopeBlock& block) {
  for (int part = 0; part < kParts; ++part) {
    const Motion motion = {gather_corner(coordinates, block, 2, part) - gather_corner(coordinates, block, 0, part),
                           gather_corner(velocities, block, 0, part), gather_corner(velocities, block, 2, part),
                           squared_norm(gather_corner(velocities, block, 1, part)),
                           squared_norm(gather_corner(velocities, block, 3, part))};
    const SimdDouble mass = load(block.mass_per_length, part);
    store(block.energy_change, part,
          kinetic_energy(mass, load_span(block.now, part), motion) -
              kinetic_energy(mass, load_span(block.before, part), motion));
  }
}

void forces(const CoordinateRows& coordinates, const CoordinateRows& velocities, double last_dt, double kick,
            RopeBlock& block) {
  const SimdDouble last = broadcast(last_dt), inverse_kick = broadcast(1 / kick), half = broadcast(0.5);
  for (int part = 0; part < kParts; ++part) {
    const SimdDouble mass_per_length = load(block.mass_per_length, part);
    const Span before = load_span(block.before, part), now = load_span(block.now, part);
    const Mass mass_before = lumped_mass(mass_per_length, before.length);
    const Mass mass_now = lumped_mass(mass_per_length, now.length);
    const SimdDouble lost_node = mass_before.node - mass_now.node, lost_slope = mass_before.slope - mass_now.slope;
    const SimdVector r1 = gather_corner(coordinates, block, 0, part), r2 = gather_corner(coordinates, block, 2, part);
    const SimdVector v1 = gather_corner(velocities, block, 0, part), v2 = gather_corner(velocities, block, 2, part);
    const Flow flow = flow_past(now, r2 - r1), flow_before = flow_past(before, (r2 - last * v2) - (r1 - last * v1));

    const SimdVector carried =
        (mass_per_length * half) * (now.start_rate * (v1 + flow.past1) + now.end_rate * (v2 + flow.past2));
    const SimdVector impulse1 = lost_node * v1 + mass_before.node * flow_before.past1 - mass_now.node * flow.past1;
    const SimdVector impulse2 = lost_node * v2 + mass_before.node * flow_before.past2 - mass_now.node * flow.past2;
    store3(block.force[0][0], 0, part, inverse_kick * impulse1 + carried);
    store3(block.force[1][0], 0, part, (inverse_kick * lost_slope) * gather_corner(velocities, block, 1, part));
    store3(block.force[2][0], 0, part, inverse_kick * impulse2 - carried);
    store3(block.force[3][0], 0, part, (inverse_kick * lost_slope) * gather_corner(velocities, block, 3, part));
  }
}

void tensions(const CoordinateRows& coordinates, const CoordinateRows& velocities, const SpanRows& spans,
              const RopeBlock& block, double* tensions) {
  const SimdDouble one = broadcast(1), two = broadcast(2), four = broadcast(4), zero = broadcast(0);
  for (int part = 0; part < kParts; ++part) {
    const Span span = load_span(spans, part);
    const SimdDouble inverse_length = one / span.length;
    const SimdVector e =
        inverse_length * (gather_corner(coordinates, block, 2, part) - gather_corner(coordinates, block, 0, part));
    const SimdVector h1 = gather_corner(coordinates, block, 1, part) - e;
    const SimdVector h2 = gather_corner(coordinates, block, 3, part) - e;
    const SimdDouble waviness = two * (squared_norm(h1) + squared_norm(h2)) - dot(h1, h2);
    const SimdDouble strain = broadcast(0.5) * (squared_norm(e) - one + waviness / broadcast(15));

    const SimdVector chord_rate =
        inverse_length * (gather_corner(velocities, block, 2, part) - gather_corner(velocities, block, 0, part));
    const SimdVector e_rate = chord_rate - (inverse_length * (span.end_rate - span.start_rate)) * e;
    const SimdVector h1_rate = gather_corner(velocities, block, 1, part) - e_rate;
    const SimdVector h2_rate = gather_corner(velocities, block, 3, part) - e_rate;
    const SimdDouble of_waviness = dot(four * h1 - h2, h1_rate) + dot(four * h2 - h1, h2_rate);
    const SimdDouble strain_rate = dot(e, e_rate) + of_waviness / broadcast(30);

    const SimdDouble stiffness = load(block.axial_stiffness, part), pressed = load(block.compression, part) * stiffness;
    store(tensions, part,
          (strain < zero ? pressed : stiffness) * (strain + load(block.axial_damping, part) * strain_rate));
  }
}

}  // namespace netpocket::rope_kernel::NETPOCKET_ISA_NAME
