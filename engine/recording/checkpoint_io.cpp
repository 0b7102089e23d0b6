#include "engine/recording/checkpoint_io.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {

namespace {

constexpr hsize_t kValuesPerChunk = 8192;
constexpr hsize_t kTextBytesPerChunk = 4096;
constexpr hsize_t kRowsPerChunk = 64;

Hdf5Error damaged() { return Hdf5Error("its checkpoints are damaged"); }

std::vector<std::int64_t> read_ranges(const InputFile& file, const std::string& path, std::size_t count) {
  const InputTable table(file, path, H5T_INTEGER, {2});
  if (table.row_count() < count) throw damaged();
  auto ranges = table.read<std::int64_t>(0, count);
  if (std::ranges::any_of(ranges, [](std::int64_t n) { return n < 0; })) throw damaged();
  return ranges;
}

// Rows that a killed program announced but did not write have the time NaN.
std::vector<double> read_times(const InputFile& file) {
  auto times = InputTable(file, "/checkpoints/time", H5T_FLOAT).read_announced();
  times.erase(std::ranges::find_if_not(times, [](double t) { return std::isfinite(t); }), times.end());
  if (!std::ranges::is_sorted(times)) throw damaged();
  return times;
}

}  // namespace

CheckpointTables::CheckpointTables(hid_t file, ChunkCodec& codec)
    : group_(create_group(file, "/checkpoints")),
      values_(group_.get(), H5T_NATIVE_DOUBLE,
              {"values", "SI", "numbers of all states, one after the other", {}, kValuesPerChunk}, codec),
      value_range_(group_.get(), H5T_NATIVE_INT64,
                   {"value_range", "", "first row in values and number of rows", {2}, kRowsPerChunk}, codec),
      texts_(group_.get(), H5T_NATIVE_UINT8,
             {"strategies", "", "scenarios that took over, TOML, one after the other", {}, kTextBytesPerChunk}, codec),
      text_range_(group_.get(), H5T_NATIVE_INT64,
                  {"strategy_range", "", "first byte in strategies and number of bytes", {2}, kRowsPerChunk}, codec),
      time_(group_.get(), H5T_NATIVE_DOUBLE, {"time", "s", "simulated time", {}, kRowsPerChunk}, codec) {}

void CheckpointTables::append_range(OutputTable& ranges, const OutputTable& rows, std::size_t count) {
  const std::array<std::int64_t, 2> range = {static_cast<std::int64_t>(rows.row_count()),
                                             static_cast<std::int64_t>(count)};
  ranges.append(std::span<const std::int64_t>(range));
}

void CheckpointTables::append(const Checkpoint& checkpoint) {
  append_range(value_range_, values_, checkpoint.state.size());
  values_.append(std::span<const double>(checkpoint.state));
  append_range(text_range_, texts_, checkpoint.strategy.size());
  texts_.append(std::span<const char>(checkpoint.strategy));
  time_.append(std::span<const double>(&checkpoint.time, 1));
}

void CheckpointTables::store_states() {
  for (OutputTable* table : {&values_, &value_range_, &texts_, &text_range_}) table->store();
}

void CheckpointTables::store_times() { time_.store(); }

CheckpointReader::CheckpointReader(const InputFile& file)
    : values_(file, "/checkpoints/values", H5T_FLOAT),
      texts_(file, "/checkpoints/strategies", H5T_INTEGER),
      times_(read_times(file)),
      value_ranges_(read_ranges(file, "/checkpoints/value_range", times_.size())),
      text_ranges_(read_ranges(file, "/checkpoints/strategy_range", times_.size())) {}

Checkpoint CheckpointReader::read(std::size_t index) const {
  const auto rows = [index](const std::vector<std::int64_t>& ranges, std::size_t i) {
    return static_cast<hsize_t>(ranges[2 * index + i]);
  };
  const auto text = texts_.read<std::uint8_t>(rows(text_ranges_, 0), rows(text_ranges_, 1));
  return {times_[index], values_.read<double>(rows(value_ranges_, 0), rows(value_ranges_, 1)),
          std::string(text.begin(), text.end())};
}

}  // namespace netpocket
