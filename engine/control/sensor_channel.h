#pragma once
// A sensor: what a controller knows of quantities, with noise, bias, delay, its own rate and dropouts.
//
// The n-th sample is due at n/rate and is taken at the first look from then on; a look that is late skips the samples
// it missed. A sample is the truth plus the bias plus white noise: independent normal numbers by component and sample.
// It arrives after the delay. A lost sample does not arrive, and the reading stays the last one. Until the first sample
// arrives, the reading is that sample, as if all had been at rest before the run; it is never lost.
//
// Random numbers are drawn alike for lost and other samples. So the noise of a sample does not depend on the dropouts.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/control/random_numbers.h"
#include "engine/control/visited_numbers.h"

namespace netpocket {

struct SensorSettings {
  double rate = 100;               // Hz, positive
  double delay = 0;                // s, from the sample to its arrival
  double dropout = 0;              // probability that a sample is lost, 0 to 1
  std::vector<double> noise = {};  // standard deviation by component, in its unit; empty: none
  std::vector<double> bias = {};   // by component, in its unit; empty: none
  std::uint64_t seed = 1;          // of the noise and the dropouts
};

class SensorChannel {
 public:
  // `size`: number of components. Throws std::invalid_argument unless the settings are as described above.
  SensorChannel(const SensorSettings& settings, std::size_t size);

  // Shows the sensor the truth, `size` components, at `time` (s). Times must not fall.
  void look(double time, std::span<const double> truth);

  // What has arrived until the last look; valid until the next one. Zeros before the first look.
  std::span<const double> reading() const { return reading_; }
  // Time (s) between the last look and the sample that is read.
  double age() const { return now_ - read_time_; }

  void visit_state(const NumberVisitor& visit);

 private:
  struct Sample {
    double time = 0;  // s
    std::vector<double> values;
  };
  bool is_due(double time) const;
  void take(double time, std::span<const double> truth);
  void receive(double time);
  void read(const Sample& sample);
  Sample& slot(std::uint64_t index) { return under_way_[index % under_way_.size()]; }

  SensorSettings settings_;
  RandomNumbers random_;
  // Ring of the samples that have not arrived yet: those with the numbers received_ to sent_ - 1.
  std::vector<Sample> under_way_;
  std::uint64_t sent_ = 0, received_ = 0;
  std::uint64_t next_ = 0;  // the next sample is due at next_/rate
  double now_ = 0;          // s, of the last look
  double read_time_ = 0;    // s, of the sample that is read
  std::vector<double> reading_;
};

}  // namespace netpocket
