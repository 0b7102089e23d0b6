#include "engine/recording/outcome_io.h"

#include <array>
#include <cmath>

namespace netpocket {

namespace {

constexpr char kOutcomeGroup[] = "/outcome";
constexpr std::size_t kTextBytes = 4096;

struct Field {
  const char* name;
  const char* unit;
  const char* help;
};

// The reason is stored last: a run has ended once its reason is there.
constexpr std::array<Field, 4> kTexts = {{{"message", "", "one sentence"},
                                          {"step_limit", "", "what limits the integration step"},
                                          {"evaluation", "", "mean_strain or full"},
                                          {"reason", "", "finished, stopped, diverged, limited or storage_failed"}}};
constexpr std::array<Field, 8> kNumbers = {{{"time", "s", "simulated time reached"},
                                            {"simulated_seconds", "s", "simulated time"},
                                            {"wall_seconds", "s", "wall time of the integration"},
                                            {"cpu_seconds", "s", "processor time of the integration"},
                                            {"steps", "1", "integration steps"},
                                            {"elements", "1", "cable elements"},
                                            {"coordinates", "1", "generalised coordinates"},
                                            {"time_step", "s", "smallest integration step"}}};

std::array<std::string, kTexts.size()> texts_of(const RunStatus& status, const RunStatistics& statistics) {
  return {status.message, statistics.step_limit, statistics.evaluation, to_string(status.reason)};
}

std::array<double, kNumbers.size()> numbers_of(const RunStatus& status, const RunStatistics& statistics) {
  return {status.time,
          statistics.simulated_seconds,
          statistics.wall_seconds,
          statistics.cpu_seconds,
          static_cast<double>(statistics.steps),
          static_cast<double>(statistics.elements),
          static_cast<double>(statistics.coordinates),
          statistics.time_step};
}

RunReason reason_named(const std::string& name) {
  for (const auto reason : {RunReason::finished, RunReason::stopped, RunReason::diverged, RunReason::storage_failed,
                            RunReason::limited, RunReason::running}) {
    if (name == to_string(reason)) return reason;
  }
  throw Hdf5Error("the run ended for an unknown reason");
}

std::string at(const Field& field) { return std::string(kOutcomeGroup) + "/" + field.name; }

double read_number(const InputFile& file, const Field& field) {
  const auto values = read_array<double>(file, at(field));
  if (values.size() != 1) throw Hdf5Error(at(field) + " has the wrong length");
  return values[0];
}

// Whole numbers are stored as doubles, which are exact up to 2^53.
template <typename T>
T whole(double value, double limit) {
  if (!(value >= 0 && value <= limit)) throw Hdf5Error("a count in /outcome is out of range");
  return static_cast<T>(value);
}

}  // namespace

OutcomeTables::OutcomeTables(hid_t file, ChunkCodec& codec) : group_(create_group(file, kOutcomeGroup)) {
  const Handle text = text_type(kTextBytes);
  for (const Field& f : kTexts)
    texts_.emplace_back(group_.get(), text.get(), TableLayout{f.name, f.unit, f.help}, codec);
  for (const Field& f : kNumbers) {
    numbers_.emplace_back(group_.get(), H5T_NATIVE_DOUBLE, TableLayout{f.name, f.unit, f.help}, codec);
  }
}

void OutcomeTables::write(hid_t file, const RunStatus& status, const RunStatistics& statistics) {
  const auto numbers = numbers_of(status, statistics);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers_[i].append(std::span<const double>(&numbers[i], 1));
    numbers_[i].store();
  }
  const auto texts = texts_of(status, statistics);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i + 1 == texts.size()) checked(H5Fflush(file, H5F_SCOPE_LOCAL), "flush the file");
    texts_[i].append_text(texts[i]);
    texts_[i].store();
  }
}

std::optional<Outcome> read_outcome(const InputFile& file) {
  std::array<std::string, kTexts.size()> texts;
  for (std::size_t i = kTexts.size(); i-- > 0;) {
    const auto rows = read_texts(file, at(kTexts[i]));
    if (rows.empty() || rows[0].empty()) {
      if (i + 1 == kTexts.size()) return std::nullopt;
      continue;
    }
    texts[i] = rows[0];
  }
  std::array<double, kNumbers.size()> numbers;
  for (std::size_t i = 0; i < kNumbers.size(); ++i) numbers[i] = read_number(file, kNumbers[i]);
  constexpr double kLargestCount = 2147483647;
  Outcome outcome;
  outcome.status = {reason_named(texts[3]), numbers[0], texts[0]};
  outcome.statistics = {numbers[1],
                        numbers[2],
                        numbers[3],
                        whole<std::int64_t>(numbers[4], std::ldexp(1.0, 53)),
                        whole<std::int32_t>(numbers[5], kLargestCount),
                        whole<std::int32_t>(numbers[6], kLargestCount),
                        numbers[7],
                        texts[1],
                        texts[2]};
  return outcome;
}

}  // namespace netpocket
