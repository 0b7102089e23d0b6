#pragma once
// Collects what the benchmarks measure and writes it as Markdown: machine, commit, one table with ratios to the
// reference element of the same run, since times of different runs do not compare.

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace netpocket {

class ResultsTable : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;
  // What matters most, each with a ratio; empty for a part of the benchmarks.
  std::string speed_text() const;
  // Throws std::runtime_error when the file cannot be written.
  void write(const std::string& path) const;

 private:
  struct Row {
    std::string name;
    double cpu_seconds;  // per iteration
    benchmark::UserCounters counters;
  };
  const Row* find(const std::string& name) const;
  std::string machine() const;
  std::string rows_text() const;
  std::string threads_text() const;

  std::vector<Row> rows_;
};

}  // namespace netpocket
