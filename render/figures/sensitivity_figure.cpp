#include "render/figures/sensitivity_figure.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "render/figures/rich_text.h"
#include "render/figures/study_curves.h"

namespace netpocket {
namespace {

// The columns of a bar; `lower` and `upper` are empty where there is no interval.
struct BarColumns {
  const char *value, *lower, *upper, *label;
};

constexpr BarColumns kSobolBars[] = {{"total", "total_lower", "total_upper", "total index"},
                                     {"first", "first_lower", "first_upper", "first-order index"}};
constexpr BarColumns kMorrisBars[] = {{"mean_absolute", "", "", "mean size of the effects"},
                                      {"deviation", "", "", "their deviation"}};

const std::vector<double>* values_of(const StudyResults& results, const std::string& name) {
  const auto found = std::ranges::find(results.sensitivity, name, &ResultColumn::name);
  return found == results.sensitivity.end() ? nullptr : &found->values;
}

// A thick line for the value, a thin one for its interval.
void add_index_bar(Panel& panel, double height, double value, double lower, double upper, const Curve& look) {
  Curve bar = look, interval = plain_line(kBlack, 0.8);
  bar.x = {0, value};
  interval.x = {lower, upper};
  bar.y = interval.y = {height, height};
  panel.curves.push_back(std::move(bar));
  if (std::isfinite(lower) && std::isfinite(upper)) panel.curves.push_back(std::move(interval));
}

}  // namespace

Figure sensitivity_figure(const StudyResults& results) {
  Figure figure{.title = "What decides " + plain_text(results.sensitivity_of), .panels = {{}}, .width_mm = 160};
  const bool is_sobol = values_of(results, "total") != nullptr;
  const auto bars = is_sobol ? std::span(kSobolBars) : std::span(kMorrisBars);
  const std::vector<double>* main = values_of(results, bars.front().value);
  if (main == nullptr || results.sensitivity_inputs.empty()) return figure;
  const std::size_t count = std::min(results.sensitivity_inputs.size(), main->size());
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [main](std::size_t a, std::size_t b) { return (*main)[a] > (*main)[b]; });
  Panel& panel = figure.panels[0];
  panel.x.title = is_sobol ? "Sobol index, with 95 % intervals" : "Elementary effects over the range of the input";
  for (std::size_t place = 0; place < count; ++place) {
    const std::size_t input = order[place];
    for (std::size_t b = 0; b < bars.size(); ++b) {
      const auto number = [&](const char* name) {
        const std::vector<double>* values = values_of(results, name);
        return values != nullptr ? (*values)[input] : kGapInCurve;
      };
      const double height = -static_cast<double>(place + 1) + (b == 0 ? 0.15 : -0.15);
      add_index_bar(panel, height, number(bars[b].value), number(bars[b].lower), number(bars[b].upper),
                    plain_line(b == 0 ? kBlue : kOrange, 5, place == 0 ? bars[b].label : ""));
    }
    panel.y.names.push_back({-static_cast<double>(place + 1), plain_text(results.sensitivity_inputs[input])});
  }
  panel.y.limits = AxisLimits{-static_cast<double>(count) - 0.7, -0.3};
  figure.height_mm = 40 + 9 * static_cast<double>(count);
  return figure;
}

}  // namespace netpocket
