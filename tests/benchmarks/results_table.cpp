#include "tests/benchmarks/results_table.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <stdexcept>

#include "commit.h"
#include "engine/ancf/instruction_set.h"

namespace netpocket {
namespace {

// First value of a key of /proc/cpuinfo.
std::string processor(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string load_average() {
  std::string first;
  std::ifstream("/proc/loadavg") >> first;
  return first;
}

std::string counter(const benchmark::UserCounters& counters, const char* name, const char* format, double factor = 1) {
  const auto found = counters.find(name);
  return found == counters.end() ? "" : fmt::format(fmt::runtime(format), factor * found->second.value);
}

}  // namespace

void ResultsTable::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    if (run.error_occurred || run.run_type != Run::RT_Iteration) continue;
    rows_.push_back(
        {run.benchmark_name(), run.cpu_accumulated_time / static_cast<double>(run.iterations), run.counters});
  }
}

void ResultsTable::write(const std::string& path) const {
  double reference = 0, peak = 0;
  for (const Row& row : rows_) {
    if (row.name == "element/reference_mean_strain") reference = row.counters.at("per_element");
    if (row.name == "machine/peak") peak = row.counters.at("flops");
  }
  std::ofstream file(path);
  file << "# Timings\n\nWritten by `./dev bench`. Times are processor time, of a machine that does other things too: "
          "compare the "
          "ratios, not the\nnanoseconds. \"ratio\" is time per element against `element/reference_mean_strain`, the "
          "readable "
          "form of the element,\nin the same run.\n\n";
  file << fmt::format("- commit {}, {:%Y-%m-%d}\n", NETPOCKET_COMMIT, fmt::gmtime(std::time(nullptr)));
  file << fmt::format("- {} (model {}), {} processors, kernels for {}\n", processor("model name"), processor("model\t"),
                      benchmark::CPUInfo::Get().num_cpus, to_string(instruction_set()));
  file << fmt::format("- load average at the end: {}\n", load_average());
  if (peak > 0) {
    file << fmt::format("- measured peak without fused multiply-add: {:.1f} GFLOP/s (`machine/peak`)\n", 1e-9 * peak);
  }
  file << "\n| benchmark | elements | ms | ns per element (and step) | ratio | of peak | x real time | bytes per "
          "element |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Row& row : rows_) {
    const auto& c = row.counters;
    std::string ratio, part;
    if (reference > 0 && c.contains("per_element")) ratio = fmt::format("{:.3f}", c.at("per_element") / reference);
    if (peak > 0 && c.contains("flops") && row.name != "machine/peak")
      part = fmt::format("{:.0f} %", 100 * c.at("flops") / peak);
    file << fmt::format("| {} | {} | {:.4g} | {} | {} | {} | {} | {} |\n", row.name, counter(c, "elements", "{:.0f}"),
                        1e3 * row.cpu_seconds, counter(c, "per_element", "{:.2f}", 1e9), ratio, part,
                        counter(c, "x_real_time", "{:.2f}"), counter(c, "bytes_per_element", "{:.0f}"));
  }
  file.flush();
  if (!file) throw std::runtime_error("Cannot write \"" + path + "\".");
}

}  // namespace netpocket
