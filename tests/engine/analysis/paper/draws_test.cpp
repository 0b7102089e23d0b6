#include "engine/analysis/paper/draws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace netpocket {
namespace {

TEST(Draws, MeanOfLogsHasStudentsInterval) {
  // Logs 0, 1, 2: mean 1, standard error 1/sqrt(3), t = 4.302653 with two degrees of freedom.
  const FactorInterval mean = geometric_mean({1, std::exp(1), std::exp(2)});
  EXPECT_NEAR(std::log(mean.middle), 1, 1e-12);
  EXPECT_NEAR(std::log(mean.low), 1 - 4.302653 / std::sqrt(3), 1e-6);
  EXPECT_NEAR(std::log(mean.high), 1 + 4.302653 / std::sqrt(3), 1e-6);
}

TEST(Draws, RatioHasWelchsInterval) {
  // Logs 0, 1, 2 and 5, 5.5, 6: difference 4.5, variance of it (1 + 1/4)/3, degrees of freedom
  // (5/12)^2 / ((1/3)^2/2 + (1/12)^2/2) = 2.941176, for which t at 97.5 % is 3.219 (R: qt(0.975, 2.941176)).
  const FactorInterval ratio =
      ratio_of_means({1, std::exp(1), std::exp(2)}, {std::exp(5), std::exp(5.5), std::exp(6)}, 0.95);
  EXPECT_NEAR(std::log(ratio.middle), 4.5, 1e-12);
  const double t = (std::log(ratio.high) - 4.5) / std::sqrt(5.0 / 12);
  EXPECT_NEAR(std::log(ratio.high) - 4.5, 4.5 - std::log(ratio.low), 1e-12);
  EXPECT_GT(t, 3.182446) << "that of three degrees";
  EXPECT_LT(t, 4.302653) << "that of two degrees";
  EXPECT_NEAR(t, 3.22, 0.01);
}

// Of two equal quantities the verdict yes or no, which claims a difference, comes in less than 5 % of the trials.
TEST(Draws, ErrAsRarelyAsTheySay) {
  std::mt19937_64 random(7);
  const auto draw = [&] {
    std::lognormal_distribution<double> force(5, 0.3);
    std::vector<double> values(16);
    for (double& v : values) v = force(random);
    return values;
  };
  int wrong = 0;
  constexpr int kTrials = 2000;
  for (int i = 0; i < kTrials; ++i) {
    const OrderOfDraws order = order_of_draws({{5, draw()}, {7.5, draw()}, {10, draw()}}, "N");
    wrong += order.verdict != Verdict::undecided ? 1 : 0;
  }
  EXPECT_LT(wrong, 0.05 * kTrials);
  EXPECT_GT(wrong, 0) << "intervals that never err are too wide";
}

TEST(Draws, OrderNeedsAllPairs) {
  const std::vector<double> low = {90, 100, 110, 105}, middle = {190, 200, 210, 205}, high = {390, 400, 410, 405};
  EXPECT_EQ(order_of_draws({{5, high}, {7.5, middle}, {10, low}}, "N").verdict, Verdict::yes);
  EXPECT_EQ(order_of_draws({{5, high}, {7.5, low}, {10, middle}}, "N").verdict, Verdict::no);
  EXPECT_EQ(order_of_draws({{5, high}, {7.5, low}, {10, {89, 101, 111, 104}}}, "N").verdict, Verdict::undecided);
  EXPECT_EQ(order_of_draws({{5, high}, {7.5, middle}, {10, {100}}}, "N").verdict, Verdict::undecided);
  EXPECT_EQ(order_of_draws({{5, high}, {10, {0, 100}}}, "N").verdict, Verdict::undecided);
  const std::string text = order_of_draws({{5, high}, {10, low}}, "N").text;
  EXPECT_NE(text.find("5 s: 401 N ["), std::string::npos) << text;
  EXPECT_NE(text.find("4 draws from 390 to 410"), std::string::npos) << text;
  EXPECT_NE(text.find("ratios 5 s / 10 s 3.97 ["), std::string::npos) << text;
}

}  // namespace
}  // namespace netpocket
