#include "render/figures/capture_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/statistics/kriging.h"
#include "render/figures/contour.h"
#include "render/figures/drawn_captures.h"

namespace netpocket {
namespace {

// In column i, row j at x[i], y[j].
struct ProbabilityMap {
  std::vector<double> x, y;
  Eigen::MatrixXd values;
  std::string quality;
};

// Empty with too few captures or only one outcome.
ProbabilityMap probability_map(const StudyResults& results, const ResultColumn& x, const ResultColumn& y) {
  constexpr std::size_t kMostPoints = 300;  // the time grows with their cube
  constexpr std::size_t kSteps = 41;
  const ColumnRange across = range_of(x), along = range_of(y);
  std::vector<Eigen::Vector2d> points;
  std::vector<double> values;
  for (std::size_t i = 0; i < results.size() && points.size() < kMostPoints; ++i) {
    if (std::isnan(results.captured[i]) || !std::isfinite(x.values[i] + y.values[i])) continue;
    points.emplace_back(across.fraction(x.values[i]), along.fraction(y.values[i]));
    values.push_back(results.captured[i]);
  }
  ProbabilityMap map;
  const bool varies = std::ranges::count(values, 0) > 0 && std::ranges::count(values, 1) > 0;
  if (points.size() < 20 || !varies) return map;
  Eigen::MatrixXd design(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) design.col(static_cast<Eigen::Index>(i)) = points[i];
  const Kriging kriging(design, Eigen::Map<const Eigen::VectorXd>(values.data(), design.cols()));
  map.quality = fmt::format("Contours: Kriging of {} captures, leave-one-out R² {:.2f}", points.size(),
                            kriging.leave_one_out_quality());
  map.values.resize(kSteps, kSteps);
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double fraction = static_cast<double>(i) / (kSteps - 1);
    map.x.push_back(across.at(fraction));
    map.y.push_back(along.at(fraction));
    for (std::size_t j = 0; j < kSteps; ++j) {
      const Eigen::Vector2d place(fraction, static_cast<double>(j) / (kSteps - 1));
      map.values(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = kriging.predict(place).value;
    }
  }
  return map;
}

Curve contour_curve(const ProbabilityMap& map, double level, double width) {
  Curve curve = plain_line(kBlack, width, fmt::format("{:g} %", 100 * level));
  for (const ContourSegment& segment : contour(map.x, map.y, map.values, level)) {
    curve.x.insert(curve.x.end(), {segment.from.x(), segment.to.x(), kGapInCurve});
    curve.y.insert(curve.y.end(), {segment.from.y(), segment.to.y(), kGapInCurve});
  }
  return curve;
}

}  // namespace

std::vector<Curve> captures_over(const StudyResults& results, const ResultColumn& x, const ResultColumn& y,
                                 bool has_labels) {
  Curve captured = scatter(kSkyBlue, has_labels ? "captured" : ""),
        missed = scatter(kVermillion, has_labels ? "missed" : "");
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (std::isnan(results.captured[i]) || !is_drawn(i, results.size())) continue;
    add_point(results.captured[i] == 1 ? captured : missed, x.values[i], y.values[i]);
  }
  return {captured, missed};
}

Figure make_capture_map(const StudyResults& results, const ResultColumn& x, const ResultColumn& y) {
  Figure figure{.title = title_with_drawn("Captures and probability of capture", results.size()),
                .panels = {},
                .width_mm = 140,
                .height_mm = 120};
  figure.panels.push_back(panel_of(axis_title(x), axis_title(y), captures_over(results, x, y, true)));
  return figure;
}

ProbabilityContours probability_contours(const StudyResults& results, const ResultColumn& x, const ResultColumn& y) {
  const ProbabilityMap map = probability_map(results, x, y);
  if (map.x.empty()) return {};
  return {{contour_curve(map, 0.1, 0.6), contour_curve(map, 0.5, 1.2), contour_curve(map, 0.9, 2.0)}, map.quality};
}

}  // namespace netpocket
