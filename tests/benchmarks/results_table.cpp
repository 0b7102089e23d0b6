#include "tests/benchmarks/results_table.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <stdexcept>

#include "commit.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

constexpr const char* kSteps = "step/meshes_threads/";

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

// The first of this name, or nullptr.
const ResultsTable::Row* ResultsTable::find(const std::string& name) const {
  const auto found = std::ranges::find(rows_, name, &Row::name);
  return found == rows_.end() ? nullptr : &*found;
}

std::string ResultsTable::machine() const {
  std::string text = fmt::format("- commit {}, {:%Y-%m-%d}\n", NETPOCKET_COMMIT, fmt::gmtime(std::time(nullptr)));
  text += fmt::format("- {} (model {}), {} processors, kernels for {}\n", processor("model name"), processor("model\t"),
                      benchmark::CPUInfo::Get().num_cpus, to_string(instruction_set()));
  text += fmt::format("- load average at the end: {}\n", load_average());
  const auto by_threads = [&](const char* name, const char* what, const char* value, const char* unit) {
    const Row* one = find(fmt::format("{}/real_time/threads:1", name));
    const Row* two = find(fmt::format("{}/real_time/threads:2", name));
    if (one == nullptr || two == nullptr) return;
    const double first = one->counters.at(value), both = two->counters.at(value);
    text += fmt::format("- {}: {:.1f} {} by one thread, {:.1f} by two ({:.2f} times), `{}`\n", what, 1e-9 * first, unit,
                        1e-9 * both, both / first, name);
  };
  by_threads("machine/peak", "measured peak without fused multiply-add", "flops", "GFLOP/s");
  by_threads("machine/read", "reading memory", "bytes", "GB/s");
  return text;
}

std::string ResultsTable::rows_text() const {
  const Row *reference = find("element/reference_mean_strain"), *peak = find("machine/peak/real_time/threads:1");
  std::string text =
      "| benchmark | elements | ms | ns per element (and step) | ratio | of peak | x real time | bytes per element |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Row& row : rows_) {
    const auto& c = row.counters;
    std::string ratio, part;
    if (reference != nullptr && c.contains("per_element")) {
      ratio = fmt::format("{:.3f}", c.at("per_element") / reference->counters.at("per_element"));
    }
    if (peak != nullptr && c.contains("flops")) {
      part = fmt::format("{:.0f} %", 100 * c.at("flops") / peak->counters.at("flops"));
    }
    text += fmt::format("| {} | {} | {:.4g} | {} | {} | {} | {} | {} |\n", row.name, counter(c, "elements", "{:.0f}"),
                        1e3 * row.cpu_seconds, counter(c, "per_element", "{:.2f}", 1e9), ratio, part,
                        counter(c, "x_real_time", "{:.2f}"), counter(c, "bytes_per_element", "{:.0f}"));
  }
  return text;
}

// Steps by one and by two threads, of the same stretch of the same simulation.
std::string ResultsTable::threads_text() const {
  std::string text;
  for (const Row& one : rows_) {
    if (!one.name.starts_with(kSteps)) continue;
    std::string name = one.name;
    const std::size_t threads = name.find("/1/");
    if (threads == std::string::npos) continue;
    const Row* two = find(name.replace(threads, 3, "/2/"));
    if (two == nullptr) continue;
    const auto times = [&](const char* value) {
      const double alone = one.counters.at(value), both = two->counters.at(value);
      return fmt::format("{:.2f} | {:.2f} | {:.2f}", 1e9 * alone, 1e9 * both, alone / both);
    };
    text += fmt::format("| {:.0f} | {} | {} |\n", one.counters.at("elements").value, times("per_element"),
                        times("quiet_per_element"));
  }
  if (text.empty()) return text;
  return "\n## Two threads\n\nWall-clock ns per element and step of one thread and of two, and how many times faster "
         "two "
         "are: the mean, and the\nquietest tenth of the intervals between frames, when other programs and other "
         "machines on the same processor\ndisturb least.\n\n"
         "| elements | one | two | times | one, quiet | two, quiet | times, quiet |\n"
         "| --- | --- | --- | --- | --- | --- | --- |\n" +
         text;
}

std::string ResultsTable::speed_text() const {
  std::string rows;
  const auto add = [&](const std::string& what, const std::string& value, const std::string& ratio) {
    rows += fmt::format("| {} | {} | {} |\n", what, value, ratio);
  };
  const Row *reference = find("element/reference_mean_strain"), *case1 = find("case1/elements_per_side/2/iterations:5");
  if (reference != nullptr && case1 != nullptr) {
    const double ns = 1e9 * case1->counters.at("per_element");
    add("case 1, a step", fmt::format("{:.2f} ns per element", ns),
        fmt::format("{:.3f} of the element in its readable form", ns / (1e9 * reference->counters.at("per_element"))));
  }
  const Row *fine = find("campaign/fine/iterations:1/manual_time"),
            *coarse = find("campaign/coarse/iterations:1/manual_time"),
            *draft = find("campaign/draft/iterations:1/manual_time");
  if (fine != nullptr && coarse != nullptr && draft != nullptr) {
    const double full_speed = fine->counters.at("x_real_time");
    for (const auto& [row, what] : {std::pair(fine, "mesh of case 1"), {coarse, "coarse"}, {draft, "drafts"}}) {
      const double speed = row->counters.at("x_real_time");
      add(fmt::format("scattered captures, {}", what),
          fmt::format("{:.0f} a minute and core, {:.1f} x real time", row->counters.at("per_minute").value, speed),
          fmt::format("{:.2f} of the mesh of case 1", speed / full_speed));
    }
  }
  for (const Row& one : rows_) {
    if (!one.name.starts_with(kSteps) || one.counters.at("elements").value < 10000) continue;
    std::string name = one.name;
    const std::size_t threads = name.find("/1/");
    const Row* two = threads == std::string::npos ? nullptr : find(name.replace(threads, 3, "/2/"));
    if (two == nullptr) continue;
    const auto times = [&](const char* value) { return one.counters.at(value) / two->counters.at(value); };
    add(fmt::format("two threads, {:.0f} elements", one.counters.at("elements").value),
        fmt::format("{:.2f} ns per element", 1e9 * two->counters.at("per_element")),
        fmt::format("{:.2f} of one thread's speed, {:.2f} when quiet", times("per_element"),
                    times("quiet_per_element")));
  }
  const Row *alone = find("machine/peak/real_time/threads:1"), *both = find("machine/peak/real_time/threads:2");
  if (alone != nullptr && both != nullptr) {
    const double peak = both->counters.at("flops");
    add("two threads, this machine's arithmetic alone", fmt::format("{:.1f} GFLOP/s", 1e-9 * peak),
        fmt::format("{:.2f} of one thread's speed", peak / alone->counters.at("flops")));
  }
  const Row* net = find("thrown_net/step/iterations:12/manual_time");
  if (net != nullptr && case1 != nullptr) {
    const double own = net->counters.at("per_element"), elements = net->counters.at("elements");
    add("thrown net in free flight, a step",
        fmt::format("{:.1f} µs, {:.2f} ns per element", 1e6 * own * elements, 1e9 * own),
        fmt::format("{:.2f} of case 1's time per element", own / case1->counters.at("per_element")));
  }
  if (rows.empty()) return rows;
  return "\n## Speed\n\n| what | value | ratio |\n| --- | --- | --- |\n" + rows;
}

void ResultsTable::write(const std::string& path) const {
  std::ofstream file(path);
  file << "# Timings\n\nWritten by `./dev bench`. Times are processor time, of a machine that does other things too: "
          "compare the ratios, not the\nnanoseconds. \"ratio\" is time per element against "
          "`element/reference_mean_strain`, the readable form of the element,\nin the same run.\n\n"
       << machine() << '\n'
       << rows_text() << threads_text() << speed_text();
  file.flush();
  if (!file) throw std::runtime_error("Cannot write \"" + path + "\".");
}

}  // namespace netpocket
