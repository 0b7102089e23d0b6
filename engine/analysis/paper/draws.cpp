#include "engine/analysis/paper/draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace netpocket {
namespace {

constexpr double kConfidence = 0.95;

struct LogMoments {
  double mean = 0;
  double variance_of_mean = 0;
  double freedom = 0;
};

LogMoments log_moments(const std::vector<double>& values) {
  LogMoments m;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) m.mean += std::log(v) / n;
  double squares = 0;
  for (const double v : values) squares += std::pow(std::log(v) - m.mean, 2);
  m.freedom = n - 1;
  m.variance_of_mean = squares / m.freedom / n;
  return m;
}

FactorInterval interval(double middle, double variance, double freedom, double confidence) {
  double half = 0;
  if (variance > 0) {
    const boost::math::students_t_distribution<double> t(freedom);
    half = boost::math::quantile(t, (1 + confidence) / 2) * std::sqrt(variance);
  }
  return {std::exp(middle), std::exp(middle - half), std::exp(middle + half)};
}

std::string draws_text(const Draws& draws, const std::string& unit) {
  const FactorInterval mean = geometric_mean(draws.values);
  const auto [least, most] = std::ranges::minmax_element(draws.values);
  return fmt::format("{:.4g} s: {:.3g} {} [{:.3g}, {:.3g}], {} draws from {:.3g} to {:.3g}", draws.closing_end,
                     mean.middle, unit, mean.low, mean.high, draws.values.size(), *least, *most);
}

}  // namespace

FactorInterval geometric_mean(const std::vector<double>& values) {
  const LogMoments m = log_moments(values);
  return interval(m.mean, m.variance_of_mean, m.freedom, kConfidence);
}

FactorInterval ratio_of_means(const std::vector<double>& a, const std::vector<double>& b, double confidence) {
  const LogMoments first = log_moments(a), second = log_moments(b);
  const double variance = first.variance_of_mean + second.variance_of_mean;
  const double freedom = std::pow(variance, 2) / (std::pow(first.variance_of_mean, 2) / first.freedom +
                                                  std::pow(second.variance_of_mean, 2) / second.freedom);
  return interval(second.mean - first.mean, variance, freedom, confidence);
}

OrderOfDraws order_of_draws(const std::vector<Draws>& groups, const std::string& unit) {
  const auto is_single = [](const Draws& draws) { return draws.values.size() < 2; };
  if (std::ranges::any_of(groups, is_single)) return {Verdict::undecided, kOneDraw};
  const auto not_positive = [](const Draws& draws) {
    return std::ranges::any_of(draws.values, [](double v) { return !(v > 0); });
  };
  if (std::ranges::any_of(groups, not_positive)) return {Verdict::undecided, "a draw is zero"};

  std::vector<std::string> means, ratios;
  for (const Draws& draws : groups) means.push_back(draws_text(draws, unit));
  const auto pairs = static_cast<double>(groups.size() * (groups.size() - 1)) / 2;
  bool all_fall = true, one_rises = false;
  for (std::size_t slow = 1; slow < groups.size(); ++slow) {
    for (std::size_t fast = 0; fast < slow; ++fast) {
      const FactorInterval ratio =
          ratio_of_means(groups[slow].values, groups[fast].values, 1 - (1 - kConfidence) / pairs);
      all_fall = all_fall && ratio.low > 1;
      one_rises = one_rises || ratio.high < 1;
      ratios.push_back(fmt::format("{:.4g} s / {:.4g} s {:.3g} [{:.3g}, {:.3g}]", groups[fast].closing_end,
                                   groups[slow].closing_end, ratio.middle, ratio.low, ratio.high));
    }
  }
  const Verdict verdict = all_fall ? Verdict::yes : one_rises ? Verdict::no : Verdict::undecided;
  return {verdict, fmt::format("geometric means by end of closing {}; ratios {}", fmt::join(means, ", "),
                               fmt::join(ratios, ", "))};
}

}  // namespace netpocket
