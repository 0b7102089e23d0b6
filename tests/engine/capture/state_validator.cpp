#include "tests/engine/capture/state_validator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace netpocket::test {
namespace {

// The last two numbers of a state are the times that the computation took.
constexpr std::size_t kTimings = 2;

bool are_same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

void expect_same_numbers(std::span<const double> a, std::span<const double> b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(are_same(a[i], b[i])) << what << ": number " << i << " of " << a.size() << " is " << b[i]
                                      << " instead of " << a[i] << ", off by " << b[i] - a[i];
  }
}

template <typename Matrix>
void expect_same_matrix(const Matrix& a, const Matrix& b, const std::string& what) {
  const auto numbers = [](const Matrix& m) {
    return std::span<const double>(m.data(), static_cast<std::size_t>(m.size()));
  };
  expect_same_numbers(numbers(a), numbers(b), what);
}

// What follows from a state.
struct Outcome {
  std::vector<double> state;  // at the end
  Snapshot snapshot;          // of it
};

std::vector<double> state_of(const Simulation& simulation) {
  std::vector<double> state = simulation.checkpoint();
  state.resize(state.size() - kTimings);
  return state;
}

Outcome outcome_of(Simulation& simulation, double until) {
  const RunStatus status = simulation.advance(until);
  EXPECT_EQ(status.reason, RunReason::finished) << status.message;
  Outcome outcome;
  outcome.state = state_of(simulation);
  outcome.snapshot = simulation.snapshot();
  return outcome;
}

void expect_same_outcome(const Outcome& a, const Outcome& b, const std::string& what) {
  expect_same_numbers(a.state, b.state, what + ", state");
  expect_same_bits(a.snapshot, b.snapshot, what);
}

}  // namespace

void expect_same_bits(const Snapshot& a, const Snapshot& b, const std::string& what) {
  EXPECT_EQ(a.time, b.time) << what;
  EXPECT_EQ(a.step, b.step) << what;
  expect_same_matrix(a.positions, b.positions, what + ", positions");
  expect_same_matrix(a.velocities, b.velocities, what + ", velocities");
  expect_same_matrix(a.gradients, b.gradients, what + ", gradients");
  expect_same_matrix(a.tension, b.tension, what + ", tension");
  expect_same_matrix(a.strain, b.strain, what + ", strain");
  expect_same_numbers(a.rope_element_length, b.rope_element_length, what + ", rope length");
  ASSERT_EQ(a.bodies.size(), b.bodies.size()) << what;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const std::string body = what + ", body " + std::to_string(i);
    expect_same_matrix(a.bodies[i].position, b.bodies[i].position, body + ", position");
    expect_same_matrix(a.bodies[i].attitude.coeffs(), b.bodies[i].attitude.coeffs(), body + ", attitude");
    expect_same_matrix(a.bodies[i].velocity, b.bodies[i].velocity, body + ", velocity");
    expect_same_matrix(a.bodies[i].angular_velocity, b.bodies[i].angular_velocity, body + ", angular velocity");
  }
  ASSERT_EQ(a.contacts.size(), b.contacts.size()) << what;
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    expect_same_matrix(a.contacts[i].position, b.contacts[i].position, what + ", place of contact");
    expect_same_matrix(a.contacts[i].force, b.contacts[i].force, what + ", force of contact");
  }
  expect_same_numbers(a.channels, b.channels, what + ", channels");
}

void advance_validated(Simulation& simulation, double until) {
  const std::vector<double> begin = simulation.checkpoint();
  const std::string what = "from " + std::to_string(simulation.time()) + " s";
  const Snapshot seen = simulation.snapshot();
  simulation.restore(begin);  // to look changes the channels' state
  const Outcome straight = outcome_of(simulation, until);
  const std::vector<double> end = simulation.checkpoint();

  simulation.restore(begin);
  expect_same_numbers(std::span(begin).first(begin.size() - kTimings), state_of(simulation), what + ", restored");
  expect_same_bits(seen, simulation.snapshot(), what + ", seen when restored");
  simulation.restore(begin);
  expect_same_outcome(straight, outcome_of(simulation, until), what + ", restored and stepped again");

  Simulation fresh(simulation.scenario());
  fresh.restore(begin);
  expect_same_bits(seen, fresh.snapshot(), what + ", seen in a new simulation");
  fresh.restore(begin);
  expect_same_outcome(straight, outcome_of(fresh, until), what + ", stepped in a new simulation");
  simulation.restore(end);
}

void advance_validated(Simulation& simulation, double until, double stretch) {
  const int count = static_cast<int>(std::ceil((until - simulation.time()) / stretch - 0.5));
  for (int left = count - 1; left >= 0 && !testing::Test::HasFailure(); --left) {
    advance_validated(simulation, until - left * stretch);
  }
}

}  // namespace netpocket::test
