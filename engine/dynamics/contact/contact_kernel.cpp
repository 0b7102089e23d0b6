// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace. The formulas and notation are those
// of force_law.h.

#include "engine/dynamics/contact/contact_kernel.h"

#include "engine/ancf/element_coordinates.h"
#include "engine/math/simd.h"

namespace netpocket::contact_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

NETPOCKET_INLINE SimdVector load3(const double (*rows)[kBlock], int part) {
  return {load(rows[0], part), load(rows[1], part), load(rows[2], part)};
}
NETPOCKET_INLINE SimdVector broadcast3(const double* vector) {
  return {broadcast(vector[0]), broadcast(vector[1]), broadcast(vector[2])};
}

// Vectors of one corner of the contacts, from rows of ContactedCoordinates.
NETPOCKET_INLINE SimdVector at_places(const double* rows, const ContactBlock& c, int corner, int part) {
  std::ptrdiff_t place[kWidth];
  for (int i = 0; i < kWidth; ++i) {
    const int lane = part * kWidth + i;
    place[i] = static_cast<std::ptrdiff_t>(c.place[corner][lane]) * (kVectorRows * kBlock) +
               c.coordinate[corner][lane] % kBlock;
  }
  return gather3(rows, place);
}

// Velocity of the body at the contact points.
NETPOCKET_INLINE SimdVector body_velocity(const BodyMotion& body, const SimdVector& arm) {
  return broadcast3(body.velocity) + cross(broadcast3(body.angular_velocity), arm);
}

// As RigidBody::inverse_mass_at, and its upper bound for any direction.
NETPOCKET_INLINE SimdDouble inverse_mass_along(const BodyMotion& body, const SimdVector& arm,
                                               const SimdVector& direction) {
  const SimdVector turn = cross(arm, direction);
  const SimdVector spin = {dot(broadcast3(body.inverse_inertia[0]), turn),
                           dot(broadcast3(body.inverse_inertia[1]), turn),
                           dot(broadcast3(body.inverse_inertia[2]), turn)};
  return broadcast(body.inverse_mass) + dot(turn, spin);
}
NETPOCKET_INLINE SimdDouble largest_inverse_mass(const BodyMotion& body, const SimdVector& arm) {
  return broadcast(body.inverse_mass) + dot(arm, arm) * broadcast(body.largest_inverse_inertia);
}

// Velocity of the cables at the contact points, summed in the order of element_curve.h.
NETPOCKET_INLINE SimdVector combine(const ContactBlock& c, int part, const SimdVector& a, const SimdVector& b,
                                    const SimdVector& d, const SimdVector& e) {
  return (load(c.weight[0], part) * a + load(c.weight[1], part) * b) +
         (load(c.weight[2], part) * d + load(c.weight[3], part) * e);
}
NETPOCKET_INLINE SimdVector load_run(const double* row, const ContactBlock& c, int corner, int part) {
  return {load_rotated(row, part, c.rotation[corner]), load_rotated(row + kBlock, part, c.rotation[corner]),
          load_rotated(row + 2 * kBlock, part, c.rotation[corner])};
}
NETPOCKET_INLINE SimdVector velocity_at_coordinates(const double* rows, const ContactBlock& c, int part) {
  if (c.is_regular) {
    const auto corner = [&](int i) {
      return load_run(rows + static_cast<std::ptrdiff_t>(c.base[i]) * kVectorRows, c, i, part);
    };
    return combine(c, part, corner(0), corner(1), corner(2), corner(3));
  }
  return combine(c, part, gather_coordinates(rows, c.coordinate[0], part),
                 gather_coordinates(rows, c.coordinate[1], part), gather_coordinates(rows, c.coordinate[2], part),
                 gather_coordinates(rows, c.coordinate[3], part));
}
NETPOCKET_INLINE SimdVector velocity_at_places(const double* rows, const ContactBlock& c, int part) {
  if (c.is_regular) {
    const auto corner = [&](int i) {
      return load_run(rows + static_cast<std::ptrdiff_t>(c.place[i][0]) * (kVectorRows * kBlock), c, i, part);
    };
    return combine(c, part, corner(0), corner(1), corner(2), corner(3));
  }
  return combine(c, part, at_places(rows, c, 0, part), at_places(rows, c, 1, part), at_places(rows, c, 2, part),
                 at_places(rows, c, 3, part));
}

// Sum of weights and inverse mass of the coordinates of one corner.
struct Shares {
  SimdDouble weight, inverse_mass;
};
NETPOCKET_INLINE Shares shares(const ForceView& view, const ContactBlock& c, int corner, int part) {
  if (c.is_regular) {
    const double* weights = view.shared_weight + static_cast<std::ptrdiff_t>(c.place[corner][0]) * kBlock;
    return {load_rotated(weights, part, c.rotation[corner]),
            load_rotated(view.inverse_mass + c.base[corner], part, c.rotation[corner])};
  }
  std::ptrdiff_t coordinate[kWidth], place[kWidth];
  for (int i = 0; i < kWidth; ++i) {
    const int lane = part * kWidth + i;
    coordinate[i] = c.coordinate[corner][lane];
    place[i] = static_cast<std::ptrdiff_t>(c.place[corner][lane]) * kBlock + coordinate[i] % kBlock;
  }
  return {gather(view.shared_weight, place), gather(view.inverse_mass, coordinate)};
}

// As ContactedCoordinates::inverse_mass.
NETPOCKET_INLINE SimdDouble shared_inverse_mass(const ForceView& view, const ContactBlock& c, int part) {
  SimdDouble sum = {};
  for (int corner = 0; corner < 4; ++corner) {
    const SimdDouble weight = load(c.weight[corner], part);
    const auto [shared, inverse_mass] = shares(view, c, corner, part);
    sum = sum + ((weight < broadcast(0.0) ? -weight : weight) * shared) * inverse_mass;
  }
  return sum;
}

// As stepped_normal_force, but at least the force that stops an approach at the greatest depth.
struct Push {
  SimdDouble force, is_stopped, squared_phase;
};
NETPOCKET_INLINE Push normal_force(const ForceView& view, const ContactBlock& c, int part, const SimdDouble& elastic,
                                   const SimdDouble& before, const SimdDouble& after, const SimdDouble& w) {
  const SimdDouble dt = broadcast(view.dt), zero = broadcast(0.0), one = broadcast(1.0), half = broadcast(0.5);
  const SimdDouble stiffness = load(c.stiffness, part), penetration = load(c.penetration, part);
  const SimdDouble root = square_root(larger(penetration, zero));
  const SimdDouble gained = broadcast(1.5) * stiffness * root * dt, compliance = dt * w;
  const SimdDouble implicit = larger(gained - one / compliance, zero);
  const SimdDouble damping = load(c.damping, part) * square_root(root);
  const SimdDouble unopposed = elastic - implicit * after - damping * half * (before + after);
  const SimdDouble push = unopposed / (one + dt * w * (implicit + half * damping));
  const SimdDouble allowed = larger(load(c.deepest, part) - penetration, zero) / dt;
  const SimdDouble stopping = (-allowed - after) / (dt * w);
  const SimdDouble force = larger(push, zero);
  return {larger(force, stopping), stopping > force ? one : zero, gained * compliance};
}

NETPOCKET_INLINE SimdDouble spring_force(const ContactBlock& c, int part) {
  const SimdDouble root = square_root(larger(load(c.penetration, part), broadcast(0.0)));
  return load(c.stiffness, part) * root * root * root;
}

// As sliding_resistance.
NETPOCKET_INLINE SimdDouble resistance(const ForceView& view, const SimdDouble& normal_force, const SimdDouble& speed,
                                       const SimdDouble& w) {
  const SimdDouble stopping = broadcast(1.0) / (w * broadcast(view.dt));
  const SimdDouble coulomb = broadcast(view.friction) * normal_force / larger(speed, broadcast(view.friction_velocity));
  return coulomb < stopping ? coulomb : stopping;
}

}  // namespace

// Any point of a chain is within half a capsule of a vertex. By Pythagoras its squared distance is then at least that
// of the nearest vertex less a quarter of the longest capsule's squared length.
void vertices(const ElementBlock& block, const Vertex* vertices, std::size_t count, const CoordinateRows& coordinates,
              const double* centre, double* rows) {
  for (int part = 0; part < kParts; ++part) {
    const SimdDouble length = load(block.length, part);
    const SimdVector r1 = load_coordinate(coordinates, block, 0, part),
                     g1 = load_coordinate(coordinates, block, 1, part);
    const SimdVector r2 = load_coordinate(coordinates, block, 2, part),
                     g2 = load_coordinate(coordinates, block, 3, part);
    double* out = rows;
    SimdDouble nearest = {}, longest = {};
    SimdVector last = {};
    for (std::size_t i = 0; i < count; ++i) {
      const Vertex& vertex = vertices[i];
      const SimdVector point = (broadcast(vertex.position1) * r1 + (length * broadcast(vertex.gradient1)) * g1) +
                               (broadcast(vertex.position2) * r2 + (length * broadcast(vertex.gradient2)) * g2);
      const SimdVector arm = point - broadcast3(centre);
      const SimdDouble square = dot(arm, arm);
      store3(out, 0, part, point);
      if (i == 0) {
        nearest = square;
      } else {
        const SimdVector way = point - last;
        nearest = square < nearest ? square : nearest;
        longest = larger(longest, dot(way, way));
      }
      last = point;
      out += kVectorRows * kBlock;
    }
    store(out, part, square_root(larger(nearest - broadcast(0.25) * longest, broadcast(0.0))));
  }
}

void forces(const ForceView& view, const BodyMotion& body, ContactBlock* contacts, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ContactBlock& c = contacts[i];
    for (int part = 0; part < kParts; ++part) {
      const SimdVector normal = load3(c.normal, part);
      const SimdVector arm = load3(c.point, part) - broadcast3(body.position);
      const SimdVector surface = body_velocity(body, arm);
      const SimdDouble of_cord = shared_inverse_mass(view, c, part);
      const SimdDouble factor = broadcast(view.inertia_factor), contacts_of_body = broadcast(body.contacts);
      const SimdDouble w = factor * (of_cord + contacts_of_body * inverse_mass_along(body, arm, normal));
      const SimdDouble across = factor * (of_cord + contacts_of_body * largest_inverse_mass(body, arm));
      const SimdVector before = velocity_at_coordinates(view.velocities, c, part) - surface;
      const SimdDouble approach = dot(before, normal);
      const SimdVector after = velocity_at_places(view.predicted, c, part) - surface;
      const SimdDouble separation = dot(after, normal);
      const SimdDouble elastic = spring_force(c, part), share = load(c.share, part);
      const auto [own_push, is_stopped, squared_phase] = normal_force(view, c, part, elastic, approach, separation, w);
      // What takes back a spring's force takes back nothing else.
      const SimdDouble push = share < broadcast(0.0) ? elastic : own_push;
      const SimdVector sliding = after - separation * normal;
      const SimdVector force =
          push * normal - resistance(view, push, square_root(dot(sliding, sliding)), across) * sliding;
      const SimdVector shared_force = share * force;
      const SimdDouble shared_push = share * push, shared_elastic = share * elastic;
      store3(c.force[0], 0, part, shared_force);
      store(c.normal_force, part, shared_push);
      store(c.elastic, part, shared_elastic);
      store(c.damping_power, part, -((shared_push - shared_elastic) * approach));
      store(c.friction_power, part, shared_push * approach - dot(shared_force, before));
      store(c.is_stopped, part, is_stopped);
      store(c.squared_phase, part, squared_phase);
    }
  }
}

namespace {

// Adds eight values to a row; that of lane i to (i + rotation) mod 8.
NETPOCKET_INLINE void add_rotated(double* row, int rotation, const double* values) {
  for (int part = 0; part < kParts; ++part) {
    store(row, part, load(row, part) + load_rotated(values, part, (kBlock - rotation) % kBlock));
  }
}

template <typename Function>
NETPOCKET_INLINE void for_each_lane(const ContactBlock& c, const Function& function) {
  for (int lane = 0; lane < kBlock; ++lane) {
    if ((c.used >> lane & 1U) != 0) function(lane);
  }
}

}  // namespace

void share(const ContactBlock* contacts, std::size_t count, double* shared_weight) {
  for (int corner = 0; corner < 4; ++corner) {
    for (const ContactBlock* c = contacts; c != contacts + count; ++c) {
      alignas(64) double weights[kBlock];
      for (int part = 0; part < kParts; ++part) {
        const SimdDouble weight = load(c->share, part) * load(c->weight[corner], part);
        store(weights, part, weight < broadcast(0.0) ? -weight : weight);
      }
      if (c->is_regular) {
        add_rotated(shared_weight + static_cast<std::ptrdiff_t>(c->place[corner][0]) * kBlock, c->rotation[corner],
                    weights);
      } else {
        for_each_lane(*c, [&](int lane) {
          shared_weight[c->place[corner][lane] * kBlock + c->coordinate[corner][lane] % kBlock] += weights[lane];
        });
      }
    }
  }
}

void apply(const ContactBlock* contacts, std::size_t count, double* forces) {
  for (int corner = 0; corner < 4; ++corner) {
    for (const ContactBlock* c = contacts; c != contacts + count; ++c) {
      for (int axis = 0; axis < kVectorRows; ++axis) {
        alignas(64) double weighted[kBlock];
        for (int part = 0; part < kParts; ++part) {
          store(weighted, part, load(c->weight[corner], part) * load(c->force[axis], part));
        }
        double* row = forces + axis * kBlock;
        if (c->is_regular) {
          add_rotated(row + static_cast<std::ptrdiff_t>(c->base[corner]) * kVectorRows, c->rotation[corner], weighted);
        } else {
          for_each_lane(*c, [&](int lane) {
            const std::ptrdiff_t coordinate = c->coordinate[corner][lane];
            row[coordinate / kBlock * (kVectorRows * kBlock) + coordinate % kBlock] += weighted[lane];
          });
        }
      }
    }
  }
}

void forces_on_body(const ContactBlock* contacts, std::size_t count, const double* centre, BodyForces& sums) {
  for (int part = 0; part < kParts; ++part) {
    SimdVector force = {}, torque = {};
    for (const ContactBlock* c = contacts; c != contacts + count; ++c) {
      const SimdVector on_cord = load3(c->force, part);
      const SimdVector on_body = {-on_cord.x, -on_cord.y, -on_cord.z};
      force = force + on_body;
      torque = torque + cross(load3(c->point, part) - broadcast3(centre), on_body);
    }
    store3(sums.force[0], 0, part, force);
    store3(sums.torque[0], 0, part, torque);
  }
}

void power(const CoordinateRows& velocities, const BodyMotion& body, const ContactBlock* contacts, std::size_t count,
           LanePowers* powers) {
  for (std::size_t i = 0; i < count; ++i) {
    const ContactBlock& c = contacts[i];
    for (int part = 0; part < kParts; ++part) {
      const SimdVector arm = load3(c.point, part) - broadcast3(body.position), normal = load3(c.normal, part);
      const SimdVector velocity = velocity_at_coordinates(velocities.first, c, part) - body_velocity(body, arm);
      const SimdDouble separation = dot(velocity, normal), push = load(c.normal_force, part);
      store(powers[i].damping, part, (push - load(c.elastic, part)) * separation);
      store(powers[i].friction, part, dot(load3(c.force, part), velocity) - push * separation);
    }
  }
}

}  // namespace netpocket::contact_kernel::NETPOCKET_ISA_NAME
