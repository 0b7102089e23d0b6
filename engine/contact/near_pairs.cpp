#include "engine/contact/near_pairs.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Number of elements, entries or pairs that a thread takes at once.
constexpr int kRange = 1024;

// Sorts pairs of indices below `count`: by a counting sort on the first index, then each short run by the second.
std::vector<std::pair<int, int>> sorted(const std::vector<std::pair<int, int>>& pairs, std::size_t count,
                                        const DividedLoop& loop) {
  std::vector<std::size_t> end(count + 1, 0);  // end[i + 1]: end of the pairs whose first index is i
  for (const auto& [first, second] : pairs) ++end[static_cast<std::size_t>(first) + 1];
  for (std::size_t i = 0; i < count; ++i) end[i + 1] += end[i];
  std::vector<std::size_t> next(end.begin(), end.end() - 1);
  std::vector<std::pair<int, int>> result(pairs.size());
  for (const auto& pair : pairs) result[next[static_cast<std::size_t>(pair.first)]++] = pair;
  const auto at = [&](std::size_t place) { return result.begin() + static_cast<std::ptrdiff_t>(place); };
  loop(static_cast<int>(count), kRange, [&](int first, int last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      std::sort(at(end[i]), at(end[i + 1]));
    }
  });
  return result;
}

// Finds the pairs of boxes within `margin` of each other along every axis. A grid in y and z divides space into columns
// along x. A box is entered in every column that it reaches into. In each column a sweep along x (Cohen, Lin, Manocha &
// Ponamgi 1995, doi:10.1145/199404.199437) finds the pairs. A pair that meets in several columns is reported only by
// the one that contains the lower corner of the boxes' common part.
class NearPairs {
 public:
  NearPairs(std::span<const AlignedBox3d> boxes, double margin, const DividedLoop& loop)
      : boxes_(boxes), margin_(margin) {
    Vector3d sizes = Vector3d::Zero(), largest = sizes;
    for (const AlignedBox3d& box : boxes) {
      all_.extend(box);
      sizes += box.sizes();
      largest = largest.cwiseMax(box.sizes());
    }
    if (boxes.empty()) return;
    const double mean = sizes.mean() / static_cast<double>(boxes.size());
    // The column size fits most boxes. The other terms bound the number of columns for a few long boxes, as in a
    // diverging state.
    cell_ = std::max({kSizesOfAColumn * mean + margin, std::max(largest.y(), largest.z()) / kMostColumnsOfABox,
                      std::max(all_.sizes().y(), all_.sizes().z()) / kMostColumns});
    layers_ = cell(all_.max().z() + margin, 2) + 1;
    entries_ = found_in_ranges<Entry>(loop, static_cast<int>(boxes.size()), kRange,
                                      [&](int first, int last, std::vector<Entry>& entries) {
                                        for (int i = first; i < last; ++i) add(i, entries);
                                      });
    sort_entries(loop);
    pairs_ =
        found_in_ranges<Pair>(loop, static_cast<int>(entries_.size()), kRange,
                              [&](int first, int last, std::vector<Pair>& found) { find_pairs(first, last, found); });
  }

  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }

 private:
  using Pair = std::pair<int, int>;
  // Column size over the mean size of boxes: few boxes are in two columns, and few tests find no pair.
  static constexpr double kSizesOfAColumn = 3.5;
  static constexpr double kMostColumns = 1e6, kMostColumnsOfABox = 16;  // along an axis
  static constexpr double kLeastSize = std::numeric_limits<double>::min();
  static constexpr int kBitsAlong = 24;  // bits of a place for x; the others hold the column
  // Place of the lower end of a box: the column, then the position along x, as one integer that is quick to sort.
  struct Entry {
    std::uint64_t place;
    int index;
  };

  const AlignedBox3d& box(int index) const { return boxes_[static_cast<std::size_t>(index)]; }
  std::uint64_t cell(double coordinate, int axis) const {
    return static_cast<std::uint64_t>((coordinate - all_.min()[axis]) / cell_);
  }
  std::uint64_t column(double y, double z) const { return cell(y, 1) * layers_ + cell(z, 2); }
  std::uint64_t place(std::uint64_t column, double x) const {
    constexpr double kLast = (1 << kBitsAlong) - 1;
    const double along = (x - all_.min().x()) / std::max(all_.sizes().x(), kLeastSize);
    return column << kBitsAlong | static_cast<std::uint64_t>(kLast * std::clamp(along, 0.0, 1.0));
  }

  void add(int index, std::vector<Entry>& entries) const {
    const Vector3d low = box(index).min(), high = box(index).max().array() + margin_;
    for (std::uint64_t y = cell(low.y(), 1); y <= cell(high.y(), 1); ++y) {
      for (std::uint64_t z = cell(low.z(), 2); z <= cell(high.z(), 2); ++z) {
        entries.push_back({place(y * layers_ + z, low.x()), index});
      }
    }
  }

  // Merge sort: sorts eight parts of the entries, then merges neighbouring parts.
  void sort_entries(const DividedLoop& loop) {
    constexpr int kParts = 8;
    const auto begin_of = [&](int part) {
      return entries_.begin() + static_cast<std::ptrdiff_t>(entries_.size()) * part / kParts;
    };
    loop(kParts, 1, [&](int first, int last) {
      for (int i = first; i < last; ++i) std::ranges::sort(begin_of(i), begin_of(i + 1), {}, &Entry::place);
    });
    for (int width = 1; width < kParts; width *= 2) {
      loop(kParts / (2 * width), 1, [&](int first, int last) {
        for (int i = 2 * width * first; i < 2 * width * last; i += 2 * width) {
          std::ranges::inplace_merge(begin_of(i), begin_of(i + width), begin_of(i + 2 * width), {}, &Entry::place);
        }
      });
    }
  }

  // Finds the pairs whose first box is among the entries [first, last).
  void find_pairs(int first, int last, std::vector<Pair>& found) const {
    for (auto a = entries_.begin() + first; a != entries_.begin() + last; ++a) {
      const AlignedBox3d& one = box(a->index);
      const Vector3d high = one.max().array() + margin_;
      const std::uint64_t column = a->place >> kBitsAlong, end = place(column, high.x());
      for (auto b = a + 1; b != entries_.end() && b->place <= end; ++b) {
        const AlignedBox3d& other = box(b->index);
        if (are_near(one.min(), high, other) && column == meeting_column(one, other)) {
          found.emplace_back(std::minmax(a->index, b->index));
        }
      }
    }
  }

  // Whether a box from `low` to `high`, where `high` includes the margin, is near another. It evaluates all comparisons
  // without branches, because the processor cannot predict them.
  bool are_near(const Vector3d& low, const Vector3d& high, const AlignedBox3d& other) const {
    const auto bit = [](bool value) { return static_cast<unsigned>(value); };
    const Vector3d &from = other.min(), &to = other.max();
    const unsigned begins_before = bit(from.x() <= high.x()) & bit(from.y() <= high.y()) & bit(from.z() <= high.z());
    const unsigned ends_after =
        bit(low.x() <= to.x() + margin_) & bit(low.y() <= to.y() + margin_) & bit(low.z() <= to.z() + margin_);
    return (begins_before & ends_after) != 0;
  }
  std::uint64_t meeting_column(const AlignedBox3d& a, const AlignedBox3d& b) const {
    return column(std::max(a.min().y(), b.min().y()), std::max(a.min().z(), b.min().z()));
  }

  std::span<const AlignedBox3d> boxes_;
  double margin_;
  AlignedBox3d all_;
  double cell_ = 1;
  std::uint64_t layers_ = 1;
  std::vector<Entry> entries_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace

std::vector<std::pair<int, int>> near_pairs(std::span<const AlignedBox3d> boxes, double margin,
                                            const DividedLoop& loop) {
  return sorted(NearPairs(boxes, margin, loop).pairs(), boxes.size(), loop);
}

}  // namespace netpocket
