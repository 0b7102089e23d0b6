#include "engine/dynamics/contact/contact_stop.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

class ContactStop {
 public:
  ContactStop(std::span<ContactBlock> contacts, std::span<const std::int32_t> places, const RigidBody& body,
              double shares, ContactedCoordinates& contacted, std::span<const double> inverse_mass,
              const StepTimes& times)
      : contacts_(contacts),
        places_(places),
        body_(body),
        shares_(shares),
        contacted_(contacted),
        inverse_mass_(inverse_mass),
        times_(times) {}

  void complete() {
    constexpr int kMostRounds = 200;
    for_each([&](ContactBlock& block, int lane) { push(block, lane, lane_of(block.force, lane)); });
    for (int round = 0; round < kMostRounds && add_what_is_missing(); ++round) {
    }
    for_each([&](ContactBlock& block, int lane) {
      if (is_stopped(block, lane)) take_up_springs(block, lane);
    });
  }

 private:
  static bool is_stopped(const ContactBlock& block, int lane) { return block.is_stopped[lane] > 0; }
  static ElementIndices indices(const ContactBlock& block, int lane) {
    return {block.coordinate[0][lane], block.coordinate[1][lane], block.coordinate[2][lane], block.coordinate[3][lane]};
  }
  static ElementWeights weights(const ContactBlock& block, int lane) {
    return {block.weight[0][lane], block.weight[1][lane], block.weight[2][lane], block.weight[3][lane]};
  }
  template <typename Function>
  void for_each(const Function& function) {
    for (const std::int32_t place : places_) {
      function(contacts_[static_cast<std::size_t>(place / kBlockSize)], place % kBlockSize);
    }
  }

  // Applies a force (N, on the cord) to the predicted velocities.
  void push(const ContactBlock& block, int lane, const Vector3d& force) {
    for (int corner = 0; corner < 4; ++corner) {
      const std::int32_t coordinate = block.coordinate[corner][lane];
      contacted_.add_to_prediction(coordinate,
                                   (times_.kick * inverse_mass_[coordinate] * block.weight[corner][lane]) * force);
    }
    body_.kick(-force, (lane_of(block.point, lane) - body_.position()).cross(-force), times_.kick);
  }

  double separation_speed(const ContactBlock& block, int lane) const {
    const Vector3d velocity = combine(contacted_, indices(block, lane), weights(block, lane));
    return symmetric_dot(velocity - body_.velocity_at(lane_of(block.point, lane)), lane_of(block.normal, lane));
  }

  // Returns false if nothing is missing.
  bool add_what_is_missing() {
    constexpr double kSmall = 1e-3;  // m/s: a lasting load sinks in no faster
    missing_.clear();
    double largest = 0;
    for_each([&](const ContactBlock& block, int lane) {
      const double allowed = std::max(block.deepest[lane] - block.penetration[lane], 0.0) / times_.drift;
      const double missing = std::max(-allowed - separation_speed(block, lane), 0.0);
      const double w = contacted_.inverse_mass(indices(block, lane), weights(block, lane), inverse_mass_) +
                       shares_ * body_.inverse_mass_at(lane_of(block.point, lane), lane_of(block.normal, lane));
      largest = std::max(largest, missing);
      missing_.push_back(block.share[lane] * missing / (times_.kick * w));
    });
    if (!(largest > kSmall)) return false;
    std::size_t next = 0;
    for_each([&](ContactBlock& block, int lane) {
      const double force = missing_[next++];
      const Vector3d along = force * lane_of(block.normal, lane);
      block.normal_force[lane] += force;
      if (force > 0) block.is_stopped[lane] = 1;
      for (int axis = 0; axis < 3; ++axis) block.force[axis][lane] += along[axis];
      push(block, lane, along);
    });
    return true;
  }

  // A cord that is stopped within a step has also compressed its spring. The spring takes a part of the impact, its
  // mean force over the distance. The rest is dissipated.
  void take_up_springs(ContactBlock& block, int lane) const {
    const NormalLaw law{block.stiffness[lane], 0};
    const double before = block.penetration[lane], way = -separation_speed(block, lane) * times_.drift;
    const double after = before + way;
    if (!(std::abs(way) > 0)) return;
    block.elastic[lane] = block.share[lane] * (elastic_energy(law, after) - elastic_energy(law, before)) / way;
  }

  std::span<ContactBlock> contacts_;
  std::span<const std::int32_t> places_;
  RigidBody body_;
  double shares_;
  ContactedCoordinates& contacted_;
  std::span<const double> inverse_mass_;
  StepTimes times_;
  std::vector<double> missing_;  // N, by contact
};

}  // namespace

void complete_stops(std::span<ContactBlock> contacts, std::span<const std::int32_t> places, const RigidBody& body,
                    double shares, ContactedCoordinates& contacted, std::span<const double> inverse_mass,
                    const StepTimes& times) {
  ContactStop(contacts, places, body, shares, contacted, inverse_mass, times).complete();
}

}  // namespace netpocket
