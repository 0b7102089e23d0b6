#include "engine/control/sensor_channel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netpocket {
namespace {

// Part of a period or of a delay by which a look may come early, so that round-off in its time loses no sample.
constexpr double kEarly = 1e-6;

void check_sensor(const SensorSettings& settings, std::size_t size) {
  const auto fits = [&](const std::vector<double>& values) { return values.empty() || values.size() == size; };
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!(settings.rate > 0 && std::isfinite(settings.rate)))
    throw std::invalid_argument("a sensor needs a positive rate");
  if (!(settings.delay >= 0 && settings.delay * settings.rate < 1e6))
    throw std::invalid_argument("the delay of a sensor must be from 0 to 1e6 of its periods");
  if (!(settings.dropout >= 0 && settings.dropout <= 1))
    throw std::invalid_argument("the dropout of a sensor must be from 0 to 1");
  if (!fits(settings.noise) || !fits(settings.bias))
    throw std::invalid_argument("noise and bias of a sensor need one number for each component");
  if (!std::ranges::all_of(settings.noise, [&](double value) { return is_finite(value) && value >= 0; }))
    throw std::invalid_argument("the noise of a sensor must not be negative");
  if (!std::ranges::all_of(settings.bias, is_finite))
    throw std::invalid_argument("the bias of a sensor must be finite");
}

}  // namespace

SensorChannel::SensorChannel(const SensorSettings& settings, std::size_t size)
    : settings_(settings), random_(settings.seed), reading_(size, 0.0) {
  check_sensor(settings, size);
  settings_.noise.resize(size, 0);
  settings_.bias.resize(size, 0);
  // As many as fit into the delay with both ends, one that a late look takes before it reads, and one for round-off.
  const auto capacity = static_cast<std::size_t>(std::ceil(settings.delay * settings.rate)) + 3;
  under_way_.assign(capacity, {0, std::vector<double>(size, 0.0)});
}

bool SensorChannel::is_due(double time) const { return time * settings_.rate >= static_cast<double>(next_) - kEarly; }

void SensorChannel::look(double time, std::span<const double> truth) {
  now_ = time;
  if (is_due(time)) take(time, truth);
  receive(time);
}

void SensorChannel::take(double time, std::span<const double> truth) {
  next_ = static_cast<std::uint64_t>(time * settings_.rate + kEarly) + 1;
  const bool lost = random_.uniform() < settings_.dropout;
  Sample& sample = slot(sent_);
  sample.time = time;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sample.values[i] = truth[i] + settings_.bias[i] + settings_.noise[i] * random_.normal();
  }
  const bool first = sent_ == 0;
  if (first) read(sample);
  if (first || !lost) ++sent_;
}

void SensorChannel::receive(double time) {
  const double latest = time - settings_.delay + kEarly / settings_.rate;
  for (; received_ < sent_ && slot(received_).time <= latest; ++received_) read(slot(received_));
}

void SensorChannel::read(const Sample& sample) {
  read_time_ = sample.time;
  reading_ = sample.values;
}

void SensorChannel::visit_state(const NumberVisitor& visit) {
  random_.visit_state(visit);
  for (Sample& sample : under_way_) {
    visit(sample.time);
    visit_numbers(visit, sample.values);
  }
  for (std::uint64_t* count : {&sent_, &received_, &next_}) visit_count(visit, *count);
  visit(now_);
  visit(read_time_);
  visit_numbers(visit, reading_);
}

}  // namespace netpocket
