#include "engine/analysis/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/analysis/run_history.h"
#include "engine/recording/soundness.h"

namespace netpocket {

namespace {

using Json = nlohmann::ordered_json;

// JSON must be UTF-8. Other bytes (a path in a command, a damaged file) become the replacement character.
std::string utf8(const std::string& text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

Json vector_json(const Eigen::Vector3d& v) { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }

// Null when there is no judgement.
Json judgement(Verdict verdict) {
  if (verdict == Verdict::yes) return true;
  if (verdict == Verdict::no) return false;
  return nullptr;
}

// Null when there is no contact or it was not recorded.
Json depth_json(const std::optional<DeepestContact>& deepest) {
  if (!deepest) return nullptr;
  return {{"depth", deepest->depth}, {"part", deepest->part},       {"time", deepest->time},
          {"cord", deepest->cord},   {"partner", deepest->partner}, {"stiffness", deepest->stiffness}};
}

// Null when they were not recorded.
Json safeguards_json(const RunData& run) {
  const auto counts = safeguard_counts(run);
  if (counts.empty()) return nullptr;
  Json json = Json::object();
  for (const SafeguardCount& count : counts) json[std::string(count.name)] = count.value;
  return json;
}

std::string capture_text(const Capture& capture) {
  const char* separator = capture.reason.empty() ? "" : ": ";
  return fmt::format("{}{}{}", to_string(capture.verdict), separator, capture.reason);
}

std::string line(const char* label, const std::string& value) { return fmt::format("{:<15}{}\n", label, value); }

std::string ending(const Recording& recording) {
  const RunStatus& status = recording.status();
  const char* separator = status.message.empty() ? "" : ": ";
  return fmt::format("{} at t = {:.6g} s{}{}", to_string(status.reason), status.time, separator, status.message);
}

std::string effort(const RunStatistics& s) {
  if (!(s.wall_seconds > 0)) return fmt::format("{:.6g} s simulated in {} steps", s.simulated_seconds, s.steps);
  return fmt::format("{:.6g} s simulated in {:.4g} s ({:.3g} x real time; {:.4g} s of processor time, {} steps)",
                     s.simulated_seconds, s.wall_seconds, s.simulated_seconds / s.wall_seconds, s.cpu_seconds, s.steps);
}

}  // namespace

Json summary_json(const RunData& run) {
  const RunSummary summary = summarize(run);
  const RunStatistics& statistics = run.statistics();
  const RunOrigin& origin = run.origin();
  Json peak = vector_json(summary.peak_force);
  peak["time_y"] = summary.peak_time_y;
  Json json = {{"scenario", utf8(origin.scenario_name)},
               {"version", utf8(origin.netpocket_version)},
               {"commit", utf8(origin.commit)},
               {"reason", to_string(run.status().reason)},
               {"message", utf8(run.status().message)},
               {"simulated_seconds", statistics.simulated_seconds},
               {"wall_seconds", statistics.wall_seconds},
               {"cpu_seconds", statistics.cpu_seconds},
               {"elements", statistics.elements},
               {"coordinates", statistics.coordinates},
               {"steps", statistics.steps},
               {"time_step", statistics.time_step},
               {"evaluation", utf8(statistics.evaluation)},
               {"frames", run.frame_count()},
               {"closing_end", phase_end(origin.phases, kClosing)},
               {"captured", judgement(summary.captured)},
               {"capture", to_string(summary.captured)},
               {"first_contact_time", summary.first_contact_time ? Json(*summary.first_contact_time) : Json()},
               {"peak_force", peak},
               {"impulse", vector_json(summary.impulse)},
               {"energy_error", summary.energy_error},
               {"energy_error_joules", summary.energy_error_joules},
               {"energy_put_in", summary.energy_put_in},
               {"averaging_window", summary.averaging_window},
               {"penetration", depth_json(deepest_penetration(run))},
               {"overlap", depth_json(deepest_overlap(run))},
               {"safeguards", safeguards_json(run)}};
  if (!origin.draft.empty()) json["draft"] = utf8(origin.draft);
  return json;
}

std::string summary_text(const Recording& recording) {
  const RunSummary s = summarize(recording);
  const RunOrigin& origin = recording.origin();
  const RunStatistics& statistics = recording.statistics();
  std::string text;
  text += line("scenario", origin.scenario_name);
  text += line("netpocket", fmt::format("{} ({})", origin.netpocket_version, origin.commit));
  text += line("run", ending(recording));
  if (!origin.draft.empty()) text += line("draft", origin.draft);
  text += line("effort", effort(statistics));
  text += line("model", fmt::format("{} elements, {} coordinates", statistics.elements, statistics.coordinates));
  if (statistics.time_step > 0) {
    text += line("step", fmt::format("{:.3g} s, limited by {}", statistics.time_step, statistics.step_limit));
  }
  text += line("captured", capture_text(RunHistory(recording).capture()));
  text += line("first contact", s.first_contact_time ? fmt::format("{:.4g} s", *s.first_contact_time) : "none");
  text += fmt::format("{:<15}{:>12}{:>12}{:>12}\n", "on the target", "x", "y", "z");
  const auto row = [&text](const char* label, const Eigen::Vector3d& v, const std::string& remark) {
    text += fmt::format("{:<15}{:>12.4g}{:>12.4g}{:>12.4g}  {}\n", label, v.x(), v.y(), v.z(), remark);
  };
  row("peak force", s.peak_force,
      fmt::format("N, y at t = {:.4g} s, means over {:.3g} s", s.peak_time_y, s.averaging_window));
  row("impulse", s.impulse, "N s");
  text += line("energy error", energy_error_text(s.energy_error_joules, s.energy_put_in));
  text += line("penetration", penetration_text(recording));
  text += line("overlap", overlap_text(recording));
  text += line("safeguards", safeguards_text(recording));
  return text;
}

Json findings_json(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    Json cases = Json::array();
    for (const FindingCase& c : finding.cases) {
      Json measures = Json::array();
      for (const Measure& m : c.measures) measures.push_back({{"name", m.name}, {"unit", m.unit}, {"value", m.value}});
      cases.push_back({{"name", utf8(c.name)},
                       {"value", c.value},
                       {"holds", judgement(c.verdict)},
                       {"verdict", to_string(c.verdict)},
                       {"measures", measures}});
    }
    list.push_back({{"id", finding.id}, {"text", finding.text}, {"rule", finding.rule}, {"cases", cases}});
  }
  return {{"findings", list}};
}

std::string findings_text(const std::vector<Finding>& findings) {
  std::size_t width = 0, verdicts = 0;
  for (const Finding& finding : findings) {
    for (const FindingCase& c : finding.cases) {
      width = std::max(width, c.name.size());
      verdicts = std::max(verdicts, std::string_view(to_string(c.verdict)).size());
    }
  }
  std::string text;
  for (const Finding& finding : findings) {
    text += fmt::format("{:<4} {}\n", finding.id, finding.text);
    for (const FindingCase& c : finding.cases) {
      text += fmt::format("       {:<{}}  {:<{}}  {}\n", c.name, width, to_string(c.verdict), verdicts, c.value);
    }
  }
  return text;
}

}  // namespace netpocket
