#include "engine/systems/thrown_net/net_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <utility>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// Eight strips of rows, as equal as can be. The place counts rows within a strip, then columns.
KnotPart part_of_square(int row, int column, int rows) {
  constexpr int kParts = 8;
  const int tall = rows % kParts, least = rows / kParts;  // the first strips have one row more than the others
  const int of_tall = tall * (least + 1);
  const int part = row < of_tall ? row / (least + 1) : tall + (row - of_tall) / std::max(least, 1);
  const int within = row < of_tall ? row % (least + 1) : (row - of_tall) % std::max(least, 1);
  return {part, within * rows + column};
}

NetPattern square(double side, int cells) {
  NetPattern net;
  const auto knot = [cells](int row, int column) { return row * (cells + 1) + column; };
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      net.knots.emplace_back(side * (static_cast<double>(column) / cells - 0.5),
                             side * (static_cast<double>(row) / cells - 0.5));
      net.parts.push_back(part_of_square(row, column, cells + 1));
    }
  }
  for (int line = 0; line <= cells; ++line) {
    std::vector<std::int32_t> row, column;
    for (int i = 0; i <= cells; ++i) {
      row.push_back(knot(line, i));
      column.push_back(knot(i, line));
    }
    const bool is_side = line == 0 || line == cells;
    net.cords.push_back({row, side, 1, is_side, fmt::format("row {}", line + 1)});
    net.cords.push_back({column, side, 1, is_side, fmt::format("column {}", line + 1)});
  }
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const std::int32_t a = knot(row, column), c = knot(row + 1, column + 1);
      net.triangles.push_back({a, knot(row, column + 1), c});
      net.triangles.push_back({a, c, knot(row + 1, column)});
    }
  }
  for (int i = 0; i < cells; ++i) net.perimeter.push_back(knot(0, i));
  for (int i = 0; i < cells; ++i) net.perimeter.push_back(knot(i, cells));
  for (int i = cells; i > 0; --i) net.perimeter.push_back(knot(cells, i));
  for (int i = cells; i > 0; --i) net.perimeter.push_back(knot(i, 0));
  net.corners = {knot(0, 0), knot(0, cells), knot(cells, cells), knot(cells, 0)};
  if (cells % 2 == 0) net.middle = knot(cells / 2, cells / 2);
  net.area = side * side;
  return net;
}

// Knots at mesh (q + r/2, r sqrt(3)/2) for integers with |q|, |r|, |q + r| <= cells. Along a cord q, r or q + r is
// constant.
class Hexagon {
 public:
  Hexagon(double side, int cells) : side_(side), cells_(cells), half_height_(0.5 * std::sqrt(3.0)) {}

  NetPattern build() {
    const double mesh = side_ / cells_;
    for (int r = -cells_; r <= cells_; ++r) {
      for (int q = -cells_; q <= cells_; ++q) {
        if (!is_knot(q, r)) continue;
        index_[{q, r}] = static_cast<std::int32_t>(net_.knots.size());
        net_.knots.emplace_back(mesh * (q + 0.5 * r), mesh * half_height_ * r);
      }
    }
    for (int line = -cells_; line <= cells_; ++line) {
      add_cord("row", line, [line](int i) { return std::pair(i, line); });
      add_cord("rising", line, [line](int i) { return std::pair(line, i); });
      add_cord("falling", line, [line](int i) { return std::pair(line - i, i); });
    }
    add_triangles();
    add_perimeter();
    net_.middle = index_.at({0, 0});
    net_.area = 3 * half_height_ * side_ * side_;
    return std::move(net_);
  }

 private:
  bool is_knot(int q, int r) const {
    return std::abs(q) <= cells_ && std::abs(r) <= cells_ && std::abs(q + r) <= cells_;
  }

  template <typename Place>
  void add_cord(const char* name, int line, const Place& place) {
    std::vector<std::int32_t> knots;
    for (int i = -cells_; i <= cells_; ++i) {
      if (const auto [q, r] = place(i); is_knot(q, r)) knots.push_back(index_.at({q, r}));
    }
    const double length = side_ * static_cast<double>(knots.size() - 1) / cells_;
    net_.cords.push_back(
        {std::move(knots), length, 1, std::abs(line) == cells_, fmt::format("{} {}", name, line + cells_ + 1)});
  }

  void add_triangles() {
    const auto add = [this](std::array<std::pair<int, int>, 3> corners) {
      std::array<std::int32_t, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        if (!is_knot(corners[i].first, corners[i].second)) return;
        triangle[i] = index_.at(corners[i]);
      }
      net_.triangles.push_back(triangle);
    };
    for (const auto& [place, knot] : index_) {
      const auto [q, r] = place;
      add({{{q, r}, {q + 1, r}, {q, r + 1}}});
      add({{{q, r}, {q + 1, r - 1}, {q + 1, r}}});
    }
  }

  void add_perimeter() {
    // Corners, and the way along the side from each to the next.
    const std::pair<int, int> steps[] = {{-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}, {0, 1}};
    int q = cells_, r = 0;
    for (const auto& [dq, dr] : steps) {
      net_.corners.push_back(index_.at({q, r}));
      for (int i = 0; i < cells_; ++i, q += dq, r += dr) net_.perimeter.push_back(index_.at({q, r}));
    }
  }

  double side_;
  int cells_;
  double half_height_;  // of a triangle of side 1
  NetPattern net_;
  std::map<std::pair<int, int>, std::int32_t> index_;
};

NetPattern radial(double spoke, int rings, int spokes) {
  NetPattern net;
  const double angle = 2 * std::numbers::pi / spokes;
  const auto knot = [spokes](int ring, int of) { return ring == 0 ? 0 : 1 + (ring - 1) * spokes + of % spokes; };
  net.knots.emplace_back(0, 0);
  for (int ring = 1; ring <= rings; ++ring) {
    const double radius = spoke * ring / rings;
    for (int i = 0; i < spokes; ++i) net.knots.emplace_back(radius * cosine(i * angle), radius * sine(i * angle));
  }
  const double mesh = spoke / rings;
  for (int i = 0; i < spokes; ++i) {
    std::vector<std::int32_t> knots;
    for (int ring = 0; ring <= rings; ++ring) knots.push_back(knot(ring, i));
    net.cords.push_back({std::move(knots), spoke, 1, false, fmt::format("spoke {}", i + 1)});
  }
  for (int ring = 1; ring <= rings; ++ring) {
    const double length = 2 * spoke * ring / rings * sine(0.5 * angle);
    const int divisions = std::max(1, static_cast<int>(std::lround(length / mesh)));
    for (int i = 0; i < spokes; ++i) {
      net.cords.push_back({{knot(ring, i), knot(ring, i + 1)},
                           length,
                           divisions,
                           ring == rings,
                           fmt::format("ring {} part {}", ring, i + 1)});
      const std::int32_t a = knot(ring - 1, i), b = knot(ring, i), c = knot(ring, i + 1), d = knot(ring - 1, i + 1);
      net.triangles.push_back({a, b, c});
      if (ring > 1) net.triangles.push_back({a, c, d});
    }
  }
  for (int i = 0; i < spokes; ++i) net.perimeter.push_back(knot(rings, i));
  net.corners = net.perimeter;
  net.middle = 0;
  net.area = 0.5 * spokes * spoke * spoke * sine(angle);
  return net;
}

}  // namespace

NetPattern net_pattern(NetShape shape, double size, int cells, int spokes) {
  switch (shape) {
    case NetShape::hexagonal:
      return Hexagon(size, cells).build();
    case NetShape::radial:
      return radial(size, cells, spokes);
    case NetShape::square:
      break;
  }
  return square(size, cells);
}

}  // namespace netpocket
