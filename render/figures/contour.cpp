#include "render/figures/contour.h"

#include <array>

namespace netpocket {
namespace {

struct Corner {
  Eigen::Vector2d place;
  double value;  // less the level
};

// Point of an edge at which the value is zero; the ends have different signs.
Eigen::Vector2d crossing(const Corner& a, const Corner& b) {
  return a.place + (b.place - a.place) * (a.value / (a.value - b.value));
}

void add_cell(const std::array<Corner, 4>& corners, std::vector<ContourSegment>& segments) {
  std::vector<Eigen::Vector2d> crossings;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &a = corners[i], &b = corners[(i + 1) % 4];
    if ((a.value < 0) != (b.value < 0)) crossings.push_back(crossing(a, b));
  }
  if (crossings.size() == 2) segments.push_back({crossings[0], crossings[1]});
  if (crossings.size() < 4) return;
  // A saddle: the edges are crossed in the order of the corners. Corners of the sign of the middle are joined.
  double middle = 0;
  for (const Corner& corner : corners) middle += corner.value / 4;
  const std::size_t first = (corners[0].value < 0) == (middle < 0) ? 0 : 1;
  segments.push_back({crossings[first], crossings[first + 1]});
  segments.push_back({crossings[(first + 2) % 4], crossings[(first + 3) % 4]});
}

}  // namespace

std::vector<ContourSegment> contour(const std::vector<double>& x, const std::vector<double>& y,
                                    const Eigen::MatrixXd& values, double level) {
  std::vector<ContourSegment> segments;
  const auto corner = [&](std::size_t i, std::size_t j) {
    return Corner{{x[i], y[j]}, values(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) - level};
  };
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      add_cell({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, segments);
    }
  }
  return segments;
}

}  // namespace netpocket
