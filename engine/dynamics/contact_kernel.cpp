// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace. The formulas are those of
// force_law.h, in the same notation.

#include "engine/dynamics/contact_kernel.h"

#include "engine/ancf/element_slots.h"
#include "engine/ancf/lanes.h"

namespace netpocket::contact_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace lanes;

NETPOCKET_INLINE Lanes3 load3(const double (*rows)[kBlock], int part) {
  return {load(rows[0], part), load(rows[1], part), load(rows[2], part)};
}
NETPOCKET_INLINE Lanes3 broadcast3(const double* vector) {
  return {broadcast(vector[0]), broadcast(vector[1]), broadcast(vector[2])};
}

// Vectors of the contacts' slots at a corner, in the blocks of ContactedSlots.
NETPOCKET_INLINE Lanes3 at_places(const double* rows, const ContactBlock& c, int corner, int part) {
  std::ptrdiff_t place[kWidth];
  for (int i = 0; i < kWidth; ++i) {
    const int lane = part * kWidth + i;
    place[i] =
        static_cast<std::ptrdiff_t>(c.place[corner][lane]) * (kSlotRows * kBlock) + c.slot[corner][lane] % kBlock;
  }
  return gather3(rows, place);
}

// Of the body at the contact points.
NETPOCKET_INLINE Lanes3 body_velocity(const BodyMotion& body, const Lanes3& arm) {
  return broadcast3(body.velocity) + cross(broadcast3(body.angular_velocity), arm);
}

// The cables' velocity at the contact points, in the order of element_curve.h.
NETPOCKET_INLINE Lanes3 combine(const ContactBlock& c, int part, const Lanes3& a, const Lanes3& b, const Lanes3& d,
                                const Lanes3& e) {
  return (load(c.weight[0], part) * a + load(c.weight[1], part) * b) +
         (load(c.weight[2], part) * d + load(c.weight[3], part) * e);
}
NETPOCKET_INLINE Lanes3 velocity_at_slots(const double* rows, const ContactBlock& c, int part) {
  return combine(c, part, gather_slots(rows, c.slot[0], part), gather_slots(rows, c.slot[1], part),
                 gather_slots(rows, c.slot[2], part), gather_slots(rows, c.slot[3], part));
}
NETPOCKET_INLINE Lanes3 velocity_at_places(const double* rows, const ContactBlock& c, int part) {
  return combine(c, part, at_places(rows, c, 0, part), at_places(rows, c, 1, part), at_places(rows, c, 2, part),
                 at_places(rows, c, 3, part));
}

// ContactedSlots::inverse_mass.
NETPOCKET_INLINE Lanes shared_inverse_mass(const ForceView& view, const ContactBlock& c, int part) {
  Lanes sum = {};
  for (int corner = 0; corner < 4; ++corner) {
    const Lanes weight = load(c.weight[corner], part);
    std::ptrdiff_t slot[kWidth], place[kWidth];
    for (int i = 0; i < kWidth; ++i) {
      const int lane = part * kWidth + i;
      slot[i] = c.slot[corner][lane];
      place[i] = static_cast<std::ptrdiff_t>(c.place[corner][lane]) * kBlock + slot[i] % kBlock;
    }
    sum = sum + ((weight < broadcast(0.0) ? -weight : weight) * gather(view.shared_weight, place)) *
                    gather(view.inverse_mass, slot);
  }
  return sum;
}

// stepped_normal_force
NETPOCKET_INLINE Lanes normal_force(const ContactBlock& c, int part, const Lanes& before, const Lanes& after,
                                    const Lanes& w, const Lanes& dt) {
  const Lanes stiffness = load(c.stiffness, part);
  const Lanes root = square_root(larger(load(c.penetration, part), broadcast(0.0)));
  const Lanes elastic = stiffness * root * root * root;
  const Lanes implicit = larger(broadcast(1.5) * stiffness * root * dt - broadcast(1.0) / (dt * w), broadcast(0.0));
  const Lanes damping = load(c.damping, part) * square_root(root);
  const Lanes unopposed = elastic - implicit * after - damping * broadcast(0.5) * (before + after);
  return larger(unopposed / (broadcast(1.0) + dt * w * (implicit + broadcast(0.5) * damping)), broadcast(0.0));
}

// sliding_resistance
NETPOCKET_INLINE Lanes resistance(const ForceView& view, const Lanes& normal_force, const Lanes& speed,
                                  const Lanes& w) {
  const Lanes stopping = broadcast(1.0) / (w * broadcast(view.dt));
  const Lanes coulomb = broadcast(view.friction) * normal_force / larger(speed, broadcast(view.friction_velocity));
  return coulomb < stopping ? coulomb : stopping;
}

}  // namespace

double points(const ElementBlock& block, const Sample* samples, std::size_t count, const SlotRows& coordinates,
              const double* centre, double* rows) {
  Lanes least[kParts] = {};
  for (int part = 0; part < kParts; ++part) {
    const Lanes length = load(block.length, part);
    const Lanes3 r1 = load_slot(coordinates, block, 0, part), g1 = load_slot(coordinates, block, 1, part);
    const Lanes3 r2 = load_slot(coordinates, block, 2, part), g2 = load_slot(coordinates, block, 3, part);
    double* out = rows;
    for (std::size_t i = 0; i < count; ++i) {
      const Sample& sample = samples[i];
      const Lanes3 point = (broadcast(sample.position1) * r1 + (length * broadcast(sample.gradient1)) * g1) +
                           (broadcast(sample.position2) * r2 + (length * broadcast(sample.gradient2)) * g2);
      const Lanes3 arm = point - broadcast3(centre);
      const Lanes distance = square_root(dot(arm, arm));
      store3(out, 0, part, point);
      store(out + 3 * kBlock, part, distance);
      least[part] = out == rows ? distance : (distance < least[part] ? distance : least[part]);
      out += kPointRows * kBlock;
    }
  }
  double result = least[0][0];
  for (int lane = 1; lane < kBlock; ++lane) {
    const double distance = least[lane / kWidth][lane % kWidth];
    result = distance < result ? distance : result;
  }
  return result;
}

void forces(const ForceView& view, const BodyMotion& body, ContactBlock* contacts, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ContactBlock& c = contacts[i];
    for (int part = 0; part < kParts; ++part) {
      const Lanes3 normal = load3(c.normal, part);
      const Lanes3 arm = load3(c.point, part) - broadcast3(body.position);
      const Lanes3 surface = body_velocity(body, arm);
      const Lanes distance = square_root(dot(arm, arm));
      const Lanes of_body = broadcast(body.inverse_mass) + distance * distance * broadcast(body.inverse_inertia);
      const Lanes w = shared_inverse_mass(view, c, part) + broadcast(body.contacts) * of_body;
      const Lanes3 before = velocity_at_slots(view.velocities, c, part) - surface;
      const Lanes3 after = velocity_at_places(view.predicted, c, part) - surface;
      const Lanes separation = dot(after, normal);
      const Lanes push = normal_force(c, part, dot(before, normal), separation, w, broadcast(view.dt));
      const Lanes3 sliding = after - separation * normal;
      const Lanes3 force = push * normal - resistance(view, push, square_root(dot(sliding, sliding)), w) * sliding;
      store3(c.velocity[0], 0, part, before);
      store3(c.force[0], 0, part, force);
    }
  }
}

double power(const SlotRows& velocities, const BodyMotion& body, const ContactBlock* contacts, std::size_t count) {
  Lanes sum[kParts] = {};
  for (std::size_t i = 0; i < count; ++i) {
    const ContactBlock& c = contacts[i];
    for (int part = 0; part < kParts; ++part) {
      const Lanes3 arm = load3(c.point, part) - broadcast3(body.position);
      const Lanes3 velocity = velocity_at_slots(velocities.first, c, part) - body_velocity(body, arm);
      sum[part] = sum[part] - dot(load3(c.force, part), velocity);
    }
  }
  double total = 0;
  for (int lane = 0; lane < kBlock; ++lane) total += sum[lane / kWidth][lane % kWidth];
  return total;
}

}  // namespace netpocket::contact_kernel::NETPOCKET_ISA_NAME
