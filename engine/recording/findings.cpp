// F1-F11 of Tang, Deng, Bai, Wei & Zhao, Appl. Sci. 2023, 13, 10377, section 4.2 and conclusions. The limits are what
// the paper's words mean on its figures ("slight", "clearly", "of the order of"); none follows from a result.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/recording/run_history.h"
#include "engine/recording/summary.h"

namespace netpocket {

namespace {

using Runs = std::vector<RunHistory>;

// "Appears" in a plot whose scale is set by F_y; also the least impulse that counts as an episode.
constexpr double kNoticeable = 0.02;
constexpr double kEqualWithinFactor = 2;
constexpr double kTargetRest = 1e-3;      // m
constexpr double kSpacecraftRest = 1e-2;  // m
constexpr double kSlight = 0.1;           // m
constexpr double kClearlySmaller = 0.5;
constexpr double kMostOfTheTime = 0.5;
constexpr double kTogether = 0.2;
constexpr double kTowingNeeded = 1.0;  // s

FindingCase verdict(const RunHistory& run, bool holds, std::string value) {
  return {run.name(), std::move(value), holds};
}

std::string ends_before(const RunHistory& run, const char* what, double time) {
  constexpr double kRounding = 1e-9;  // s
  if (run.end() > time - kRounding) return fmt::format("run ends at t = {:.4g} s, when {}", run.end(), what);
  return fmt::format("run ends at t = {:.4g} s, before {} at {:.4g} s", run.end(), what, time);
}

// What is missing to judge the closing phase; empty when nothing is.
std::string missing_closing(const RunHistory& run) {
  if (std::isnan(run.closing_end())) return "the recording does not say when the closing ends";
  if (run.after_closed().empty()) return ends_before(run, "the closing is over", run.closing_end());
  return "";
}

std::string missing_towing(const RunHistory& run) {
  if (std::isnan(run.towing_start())) return "the scenario has no towing";
  const double needed = run.towing_start() + kTowingNeeded;
  if (run.end() < needed - 1e-6) return ends_before(run, "the first second of towing is over", needed);
  return "";
}

double peak_y(const RunHistory& run, FrameRange range) { return std::abs(run.peak(Channel::contact_fy, range).value); }

FindingCase y_force_is_largest(const RunHistory& run) {
  const double x = std::abs(run.peak(Channel::contact_fx, run.all()).value);
  const double y = peak_y(run, run.all());
  const double z = std::abs(run.peak(Channel::contact_fz, run.all()).value);
  return verdict(run, y > x && y > z, fmt::format("peaks |F_x| {:.3g} N, |F_y| {:.3g} N, |F_z| {:.3g} N", x, y, z));
}

FindingCase largest_force_before_closed(const RunHistory& run) {
  std::string missing = missing_closing(run);
  const bool tows = !std::isnan(run.towing_start());
  if (missing.empty() && tows) missing = missing_towing(run);
  if (!missing.empty()) return verdict(run, false, missing);
  const Peak peak = run.force_peak();
  if (peak.value == 0) return verdict(run, false, "no contact");
  return verdict(run, peak.time <= run.closing_end() + 1e-6,
                 fmt::format("|F| peaks with {:.3g} N at t = {:.4g} s, closing ends at {:.4g} s", peak.value, peak.time,
                             run.closing_end()));
}

FindingCase forces_alternate(const RunHistory& run) {
  const std::string missing = missing_closing(run);
  if (!missing.empty()) return verdict(run, false, missing);
  const auto episodes = run.episodes(run.until_closed(), kNoticeable);
  if (episodes.empty()) return verdict(run, false, "no contact before the closing ends");
  std::string value = "impulses";
  for (const ContactEpisode& e : episodes) value += fmt::format(" {:+.3g} (t = {:.3g} s)", e.impulse, e.start);
  const bool holds = episodes.size() >= 3 && episodes[0].impulse < 0;  // neighbours differ in sign
  return verdict(run, holds, value + " N s");
}

FindingCase bodies_rest_then_fluctuate(const RunHistory& run) {
  const std::string missing = missing_closing(run);
  if (!missing.empty()) return verdict(run, false, missing);
  const auto contact = run.first_contact();
  if (!contact || *contact > run.closing_end()) return verdict(run, false, "no contact before the closing ends");
  const std::size_t first_frame = run.frames_from(*contact).first;
  const FrameRange before = {0, first_frame};
  const FrameRange during = {first_frame, run.until_closed().last};
  const double target_rest = run.excursion(Body::target, before, 0).norm();
  const double craft_rest = run.excursion(Body::spacecraft, before, 0).norm();
  // From where they were when contact began: what the folding rods did to the spacecraft before is no fluctuation.
  const std::size_t at_contact = first_frame > 0 ? first_frame - 1 : 0;
  const double target_y = run.excursion(Body::target, during, at_contact).y();
  const double craft_y = run.excursion(Body::spacecraft, during, at_contact).y();
  const bool rest = target_rest <= kTargetRest && craft_rest <= kSpacecraftRest;
  const bool slight = target_y > target_rest && craft_y > craft_rest && target_y < kSlight && craft_y < kSlight;
  return verdict(run, rest && slight,
                 fmt::format("before contact target {:.2g} m, spacecraft {:.2g} m; then in y target {:.2g} m, "
                             "spacecraft {:.2g} m",
                             target_rest, craft_rest, target_y, craft_y));
}

FindingCase towing_forces_are_smaller(const RunHistory& run) {
  const std::string missing = missing_towing(run);
  if (!missing.empty()) return verdict(run, false, missing);
  const FrameRange towing = run.towing();
  const double before = peak_y(run, {0, towing.first});
  const double during = peak_y(run, towing);
  std::size_t touching = 0;
  for (std::size_t i = towing.first; i < towing.last; ++i) touching += run.in_contact(i) ? 1 : 0;
  const double fraction = static_cast<double>(touching) / static_cast<double>(towing.last - towing.first);
  return verdict(run, during < kClearlySmaller * before && fraction > kMostOfTheTime,
                 fmt::format("|F_y| peaks {:.3g} N before, {:.3g} N in towing; contact in {:.0f} % of the frames",
                             before, during, 100 * fraction));
}

FindingCase bodies_move_together(const RunHistory& run) {
  const std::string missing = missing_towing(run);
  if (!missing.empty()) return verdict(run, false, missing);
  const FrameRange towing = run.towing();
  const auto separation = [&run](std::size_t i) {
    return run.position(Body::target, i).y() - run.position(Body::spacecraft, i).y();
  };
  double change = 0;
  for (std::size_t i = towing.first; i < towing.last; ++i) {
    change = std::max(change, std::abs(separation(i) - separation(towing.first)));
  }
  const double distance =
      std::abs(run.position(Body::spacecraft, towing.last - 1).y() - run.position(Body::spacecraft, towing.first).y());
  return verdict(run, change < kTogether * distance,
                 fmt::format("separation changes by {:.2g} m while the spacecraft moves {:.2g} m", change, distance));
}

FindingCase lateral_motion_is_small(const RunHistory& run) {
  const std::string missing = missing_towing(run);
  if (!missing.empty()) return verdict(run, false, missing);
  const FrameRange towing = run.towing();
  const auto lateral = [&](Body body) {
    const Eigen::Vector3d size = run.excursion(body, towing, towing.first);
    return std::max(size.x(), size.z());
  };
  const double target = lateral(Body::target);
  const double craft = lateral(Body::spacecraft);
  const auto is_of_order = [](double value, double order) { return value > order / 10 && value < order * 10; };
  return verdict(run, is_of_order(target, 1e-3) && is_of_order(craft, 1e-5),
                 fmt::format("target {:.2g} m, spacecraft {:.2g} m", target, craft));
}

FindingCase target_stays_captured(const RunHistory& run) {
  std::string why_not = run.why_not_captured();
  if (why_not.empty()) why_not = missing_towing(run);
  return verdict(run, why_not.empty(), why_not.empty() ? fmt::format("inside until t = {:.4g} s", run.end()) : why_not);
}

// Judges a quantity that should rise or fall with the closing time. Runs that close in the same time are not compared.
template <typename Quantity>
bool is_monotone(Runs runs, const Quantity& quantity, bool rising) {
  const auto earlier = [](const RunHistory& a, const RunHistory& b) { return a.closing_end() < b.closing_end(); };
  std::sort(runs.begin(), runs.end(), earlier);
  int compared = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t j = i + 1; j < runs.size(); ++j) {
      if (!(runs[j].closing_end() > runs[i].closing_end())) continue;
      ++compared;
      const bool rises = quantity(runs[i]) < quantity(runs[j]);
      const bool falls = quantity(runs[i]) > quantity(runs[j]);
      if (rising ? !rises : !falls) return false;
    }
  }
  return compared > 0;
}

// The same verdict for all runs; a run that cannot be judged fails it for all.
std::vector<FindingCase> joint_verdict(const Runs& runs, const std::function<bool()>& judge,
                                       const std::function<std::string(const RunHistory&)>& value) {
  const auto complete = [](const RunHistory& run) { return missing_closing(run).empty() && run.first_contact(); };
  const bool holds = std::all_of(runs.begin(), runs.end(), complete) && judge();
  std::vector<FindingCase> cases;
  for (const RunHistory& run : runs) {
    std::string missing = missing_closing(run);
    if (missing.empty() && !run.first_contact()) missing = "no contact";
    cases.push_back(verdict(run, holds, missing.empty() ? value(run) : missing));
  }
  return cases;
}

std::vector<FindingCase> faster_is_harder(const Runs& runs) {
  const auto peak = [](const RunHistory& run) { return peak_y(run, run.all()); };
  return joint_verdict(
      runs, [&] { return is_monotone(runs, peak, false); },
      [&](const RunHistory& run) {
        return fmt::format("closing ends at {:.4g} s: peak |F_y| {:.3g} N", run.closing_end(), peak(run));
      });
}

std::vector<FindingCase> faster_is_earlier(const Runs& runs) {
  const auto contact = [](const RunHistory& run) { return *run.first_contact(); };
  return joint_verdict(
      runs, [&] { return is_monotone(runs, contact, true); },
      [&](const RunHistory& run) {
        return fmt::format("closing ends at {:.4g} s: first contact at {:.4g} s", run.closing_end(), contact(run));
      });
}

// Largest |F_x| or |F_z|, whichever is less: of two that should appear, the one that hardly does.
double lesser_lateral_peak(const RunHistory& run, FrameRange range) {
  return std::min(std::abs(run.peak(Channel::contact_fx, range).value),
                  std::abs(run.peak(Channel::contact_fz, range).value));
}

bool appear_only_after_closing(const RunHistory& run) {
  const double noticeable = kNoticeable * peak_y(run, run.all());
  return run.lateral_peak(run.until_closed()) <= noticeable &&
         lesser_lateral_peak(run, run.after_closed()) > noticeable;
}

std::vector<FindingCase> lateral_forces_come_late(const Runs& runs) {
  const auto judge = [&runs] {
    double least = 1e300;
    double most = 0;
    for (const RunHistory& run : runs) {
      least = std::min(least, run.lateral_peak(run.after_closed()));
      most = std::max(most, run.lateral_peak(run.after_closed()));
    }
    return runs.size() > 1 && std::all_of(runs.begin(), runs.end(), appear_only_after_closing) &&
           most < kEqualWithinFactor * least;
  };
  return joint_verdict(runs, judge, [](const RunHistory& run) {
    const FrameRange after = run.after_closed();
    return fmt::format(
        "largest of |F_x|, |F_z|: {:.3g} N before closing ends; |F_x| {:.3g} N, |F_z| {:.3g} N after; "
        "peak |F_y| {:.3g} N",
        run.lateral_peak(run.until_closed()), std::abs(run.peak(Channel::contact_fx, after).value),
        std::abs(run.peak(Channel::contact_fz, after).value), peak_y(run, run.all()));
  });
}

using Judge = std::function<std::vector<FindingCase>(const Runs&)>;

Judge each(FindingCase (*judge)(const RunHistory&)) {
  return [judge](const Runs& runs) {
    std::vector<FindingCase> cases;
    for (const RunHistory& run : runs) cases.push_back(judge(run));
    return cases;
  };
}

struct Statement {
  const char* id;
  const char* text;
  std::string rule;
  Judge judge;
};

std::vector<Statement> statements() {
  return {
      {"F1", "The contact force in y exceeds those in x and z.",
       "peak |F_y| > peak |F_x| and > peak |F_z| over the run; forces are means over the output interval",
       each(y_force_is_largest)},
      {"F2", "The largest contact force comes before the closing ends.",
       "the frame with the largest |F| of the whole run, towing included, is not later than the end of the closing law",
       each(largest_force_before_closed)},
      {"F3", "Faster closing gives a larger contact force in y.",
       "over runs sorted by the end of closing, peak |F_y| falls strictly; one verdict for all", faster_is_harder},
      {"F4", "Faster closing gives an earlier first contact.",
       "over runs sorted by the end of closing, the first frame with contact comes strictly later; one verdict for all",
       faster_is_earlier},
      {"F5", "Forces in x and z appear only after closing; the closing time hardly changes them.",
       "|F_x| and |F_z| stay below 2 % of the run's peak |F_y| until closing ends and both exceed it afterwards, and "
       "the larger peaks after closing differ by less than a factor 2 between the runs; one verdict for all",
       lateral_forces_come_late},
      {"F6", "The force in y is negative, then positive, then negative while closing (case 1).",
       "the first three episodes of F_y of one sign before closing ends are -, +, -; episodes with less than 2 % of "
       "the "
       "largest impulse are merged into their neighbours",
       each(forces_alternate)},
      {"F7", "Target and spacecraft rest until contact, then move slightly in y before closing ends.",
       "until first contact the target moves at most 1 mm and the spacecraft 10 mm (the folding rods move it, as "
       "momentum demands); from where they are then until closing ends both move in y by more than they did before, "
       "but "
       "less than 0.1 m",
       each(bodies_rest_then_fluctuate)},
      {"F8", "In towing the forces are clearly smaller but contact persists.",
       "peak |F_y| after towing starts is below 50 % of that before, and more than half of the frames in towing have "
       "contact",
       each(towing_forces_are_smaller)},
      {"F9", "In towing spacecraft and target move together in y.",
       "in towing the distance in y between the two changes by less than 20 % of the way of the spacecraft",
       each(bodies_move_together)},
      {"F10", "In towing the lateral motion is of the order of 1e-3 m (target) and 1e-5 m (spacecraft).",
       "the largest change of x or z since towing started is within a factor 10 of 1e-3 m for the target and of 1e-5 m "
       "for the spacecraft",
       each(lateral_motion_is_small)},
      {"F11", "The target stays captured.", std::string(kCaptureRule) + ", and for 1 s or more after towing starts",
       each(target_stays_captured)},
  };
}

}  // namespace

std::vector<Finding> evaluate_findings(const std::vector<const Recording*>& recordings) {
  Runs runs;
  for (const Recording* recording : recordings) runs.emplace_back(*recording);
  std::vector<Finding> findings;
  for (const Statement& s : statements()) findings.push_back({s.id, s.text, s.rule, s.judge(runs)});
  return findings;
}

}  // namespace netpocket
