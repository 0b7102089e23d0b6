#include "engine/contact/near_pairs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>

#include "engine/contact/sweep_kernel.h"

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

// A box in a column. `place` is the column, then the position of the box's lower end along x, as one integer.
struct Entry {
  std::uint64_t place;
  std::int32_t index, y, z;  // the box, and the cells of its lower corner
};

// Sorts entries by their places, digit by digit from the lowest (radix sort).
void sort_by_place(std::vector<Entry>& entries) {
  constexpr int kDigitBits = 11;
  constexpr std::uint64_t kDigits = 1 << kDigitBits;
  std::uint64_t largest = 0;
  for (const Entry& entry : entries) largest = std::max(largest, entry.place);
  std::vector<Entry> other(entries.size());
  for (int shift = 0; shift < static_cast<int>(std::bit_width(largest)); shift += kDigitBits) {
    const auto digit = [&](const Entry& entry) { return entry.place >> shift & (kDigits - 1); };
    std::array<std::size_t, kDigits + 1> begin{};
    for (const Entry& entry : entries) ++begin[digit(entry) + 1];
    for (std::size_t i = 0; i < kDigits; ++i) begin[i + 1] += begin[i];
    for (const Entry& entry : entries) other[begin[digit(entry)]++] = entry;
    entries.swap(other);
  }
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
    sort_by_place(entries_);
    fill_rows();
    pairs_ =
        found_in_ranges<Pair>(loop, static_cast<int>(entries_.size()), kRange,
                              [&](int first, int last, std::vector<Pair>& found) { find_pairs(first, last, found); });
  }

  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }

 private:
  using Pair = std::pair<int, int>;
  // Column size over the mean size of boxes: few boxes are in two columns, and few tests find no pair.
  static constexpr double kSizesOfAColumn = 3.5;
  static constexpr double kMostColumns = 1 << 14, kMostColumnsOfABox = 16;  // along an axis
  static constexpr double kLeastSize = std::numeric_limits<double>::min();
  // Bits of a place for x; the others hold the column. All together are exact as a double.
  static constexpr int kBitsAlong = 20;

  const AlignedBox3d& box(int index) const { return boxes_[static_cast<std::size_t>(index)]; }
  std::int32_t cell(double coordinate, int axis) const {
    return static_cast<std::int32_t>((coordinate - all_.min()[axis]) / cell_);
  }
  std::uint64_t column(std::int32_t y, std::int32_t z) const {
    return static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(layers_) + static_cast<std::uint64_t>(z);
  }
  std::uint64_t along(double x) const {
    constexpr double kLast = (1 << kBitsAlong) - 1;
    const double part = (x - all_.min().x()) / std::max(all_.sizes().x(), kLeastSize);
    return static_cast<std::uint64_t>(kLast * std::clamp(part, 0.0, 1.0));
  }

  void add(int index, std::vector<Entry>& entries) const {
    const Vector3d low = box(index).min(), high = box(index).max().array() + margin_;
    const std::uint64_t position = along(low.x());
    const std::int32_t low_y = cell(low.y(), 1), low_z = cell(low.z(), 2);
    const std::int32_t high_y = cell(high.y(), 1), high_z = cell(high.z(), 2);
    for (std::int32_t y = low_y; y <= high_y; ++y) {
      for (std::int32_t z = low_z; z <= high_z; ++z) {
        entries.push_back({column(y, z) << kBitsAlong | position, index, low_y, low_z});
      }
    }
  }

  // The kernel reads what it compares in the order of the entries.
  void fill_rows() {
    const std::size_t size = entries_.size() + sweep_kernel::kPadding;
    for (std::vector<double>& row : rows_) row.assign(size, 0.0);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const AlignedBox3d& one = box(entries_[i].index);
      rows_[0][i] = static_cast<double>(entries_[i].place);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        rows_[1 + axis][i] = one.min()[static_cast<Eigen::Index>(axis)];
        rows_[4 + axis][i] = one.max()[static_cast<Eigen::Index>(axis)] + margin_;
      }
    }
  }

  // Finds the pairs whose first box is among the entries [first, last).
  void find_pairs(int first, int last, std::vector<Pair>& found) const {
    static const auto meeting = NETPOCKET_VARIANT_OF(sweep_kernel, meeting);
    const auto row = [&](std::size_t i) { return rows_[i].data(); };
    const sweep_kernel::Rows rows = {row(0), {row(1), row(2), row(3)}, {row(4), row(5), row(6)}};
    const auto end = static_cast<std::int32_t>(entries_.size());
    const auto others = std::make_unique_for_overwrite<std::int32_t[]>(entries_.size());
    for (std::int32_t i = first; i < last; ++i) {
      const Entry& a = entries_[static_cast<std::size_t>(i)];
      const std::uint64_t its_column = a.place >> kBitsAlong;
      const std::uint64_t last_place = its_column << kBitsAlong | along(rows.high[0][i]);
      const std::int32_t count = meeting(rows, i, end, static_cast<double>(last_place), others.get());
      for (std::int32_t k = 0; k < count; ++k) {
        const Entry& b = entries_[static_cast<std::size_t>(others[static_cast<std::size_t>(k)])];
        if (its_column != column(std::max(a.y, b.y), std::max(a.z, b.z))) continue;
        found.emplace_back(std::minmax(a.index, b.index));
      }
    }
  }

  std::span<const AlignedBox3d> boxes_;
  double margin_;
  AlignedBox3d all_;
  double cell_ = 1;          // m
  std::int32_t layers_ = 1;  // columns along z
  std::vector<Entry> entries_;
  std::array<std::vector<double>, 7> rows_;  // of sweep_kernel::Rows
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace

std::vector<std::pair<int, int>> near_pairs(std::span<const AlignedBox3d> boxes, double margin,
                                            const DividedLoop& loop) {
  return sorted(NearPairs(boxes, margin, loop).pairs(), boxes.size(), loop);
}

}  // namespace netpocket
