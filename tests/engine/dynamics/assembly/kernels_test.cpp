// The kernels of contact, hinges and ropes against their readable forms, and the same bits in every instruction set.

#include <algorithm>
#include <array>
#include <random>

#include "engine/ancf/mass.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/variable_length.h"
#include "engine/contact/force_law.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contacted_coordinates.h"
#include "engine/dynamics/joints/hinge_forces.h"
#include "engine/dynamics/joints/hinge_hold.h"
#include "engine/dynamics/joints/hinge_kernel.h"
#include "engine/dynamics/ropes/rope_kernel.h"
#include "engine/math/symmetric_algebra.h"
#include "tests/engine/dynamics/instruction_sets.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;
using Eigen::Vector3d;

class VerificationKernels : public VerificationTest {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Vector3d vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

 private:
  std::mt19937 generator_{5};
};

constexpr int kElementCoordinates = 64;

// Eight random contacts with a body that turns.
struct Contacts {
  ContactBlock block{};
  contact_kernel::BodyMotion body{{0.1, -0.2, 0.3},
                                  {0.4, 0.1, -0.2},
                                  {0.3, -0.5, 0.2},
                                  1e-2,
                                  {{2e-3, 3e-4, -2e-4}, {3e-4, 1e-3, 1e-4}, {-2e-4, 1e-4, 1.5e-3}},
                                  3e-3,
                                  8};
  CoordinateVectors velocities{kElementCoordinates};
  std::vector<double> inverse_mass;
  ContactedCoordinates contacted{kElementCoordinates};
  double friction = 0.3, friction_velocity = 1e-3, dt = 2e-4;
  double inertia_factor = 1.5;  // of a step after one that was twice as long

  explicit Contacts(VerificationKernels& random) {
    for (int coordinate = 0; coordinate < kElementCoordinates; ++coordinate) {
      velocities.set(coordinate, random.vector(1));
      inverse_mass.push_back(random.uniform(1, 100));
    }
    block.used = (1U << kBlockSize) - 1;
    for (int lane = 0; lane < kBlockSize; ++lane) {
      const Vector3d normal = random.vector(1).normalized(), point = random.vector(2);
      for (int axis = 0; axis < 3; ++axis) {
        block.normal[axis][lane] = normal[axis];
        block.point[axis][lane] = point[axis];
      }
      block.penetration[lane] = lane == 3 ? 0 : random.uniform(0, 5e-3);
      block.stiffness[lane] = random.uniform(1e4, lane % 2 == 0 ? 1e5 : 1e9);  // the step resolves some of them
      block.damping[lane] = random.uniform(0, 100);
      block.deepest[lane] = lane == 5 ? 0 : 0.01;  // one that an approach may not press in
      block.share[lane] = random.uniform(0, 1);
      for (int corner = 0; corner < 4; ++corner) {
        block.coordinate[corner][lane] = (lane * 7 + corner * 13) % kElementCoordinates;
        block.weight[corner][lane] = random.uniform(-0.2, 1);
        block.place[corner][lane] =
            contacted.share(block.coordinate[corner][lane], block.share[lane] * block.weight[corner][lane]);
      }
    }
    contacted.predict(velocities, inverse_mass, dt, [&](auto blocks, double* rows) {
      std::generate_n(rows, blocks.size() * kVectorRows * kBlockSize, [&] { return random.uniform(-20, 20); });
    });
  }

  contact_kernel::ForceView view() const {
    return {velocities.rows().first,
            contacted.predicted_rows(),
            contacted.shared_weights(),
            inverse_mass.data(),
            friction,
            friction_velocity,
            dt,
            inertia_factor};
  }
  ElementIndices coordinate(int lane) const {
    return {block.coordinate[0][lane], block.coordinate[1][lane], block.coordinate[2][lane], block.coordinate[3][lane]};
  }
  ElementWeights weight(int lane) const {
    return {block.weight[0][lane], block.weight[1][lane], block.weight[2][lane], block.weight[3][lane]};
  }
  Vector3d before(int lane) const {
    const Vector3d arm = lane_of(block.point, lane) - Vector3d(body.position);
    const Vector3d surface = Vector3d(body.velocity) + Vector3d(body.angular_velocity).cross(arm);
    return combine(velocities, coordinate(lane), weight(lane)) - surface;
  }
  double elastic(int lane) const {
    return block.share[lane] * normal_force({block.stiffness[lane], 0}, block.penetration[lane], 0);
  }
  // By force_law.h.
  Vector3d force(int lane) const {
    const Vector3d point = lane_of(block.point, lane), normal = lane_of(block.normal, lane);
    const Vector3d arm = point - Vector3d(body.position);
    const Vector3d surface = Vector3d(body.velocity) + Vector3d(body.angular_velocity).cross(arm);
    const Vector3d turn = arm.cross(normal);
    Eigen::Matrix3d inverse_inertia;
    for (int axis = 0; axis < 3; ++axis) inverse_inertia.row(axis) = Vector3d(body.inverse_inertia[axis]);
    const double of_cord = contacted.inverse_mass(coordinate(lane), weight(lane), inverse_mass);
    const double w =
        inertia_factor * (of_cord + body.contacts * (body.inverse_mass + turn.dot(inverse_inertia * turn)));
    const double across =
        inertia_factor *
        (of_cord + body.contacts * (body.inverse_mass + arm.squaredNorm() * body.largest_inverse_inertia));
    const Vector3d after = combine(contacted, coordinate(lane), weight(lane)) - surface;
    const NormalLaw law{block.stiffness[lane], block.damping[lane]};
    const double allowed = std::max(block.deepest[lane] - block.penetration[lane], 0.0) / dt;
    const double stopping = (-allowed - after.dot(normal)) / (dt * w);
    const double push = std::max(
        stepped_normal_force(law, block.penetration[lane], {before(lane).dot(normal), after.dot(normal)}, w, dt),
        stopping);
    const Vector3d sliding = after - after.dot(normal) * normal;
    const double resistance = sliding_resistance(friction, friction_velocity, push, sliding.norm(), across, dt);
    return block.share[lane] * (push * normal - resistance * sliding);
  }
};

TEST_F(VerificationKernels, ContactForces) {
  const Contacts contacts(*this);
  ContactBlock first{};
  double difference = 0, largest = 0;
  for (int lane = 0; lane < kBlockSize; ++lane) largest = std::max(largest, contacts.force(lane).norm());
  for_each_instruction_set<contact_kernel::ForceKernel>(
      contact_kernel::baseline::forces, contact_kernel::avx2::forces, contact_kernel::avx512::forces,
      [&](const std::string& name, contact_kernel::ForceKernel kernel) {
        ContactBlock block = contacts.block;
        kernel(contacts.view(), contacts.body, &block, 1);
        if (name == "baseline") first = block;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          const Vector3d force = contacts.force(lane), normal = lane_of(block.normal, lane);
          difference = std::max(difference, (lane_of(block.force, lane) - force).norm());
          EXPECT_NEAR(block.normal_force[lane], force.dot(normal), 1e-12 * largest);
          EXPECT_NEAR(block.elastic[lane], contacts.elastic(lane), 1e-12 * largest);
          EXPECT_EQ(lane_of(block.force, lane), lane_of(first.force, lane)) << name;
        }
      });
  EXPECT_GT(largest, 1);
  expect_below("contact kernel against the force law, relative", difference / largest, 1e-13, "round-off");
  contact_kernel::ContactPower power;
  for_each_instruction_set<contact_kernel::PowerKernel>(
      contact_kernel::baseline::power, contact_kernel::avx2::power, contact_kernel::avx512::power,
      [&](const std::string& name, contact_kernel::PowerKernel kernel) {
        contact_kernel::LanePowers powers;
        kernel(contacts.velocities.rows(), contacts.body, &first, 1, &powers);
        contact_kernel::ContactPower here;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          here += contact_kernel::ContactPower{-powers.damping[lane], -powers.friction[lane]};
        }
        if (name == "baseline") power = here;
        EXPECT_EQ(here.damping, power.damping) << name;
        EXPECT_EQ(here.friction, power.friction) << name;
      });
  double all = 0, of_springs = 0, by_friction = 0;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const Vector3d normal = lane_of(first.normal, lane), force = lane_of(first.force, lane);
    const Vector3d velocity = contacts.before(lane);
    all -= force.dot(velocity);
    of_springs -= contacts.elastic(lane) * velocity.dot(normal);
    by_friction -= (force - force.dot(normal) * normal).dot(velocity);
  }
  EXPECT_NEAR(power.friction, by_friction, 1e-12 * largest);
  EXPECT_NEAR(power.damping + power.friction + of_springs, all, 1e-12 * largest);
}

// Blocks that read whole blocks of coordinates give the bits of those that gather.
TEST_F(VerificationKernels, ContactsInTheLanesOfTheirElements) {
  Contacts contacts(*this);
  ContactBlock& block = contacts.block;
  contacts.contacted.clear();
  for (int corner = 0; corner < 4; ++corner) {
    block.base[corner] = 16 * corner;
    block.rotation[corner] = corner;
    for (int lane = 0; lane < kBlockSize; ++lane) {
      block.coordinate[corner][lane] = 16 * corner + (lane + corner) % kBlockSize;
      block.place[corner][lane] = contacts.contacted.place_for(block.coordinate[corner][lane]);
    }
  }
  std::vector<double> by_hand(4 * kBlockSize, 0.0);
  for (int corner = 0; corner < 4; ++corner) {
    for (int lane = 0; lane < kBlockSize; ++lane) {
      by_hand[static_cast<std::size_t>(block.place[corner][lane] * kBlockSize + (lane + corner) % kBlockSize)] +=
          std::abs(block.share[lane] * block.weight[corner][lane]);
    }
  }
  for (const bool is_regular : {false, true}) {
    block.is_regular = is_regular;
    for_each_instruction_set<contact_kernel::ShareKernel>(
        contact_kernel::baseline::share, contact_kernel::avx2::share, contact_kernel::avx512::share,
        [&](const std::string& name, contact_kernel::ShareKernel kernel) {
          AlignedVector<double> shared(4 * kBlockSize, 0.0);
          kernel(&block, 1, shared.data());
          EXPECT_TRUE(std::ranges::equal(shared, by_hand)) << name;
        });
  }
  block.is_regular = false;
  for (int corner = 0; corner < 4; ++corner) {
    for (int lane = 0; lane < kBlockSize; ++lane) {
      contacts.contacted.share(block.coordinate[corner][lane], block.share[lane] * block.weight[corner][lane]);
    }
  }
  contacts.contacted.predict(contacts.velocities, contacts.inverse_mass, contacts.dt, [&](auto blocks, double* rows) {
    std::generate_n(rows, blocks.size() * kVectorRows * kBlockSize, [&] { return uniform(-20, 20); });
  });
  const AlignedVector<double> inverse_mass(contacts.inverse_mass.begin(), contacts.inverse_mass.end());
  contact_kernel::ForceView view = contacts.view();
  view.inverse_mass = inverse_mass.data();
  ContactBlock gathered = block;
  contact_kernel::baseline::forces(view, contacts.body, &gathered, 1);
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = force;
  CoordinateVectors expected(kElementCoordinates);
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const Vector3d on_cord = lane_of(gathered.force, lane);
    force -= on_cord;
    torque -= (lane_of(block.point, lane) - Vector3d(contacts.body.position)).cross(on_cord);
    for (int corner = 0; corner < 4; ++corner) {
      expected.add(block.coordinate[corner][lane], block.weight[corner][lane] * on_cord);
    }
  }
  EXPECT_GT(force.norm(), 1);
  for_each_instruction_set<contact_kernel::ForceKernel>(
      contact_kernel::baseline::forces, contact_kernel::avx2::forces, contact_kernel::avx512::forces,
      [&](const std::string& name, contact_kernel::ForceKernel kernel) {
        ContactBlock regular = block;
        regular.is_regular = true;
        kernel(view, contacts.body, &regular, 1);
        for (int lane = 0; lane < kBlockSize; ++lane) {
          EXPECT_EQ(lane_of(regular.force, lane), lane_of(gathered.force, lane)) << name;
          EXPECT_EQ(regular.friction_power[lane], gathered.friction_power[lane]) << name;
        }
      });
  for (const bool is_regular : {false, true}) {
    gathered.is_regular = is_regular;
    for_each_instruction_set<contact_kernel::ApplyKernel>(
        contact_kernel::baseline::apply, contact_kernel::avx2::apply, contact_kernel::avx512::apply,
        [&](const std::string& name, contact_kernel::ApplyKernel kernel) {
          CoordinateVectors applied(kElementCoordinates);
          kernel(&gathered, 1, applied.data());
          for (int i = 0; i < kElementCoordinates; ++i) EXPECT_EQ(applied.get(i), expected.get(i)) << name << i;
        });
  }
  for_each_instruction_set<contact_kernel::BodyKernel>(
      contact_kernel::baseline::forces_on_body, contact_kernel::avx2::forces_on_body,
      contact_kernel::avx512::forces_on_body, [&](const std::string& name, contact_kernel::BodyKernel kernel) {
        contact_kernel::BodyForces sums;
        kernel(&gathered, 1, contacts.body.position, sums);
        Vector3d total = Vector3d::Zero(), turning = total;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          total += lane_of(sums.force, lane);
          turning += lane_of(sums.torque, lane);
        }
        EXPECT_LT((total - force).norm(), 1e-12 * force.norm()) << name;
        EXPECT_LT((turning - torque).norm(), 1e-12 * torque.norm()) << name;
      });
}

TEST_F(VerificationKernels, ContactPoints) {
  CoordinateVectors coordinates(kElementCoordinates);
  for (int coordinate = 0; coordinate < kElementCoordinates; ++coordinate) coordinates.set(coordinate, vector(3));
  std::vector<BatchElement> elements;
  for (int i = 0; i < kBlockSize; ++i) {
    elements.push_back(
        {{i, 16 + (i + 3) % 8, (5 * i + 40) % kElementCoordinates, 24 + i}, uniform(0.1, 1), CableSection{}});
  }
  const ElementBatch batch(elements);
  const std::vector<contact_kernel::Vertex> vertices = {
      {1, 0, 0, 0}, {0.7, 0.1, 0.3, -0.1}, {0.5, 0.125, 0.5, -0.125}, {0, 0, 1, 0}};
  const std::size_t bounds = vertices.size() * kVectorRows * kBlockSize;
  const Vector3d centre(0.3, -0.2, 0.1);
  AlignedVector<double> first;
  double difference = 0;
  for_each_instruction_set<contact_kernel::VertexKernel>(
      contact_kernel::baseline::vertices, contact_kernel::avx2::vertices, contact_kernel::avx512::vertices,
      [&](const std::string& name, contact_kernel::VertexKernel kernel) {
        AlignedVector<double> rows(bounds + kBlockSize);
        kernel(batch.block(0), vertices.data(), vertices.size(), coordinates.rows(), centre.data(), rows.data());
        if (name == "baseline") first = rows;
        EXPECT_EQ(rows, first) << name;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          const BatchElement& e = elements[static_cast<std::size_t>(lane)];
          double nearest = 1e9;
          Vector3d last = Vector3d::Zero();
          for (std::size_t v = 0; v < vertices.size(); ++v) {
            const Vector3d point =
                combine(coordinates, {e.coordinate[0], e.coordinate[1], e.coordinate[2], e.coordinate[3]},
                        {vertices[v].position1, e.length * vertices[v].gradient1, vertices[v].position2,
                         e.length * vertices[v].gradient2});
            const double* row = rows.data() + v * kVectorRows * kBlockSize + lane;
            difference = std::max(difference, (point - Vector3d(row[0], row[8], row[16])).norm());
            for (int i = 0; v > 0 && i <= 100; ++i) {
              nearest = std::min(nearest, (last + i / 100.0 * (point - last) - centre).norm());
            }
            last = point;
          }
          EXPECT_LE(rows[bounds + static_cast<std::size_t>(lane)], nearest) << "a bound that is none";
          EXPECT_GE(rows[bounds + static_cast<std::size_t>(lane)], nearest - 1.5) << "capsules of some 3 m";
        }
      });
  expect_below("points of elements by kernel, m", difference, 1e-14, "round-off");
}

TEST_F(VerificationKernels, Hinges) {
  CoordinateVectors gradients(kElementCoordinates), rates(kElementCoordinates);
  for (int coordinate = 0; coordinate < kElementCoordinates; ++coordinate) {
    gradients.set(coordinate, vector(1));
    rates.set(coordinate, vector(2));
  }
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(0.7, vector(1).normalized()).toRotationMatrix();
  const Vector3d spin = vector(1);
  HingeBlock block;
  std::vector<Hinge> hinges;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const Eigen::Matrix3d rest = Eigen::AngleAxisd(uniform(0, 1), vector(1).normalized()).toRotationMatrix();
    hinges.push_back({lane, 63 - 5 * lane, rest, 0, uniform(1, 100), uniform(0, 3)});
    // One at its angle of rest, where neither sine nor rate may divide.
    if (lane == 2) gradients.set(63 - 5 * lane, axes * rest * axes.transpose() * gradients.get(lane));
    if (lane == 4) gradients.set(lane, 0.2 * gradients.get(lane).normalized());  // held loosely
    for (int i = 0; i < 9; ++i) block.rest_rotation[i][lane] = rest.data()[i];
    block.stiffness[lane] = hinges.back().stiffness;
    block.damping[lane] = lane == 2 ? hinges.back().damping = 0 : hinges.back().damping;
    block.gradient1[lane] = hinges.back().gradient1;
    block.gradient2[lane] = hinges.back().gradient2;
  }
  block.count = kBlockSize;
  hinge_kernel::Axes body_axes{};
  std::copy_n(axes.data(), 9, body_axes.rotation);
  std::copy_n(spin.data(), 3, body_axes.angular_velocity);
  const double dt = 1e-2;
  std::vector<double> inverse_mass(kElementCoordinates);
  for (double& value : inverse_mass) value = uniform(1, 200);
  HingeBlock first;
  double difference = 0;
  int limited = 0;
  for_each_instruction_set<hinge_kernel::Kernel>(
      hinge_kernel::baseline::forces, hinge_kernel::avx2::forces, hinge_kernel::avx512::forces,
      [&](const std::string& name, hinge_kernel::Kernel kernel) {
        HingeBlock result = block;
        kernel(gradients.rows(), rates.rows(), inverse_mass.data(), dt, body_axes, result);
        if (name == "baseline") first = result;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          Hinge hinge = hinges[static_cast<std::size_t>(lane)];
          const double i1 = inverse_mass[static_cast<std::size_t>(hinge.gradient1)];
          const double i2 = inverse_mass[static_cast<std::size_t>(hinge.gradient2)];
          const double turning =
              i1 / gradients.get(hinge.gradient1).squaredNorm() + i2 / gradients.get(hinge.gradient2).squaredNorm();
          const double allowed = std::max(1 / (dt * turning), hinge.damping * (i1 + i2) / turning);
          limited += hinge.damping > allowed ? 1 : 0;
          EXPECT_EQ(result.is_limited[lane], hinge.damping > allowed ? 1 : 0) << name;
          const bool is_firm =
              gradients.get(hinge.gradient1).norm() >= kFirmHold && gradients.get(hinge.gradient2).norm() >= kFirmHold;
          EXPECT_EQ(result.is_loose[lane], is_firm ? 0 : 1) << name;
          hinge.damping = std::min(hinge.damping, allowed);
          const HingeForces expected =
              hinge_forces(hinge, gradients.get(hinge.gradient1), gradients.get(hinge.gradient2),
                           rates.get(hinge.gradient1), rates.get(hinge.gradient2), axes, spin);
          const double size = expected.on_gradient1.norm() + expected.on_gradient2.norm() + 1;
          const double error = (lane_of(result.on_gradient1, lane) - expected.on_gradient1).norm() +
                               (lane_of(result.on_gradient2, lane) - expected.on_gradient2).norm() +
                               (lane_of(result.torque_on_body, lane) - expected.torque_on_body).norm();
          difference = std::max(difference, error / size);
          EXPECT_NEAR(result.dissipated_power[lane], expected.dissipated_power, 1e-11 * size);
          EXPECT_EQ(lane_of(result.on_gradient1, lane), lane_of(first.on_gradient1, lane)) << name;
          EXPECT_EQ(lane_of(result.torque_on_body, lane), lane_of(first.torque_on_body, lane)) << name;
        }
      });
  EXPECT_GT(limited, 0);
  expect_below("hinge kernel against its readable form, relative", difference, 1e-12, "round-off");
}

TEST_F(VerificationKernels, Ropes) {
  CoordinateVectors coordinates(kElementCoordinates), velocities(kElementCoordinates);
  for (int coordinate = 0; coordinate < kElementCoordinates; ++coordinate) {
    coordinates.set(coordinate, vector(3));
    velocities.set(coordinate, vector(2));
  }
  RopeBlock block{};
  block.count = kBlockSize;
  std::array<MaterialSpan, kBlockSize> before, now;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    before[lane] = {.length = uniform(0.5, 2), .start_rate = uniform(-1, 1), .end_rate = uniform(-1, 1)};
    now[lane] = {.length = before[lane].length + uniform(-0.1, 0.1), .start_rate = uniform(-1, 1), .end_rate = 0.3};
    for (const auto& [rows, span] : {std::pair{&block.before, before[lane]}, {&block.now, now[lane]}}) {
      rows->length[lane] = span.length;
      rows->start_rate[lane] = span.start_rate;
      rows->end_rate[lane] = span.end_rate;
    }
    block.mass_per_length[lane] = uniform(0.01, 1);
    for (int corner = 0; corner < 4; ++corner)
      block.coordinate[corner][lane] = (11 * lane + 5 * corner) % kElementCoordinates;
  }
  const auto columns = [&](const CoordinateVectors& vectors, int lane) {
    ElementCoordinates q;
    for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(block.coordinate[corner][lane]);
    return q;
  };
  const double last_dt = 2e-3, kick = 1.5e-3;
  RopeBlock first{};
  double difference = 0;
  for_each_instruction_set<rope_kernel::ForceKernel>(
      rope_kernel::baseline::forces, rope_kernel::avx2::forces, rope_kernel::avx512::forces,
      [&](const std::string& name, rope_kernel::ForceKernel kernel) {
        RopeBlock result = block;
        kernel(coordinates.rows(), velocities.rows(), last_dt, kick, result);
        if (name == "baseline") first = result;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          const double m = block.mass_per_length[lane];
          const ElementCoordinates q = columns(coordinates, lane), v = columns(velocities, lane);
          const NodalWeights lost = lumped_mass(m, before[lane].length) - lumped_mass(m, now[lane].length);
          const ElementCoordinates impulse =
              v * lost.asDiagonal() + flow_momentum(m, before[lane], q - last_dt * v) - flow_momentum(m, now[lane], q);
          const ElementCoordinates force = impulse / kick + flow_force(m, now[lane], q, v);
          for (int corner = 0; corner < 4; ++corner) {
            const Vector3d found = lane_of(result.force[corner], lane);
            difference = std::max(difference, (found - force.col(corner)).norm() / force.norm());
            EXPECT_EQ(found, lane_of(first.force[corner], lane)) << name;
          }
        }
      });
  expect_below("rope kernel against its readable form, relative", difference, 1e-13, "round-off");
  for_each_instruction_set<rope_kernel::EnergyKernel>(
      rope_kernel::baseline::energy_change, rope_kernel::avx2::energy_change, rope_kernel::avx512::energy_change,
      [&](const std::string& name, rope_kernel::EnergyKernel kernel) {
        RopeBlock result = block;
        kernel(coordinates.rows(), velocities.rows(), result);
        if (name == "baseline") first = result;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          const double m = block.mass_per_length[lane];
          const ElementCoordinates q = columns(coordinates, lane), v = columns(velocities, lane);
          const double energy = kinetic_energy(m, now[lane], q, v);
          EXPECT_NEAR(result.energy_change[lane], energy - kinetic_energy(m, before[lane], q, v), 1e-13 * energy);
          EXPECT_EQ(result.energy_change[lane], first.energy_change[lane]) << name;
        }
      });
}

TEST_F(VerificationKernels, RopeTensions) {
  CoordinateVectors coordinates(kElementCoordinates), velocities(kElementCoordinates);
  for (int coordinate = 0; coordinate < kElementCoordinates; ++coordinate) {
    coordinates.set(coordinate, vector(1));
    velocities.set(coordinate, vector(2));
  }
  RopeBlock block{};
  SpanRows spans{};
  std::array<CableSection, kBlockSize> sections;
  for (int lane = 0; lane < kBlockSize; ++lane) {
    sections[lane] = {.EA = uniform(1, 100), .axial_damping = uniform(0, 0.1), .compression = uniform(0, 1)};
    block.axial_stiffness[lane] = sections[lane].EA;
    block.compression[lane] = sections[lane].compression;
    block.axial_damping[lane] = sections[lane].axial_damping;
    spans.length[lane] = uniform(0.5, 4);
    spans.start_rate[lane] = uniform(-1, 1);
    spans.end_rate[lane] = uniform(-1, 1);
    for (int corner = 0; corner < 4; ++corner)
      block.coordinate[corner][lane] = (11 * lane + 5 * corner) % kElementCoordinates;
  }
  double difference = 0;
  int compressed = 0;
  std::array<double, kBlockSize> first{};
  for_each_instruction_set<rope_kernel::TensionKernel>(
      rope_kernel::baseline::tensions, rope_kernel::avx2::tensions, rope_kernel::avx512::tensions,
      [&](const std::string& name, rope_kernel::TensionKernel kernel) {
        alignas(64) std::array<double, kBlockSize> result{};
        kernel(coordinates.rows(), velocities.rows(), spans, block, result.data());
        if (name == "baseline") first = result;
        for (int lane = 0; lane < kBlockSize; ++lane) {
          ElementCoordinates q, v;
          for (int corner = 0; corner < 4; ++corner) {
            q.col(corner) = coordinates.get(block.coordinate[corner][lane]);
            v.col(corner) = velocities.get(block.coordinate[corner][lane]);
          }
          const MaterialSpan span{
              .length = spans.length[lane], .start_rate = spans.start_rate[lane], .end_rate = spans.end_rate[lane]};
          const MeanStrainElement element(sections[lane], span);
          if (element.strain(q) < 0) ++compressed;
          const double size = sections[lane].EA * (std::abs(element.strain(q)) + 1);
          difference = std::max(difference, std::abs(result[lane] - element.tension(q, v)) / size);
          EXPECT_EQ(result[lane], first[lane]) << name;
        }
      });
  EXPECT_GT(compressed, 0);
  expect_below("tension kernel of ropes against its readable form, relative", difference, 1e-13, "round-off");
}

}  // namespace
}  // namespace netpocket
