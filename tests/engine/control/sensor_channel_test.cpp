// Sensors: sample times, delay, statistics of noise, bias and dropouts.

#include "engine/control/sensor_channel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace netpocket {
namespace {

// The truth is the time, so that a reading tells when it was sampled.
double reading_at(SensorChannel& sensor, double time) {
  sensor.look(time, std::array{time});
  return sensor.reading()[0];
}

// Looks at 1 kHz, samples at 10 Hz: the reading is the last multiple of 0.1 s.
TEST(SensorChannel, SamplesAtItsRate) {
  SensorChannel sensor({.rate = 10}, 1);
  for (int i = 0; i < 5000; ++i) {
    EXPECT_NEAR(reading_at(sensor, i * 1e-3), std::floor(i / 100.0) * 0.1, 1e-12) << i;
    EXPECT_NEAR(sensor.age(), i % 100 * 1e-3, 1e-12);
  }
}

// Samples arrive 0.25 s later. Until then the reading is the first sample.
TEST(SensorChannel, DeliversAfterItsDelay) {
  SensorChannel sensor({.rate = 10, .delay = 0.25}, 1);
  for (int i = 0; i < 5000; ++i) {
    const double expected = std::max(0.0, std::floor((i - 250) / 100.0) * 0.1);
    EXPECT_NEAR(reading_at(sensor, i * 1e-3), expected, 1e-12) << i;
  }
}

// Looks less often than its rate: each look is a sample. Looks that drift late keep the raster of the rate.
TEST(SensorChannel, TakesOneSampleFromALateLook) {
  SensorChannel slow({.rate = 10, .delay = 0.25}, 1);
  EXPECT_EQ(reading_at(slow, 0), 0);
  EXPECT_EQ(reading_at(slow, 0.7), 0);
  EXPECT_EQ(reading_at(slow, 1.4), 0.7);
  SensorChannel raster({.rate = 10}, 1);
  EXPECT_EQ(reading_at(raster, 0.09), 0.09);  // the first sample is due at 0
  EXPECT_EQ(reading_at(raster, 0.11), 0.11);
  EXPECT_EQ(reading_at(raster, 0.19), 0.11);
  EXPECT_EQ(reading_at(raster, 0.2), 0.2);
}

// Late looks crowd samples together: none is overwritten before it is read.
TEST(SensorChannel, HoldsAllSamplesUnderWay) {
  SensorChannel sensor({.rate = 10, .delay = 0.2}, 1);
  std::vector<double> seen;
  for (int n = 0; n < 100; ++n) {
    for (const double part : {n % 2 == 0 ? 0.099 : 0.0001, 0.0995}) {
      const double reading = reading_at(sensor, 0.1 * n + part);
      if (seen.empty() || reading != seen.back()) seen.push_back(reading);
    }
  }
  for (std::size_t n = 0; n < 97; ++n) EXPECT_NEAR(seen[n], 0.1 * n + (n % 2 == 0 ? 0.099 : 0.0001), 1e-9);
}

// Three samples under way, and a late look takes a fourth before it reads those that have arrived.
TEST(SensorChannel, LateLookLosesNoSampleUnderWay) {
  SensorChannel sensor({.rate = 10, .delay = 0.2}, 1);
  for (const double time : {0.099, 0.1001, 0.2}) EXPECT_EQ(reading_at(sensor, time), 0.099);
  EXPECT_EQ(reading_at(sensor, 0.305), 0.1001);
}

// Mean = bias and standard deviation = noise, uncorrelated; tolerance: 4.5 standard deviations of the estimates.
TEST(SensorChannel, NoiseAndBiasHaveTheirStatistics) {
  constexpr int kCount = 100'000;
  const double noise = 0.02, bias = 0.5;
  SensorChannel sensor({.rate = 1, .noise = {noise, 0, noise}, .bias = {bias, 1, -bias}, .seed = 11}, 3);
  double sum = 0, squares = 0, product = 0;
  for (int i = 0; i < kCount; ++i) {
    sensor.look(i, std::array{2.0, 2.0, 2.0});
    const double first = sensor.reading()[0] - 2 - bias, third = sensor.reading()[2] - 2 + bias;
    EXPECT_EQ(sensor.reading()[1], 3);
    sum += first;
    squares += first * first;
    product += first * third;
  }
  EXPECT_NEAR(sum / kCount, 0, 4.5 * noise / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, noise * noise, 4.5 * std::sqrt(2.0 / kCount) * noise * noise);
  EXPECT_NEAR(product / kCount, 0, 4.5 * noise * noise / std::sqrt(kCount));
}

// Lost samples: a fraction p, and runs of n of them with the probability p^n (1 - p). The mean age in samples of a
// reading is p/(1 - p).
TEST(SensorChannel, DropoutHoldsTheLastReading) {
  constexpr int kCount = 100'000;
  const double p = 0.3;
  SensorChannel sensor({.rate = 1, .dropout = p}, 1);
  double age = 0;
  for (int i = 0; i < kCount; ++i) {
    const double reading = reading_at(sensor, i);
    EXPECT_EQ(reading, i - sensor.age());
    age += sensor.age();
  }
  // The variance of the age is p/(1 - p)^2; neighbours correlate with p, which widens the mean's by (1 + p)/(1 - p).
  const double deviation = std::sqrt(p / ((1 - p) * (1 - p)) * (1 + p) / (1 - p) / kCount);
  EXPECT_NEAR(age / kCount, p / (1 - p), 4.5 * deviation);
  SensorChannel dead({.rate = 1, .dropout = 1}, 1);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(reading_at(dead, i), 0);
}

// The noise of a sample does not depend on which others were lost.
TEST(SensorChannel, DropoutsDoNotChangeTheNoise) {
  SensorChannel whole({.rate = 1, .noise = {1}}, 1), holed({.rate = 1, .dropout = 0.5, .noise = {1}}, 1);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = reading_at(whole, i), y = reading_at(holed, i);
    if (holed.age() == 0) {
      EXPECT_EQ(x, y);
      ++equal;
    }
  }
  EXPECT_GT(equal, 400);
}

TEST(SensorChannel, RefusesWrongSettings) {
  const auto refused = [](const SensorSettings& settings) {
    EXPECT_THROW(SensorChannel(settings, 2), std::invalid_argument);
  };
  refused({.rate = 0});
  refused({.rate = std::nan("")});
  refused({.delay = -1});
  refused({.delay = std::nan("")});
  refused({.dropout = 1.5});
  refused({.noise = {1}});
  refused({.noise = {1, -1}});
  refused({.bias = {std::nan(""), 0}});
}

}  // namespace
}  // namespace netpocket
