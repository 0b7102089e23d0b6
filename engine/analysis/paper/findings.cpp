// F1-F11 of Tang, Deng, Bai, Wei & Zhao, Appl. Sci. 2023, 13, 10377, section 4.2 and conclusions. The limits express
// the paper's words ("slight", "clearly", "of the order of") on the scale of its figures. None is derived from a
// result.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "engine/analysis/paper/draws.h"
#include "engine/analysis/paper/push_regions.h"
#include "engine/analysis/run_history.h"
#include "engine/analysis/run_labels.h"
#include "engine/analysis/summary.h"

namespace netpocket {

namespace {

using Runs = std::vector<RunHistory>;

// Fraction of peak |F_y| above which a force "appears" in a plot whose scale is set by F_y.
constexpr double kNoticeable = 0.02;
constexpr double kEqualWithinFactor = 2;
constexpr double kPush = 0.25;            // fraction of the largest impulse from which an episode counts as a push
constexpr std::size_t kPushesShown = 5;   // in the text
constexpr double kTargetRest = 1e-3;      // m
constexpr double kSpacecraftRest = 1e-2;  // m
constexpr double kSlight = 0.1;           // m
constexpr double kClearlySmaller = 0.5;
constexpr double kMostOfTheTime = 0.5;
constexpr double kTogether = 0.2;
constexpr double kTowingNeeded = 1.0;  // s

FindingCase verdict(const RunHistory& run, bool holds, std::string value, std::vector<Measure> measures = {}) {
  return {run.name(), std::move(value), holds ? Verdict::yes : Verdict::no, std::move(measures)};
}

FindingCase diverged(const RunHistory& run, std::string why) { return {run.name(), std::move(why), Verdict::diverged}; }

FindingCase not_known(const RunHistory& run, std::string why) { return {run.name(), std::move(why), Verdict::unknown}; }

std::string ends_before(const RunHistory& run, const char* what, double time) {
  constexpr double kRounding = 1e-9;  // s
  if (run.end() > time - kRounding) return fmt::format("run ends at t = {:.4g} s, when {}", run.end(), what);
  return fmt::format("run ends at t = {:.4g} s, before {} at {:.4g} s", run.end(), what, time);
}

// Why the closing phase cannot be judged; empty when it can.
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
  return verdict(run, y > x && y > z, fmt::format("peaks |F_x| {:.3g} N, |F_y| {:.3g} N, |F_z| {:.3g} N", x, y, z),
                 {{"peak |F_x|", "N", x}, {"peak |F_y|", "N", y}, {"peak |F_z|", "N", z}});
}

FindingCase largest_force_before_closed(const RunHistory& run) {
  std::string missing = missing_closing(run);
  const bool tows = !std::isnan(run.towing_start());
  if (missing.empty() && tows) missing = missing_towing(run);
  if (!missing.empty()) return not_known(run, missing);
  const Peak peak = run.force_peak();
  if (peak.value == 0) return verdict(run, false, "no contact");
  return verdict(run, peak.time <= run.closing_end() + 1e-6,
                 fmt::format("|F| peaks with {:.3g} N at t = {:.4g} s, closing ends at {:.4g} s", peak.value, peak.time,
                             run.closing_end()),
                 {{"peak |F|", "N", peak.value}, {"time of the peak", "s", peak.time}});
}

// Describes one push: impulse, time and regions.
std::string push_text(const ContactEpisode& push, const RegionImpulse& by) {
  return fmt::format(
      "{:+.3g} N s from t = {:.3g} s ({:.0f} % mouth, {:.0f} % kink row, {:.0f} % cone{}; y = {:.3g} m)", push.impulse,
      push.start, 100 * by.share(Region::mouth), 100 * by.share(Region::kink_row), 100 * by.share(Region::cone),
      by.unassigned == 0 ? "" : fmt::format(", {:.0f} % unknown", 100 * by.share_unassigned()), by.mean_height);
}

FindingCase forces_alternate(const RunHistory& run) {
  const std::string missing = missing_closing(run);
  if (!missing.empty()) return not_known(run, missing);
  const auto pushes = run.episodes(run.until_closed(), kPush);
  if (pushes.empty()) return verdict(run, false, "no contact before the closing ends");
  const PushRegions regions(run);
  if (!regions.missing().empty()) return not_known(run, regions.missing());

  struct Expected {
    double sign;
    Region region;
    const char* what;
  };
  constexpr Expected story[] = {
      {-1, Region::mouth, "first push"}, {1, Region::cone, "second push"}, {-1, Region::mouth, "third push"}};
  bool holds = pushes.size() >= std::size(story), known = true;
  std::vector<std::string> texts;
  std::vector<Measure> measures;
  for (std::size_t i = 0; i < std::min(pushes.size(), kPushesShown); ++i) {
    const RegionImpulse by = regions.impulse(pushes[i].frames);
    texts.push_back(push_text(pushes[i], by));
    if (i >= std::size(story)) continue;
    measures.push_back({story[i].what, "N s", pushes[i].impulse});
    const bool in_order = pushes[i].impulse * story[i].sign > 0;
    holds = holds && in_order && by.share(story[i].region) > 0.5;
    // The unassigned impulse may belong to the expected region. If that could change the verdict, there is none.
    known = known &&
            (!in_order || by.share(story[i].region) > 0.5 || by.share(story[i].region) + by.share_unassigned() <= 0.5);
  }
  std::string value = fmt::format("{}", fmt::join(texts, ", "));
  if (pushes.size() > kPushesShown) value += fmt::format(" and {} more", pushes.size() - kPushesShown);
  measures.push_back({"pushes", "1", static_cast<double>(pushes.size())});
  FindingCase result = verdict(run, holds, value, measures);
  if (!holds && !known) result.verdict = Verdict::unknown;
  return result;
}

FindingCase bodies_rest_then_fluctuate(const RunHistory& run) {
  const std::string missing = missing_closing(run);
  if (!missing.empty()) return not_known(run, missing);
  const auto contact = run.first_contact();
  if (!contact || *contact > run.closing_end()) return verdict(run, false, "no contact before the closing ends");
  const std::size_t first_frame = run.frames_from(*contact).first;
  const FrameRange before = {0, first_frame};
  const FrameRange during = {first_frame, run.until_closed().last};
  const double target_rest = run.excursion(Body::target, before, 0).norm();
  const double craft_rest = run.excursion(Body::spacecraft, before, 0).norm();
  // Relative to the positions when contact began: the folding rods moved the spacecraft before, which is no
  // fluctuation.
  const std::size_t at_contact = first_frame > 0 ? first_frame - 1 : 0;
  const double target_y = run.excursion(Body::target, during, at_contact).y();
  const double craft_y = run.excursion(Body::spacecraft, during, at_contact).y();
  const bool rest = target_rest <= kTargetRest && craft_rest <= kSpacecraftRest;
  const bool slight = target_y > target_rest && craft_y > craft_rest && target_y < kSlight && craft_y < kSlight;
  return verdict(run, rest && slight,
                 fmt::format("before contact target {:.2g} m, spacecraft {:.2g} m; then in y target {:.2g} m, "
                             "spacecraft {:.2g} m",
                             target_rest, craft_rest, target_y, craft_y),
                 {{"target before contact", "m", target_rest},
                  {"spacecraft before contact", "m", craft_rest},
                  {"target in y", "m", target_y},
                  {"spacecraft in y", "m", craft_y}});
}

FindingCase towing_forces_are_smaller(const RunHistory& run) {
  const std::string missing = missing_towing(run);
  if (!missing.empty()) return not_known(run, missing);
  const FrameRange towing = run.towing();
  const double before = peak_y(run, {0, towing.first});
  const double during = peak_y(run, towing);
  std::size_t touching = 0;
  for (std::size_t i = towing.first; i < towing.last; ++i) touching += run.in_contact(i) ? 1 : 0;
  const double fraction = static_cast<double>(touching) / static_cast<double>(towing.last - towing.first);
  return verdict(run, during < kClearlySmaller * before && fraction > kMostOfTheTime,
                 fmt::format("|F_y| peaks {:.3g} N before, {:.3g} N in towing; contact in {:.0f} % of the frames",
                             before, during, 100 * fraction),
                 {{"peak |F_y| before towing", "N", before},
                  {"peak |F_y| in towing", "N", during},
                  {"frames in contact", "%", 100 * fraction}});
}

FindingCase bodies_move_together(const RunHistory& run) {
  const std::string missing = missing_towing(run);
  if (!missing.empty()) return not_known(run, missing);
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
                 fmt::format("separation changes by {:.2g} m while the spacecraft moves {:.2g} m", change, distance),
                 {{"change of separation", "m", change}, {"way of the spacecraft", "m", distance}});
}

FindingCase lateral_motion_is_small(const RunHistory& run) {
  const std::string missing = missing_towing(run);
  if (!missing.empty()) return not_known(run, missing);
  const FrameRange towing = run.towing();
  const auto lateral = [&](Body body) {
    const Eigen::Vector3d size = run.excursion(body, towing, towing.first);
    return std::max(size.x(), size.z());
  };
  const double target = lateral(Body::target);
  const double craft = lateral(Body::spacecraft);
  const auto is_of_order = [](double value, double order) { return value > order / 10 && value < order * 10; };
  return verdict(run, is_of_order(target, 1e-3) && is_of_order(craft, 1e-5),
                 fmt::format("target {:.2g} m, spacecraft {:.2g} m", target, craft),
                 {{"target sideways", "m", target}, {"spacecraft sideways", "m", craft}});
}

FindingCase target_stays_captured(const RunHistory& run) {
  const Capture capture = run.capture();
  if (capture.verdict != Verdict::yes) return {run.name(), capture.reason, capture.verdict};
  if (const std::string missing = missing_towing(run); !missing.empty()) return not_known(run, missing);
  return verdict(run, true, fmt::format("inside until t = {:.4g} s", run.end()));
}

// Whether a quantity rises or falls strictly with the closing time. Runs with equal closing times are not compared.
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

using CaseOf = std::function<FindingCase(const RunHistory&)>;

// Gives all runs the same verdict. `describe` gives the value and measures of one run. If a run cannot be judged, or
// all close in the same time, no run gets a verdict.
std::vector<FindingCase> joint_verdict(const Runs& runs, const std::function<Verdict()>& judge,
                                       const CaseOf& describe) {
  const auto closing_end = [](const RunHistory& run) { return run.closing_end(); };
  const auto complete = [](const RunHistory& run) { return missing_closing(run).empty(); };
  const auto has_diverged = [](const RunHistory& run) { return !run.divergence().empty(); };
  const auto touches = [](const RunHistory& run) { return run.first_contact().has_value(); };
  const auto [least, most] = std::ranges::minmax_element(runs, {}, closing_end);
  Verdict all = Verdict::unknown;
  if (std::ranges::all_of(runs, complete) && std::ranges::none_of(runs, has_diverged) && !runs.empty() &&
      least->closing_end() < most->closing_end()) {
    all = std::ranges::all_of(runs, touches) ? judge() : Verdict::no;
  }
  std::vector<FindingCase> cases;
  for (const RunHistory& run : runs) {
    const std::string missing = missing_closing(run);
    FindingCase found = !missing.empty()       ? not_known(run, missing)
                        : !run.first_contact() ? verdict(run, false, "no contact")
                                               : describe(run);
    found.verdict = all;
    cases.push_back(std::move(found));
  }
  return cases;
}

// Groups draws by closing time. Equal values are one draw that was recorded twice.
std::vector<Draws> peaks_by_closing(const Runs& runs) {
  std::map<double, std::set<double>> values;
  for (const RunHistory& run : runs) values[run.closing_end()].insert(peak_y(run, run.all()));
  std::vector<Draws> groups;
  for (const auto& [closing_end, peaks] : values) groups.push_back({closing_end, {peaks.begin(), peaks.end()}});
  return groups;
}

std::vector<FindingCase> faster_is_harder(const Runs& runs) {
  std::string ensemble = kOneDraw;
  const auto judge = [&] {
    const OrderOfDraws order = order_of_draws(peaks_by_closing(runs), "N");
    ensemble = order.text;
    return order.verdict;
  };
  const auto describe = [&](const RunHistory& run) {
    const double peak = peak_y(run, run.all());
    std::string value = fmt::format("closing ends at {:.4g} s: peak |F_y| {:.3g} N", run.closing_end(), peak);
    // The text on all draws is shown once, with the first run.
    if (ensemble == kOneDraw || &run == &runs.front()) value += "; " + ensemble;
    return verdict(run, false, std::move(value), {{"peak |F_y|", "N", peak}});
  };
  std::vector<FindingCase> cases = joint_verdict(runs, judge, describe);
  // A single run is undecided, as three single ones are, and not unknown.
  if (runs.size() == 1 && !cases.front().measures.empty()) cases.front().verdict = Verdict::undecided;
  return cases;
}

std::vector<FindingCase> faster_is_earlier(const Runs& runs) {
  const auto contact = [](const RunHistory& run) { return *run.first_contact(); };
  return joint_verdict(
      runs, [&] { return is_monotone(runs, contact, true) ? Verdict::yes : Verdict::no; },
      [&](const RunHistory& run) {
        return verdict(
            run, false,
            fmt::format("closing ends at {:.4g} s: first contact at {:.4g} s", run.closing_end(), contact(run)),
            {{"first contact", "s", contact(run)}});
      });
}

// The lesser of the peaks |F_x| and |F_z|. If both should appear, it is the critical one.
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
    const bool holds =
        std::all_of(runs.begin(), runs.end(), appear_only_after_closing) && most < kEqualWithinFactor * least;
    return holds ? Verdict::yes : Verdict::no;
  };
  return joint_verdict(runs, judge, [](const RunHistory& run) {
    const FrameRange after = run.after_closed();
    const double before = run.lateral_peak(run.until_closed());
    const double x = std::abs(run.peak(Channel::contact_fx, after).value);
    const double z = std::abs(run.peak(Channel::contact_fz, after).value);
    return verdict(
        run, false,
        fmt::format("largest of |F_x|, |F_z|: {:.3g} N before closing ends; |F_x| {:.3g} N, |F_z| {:.3g} N "
                    "after; peak |F_y| {:.3g} N",
                    before, x, z, peak_y(run, run.all())),
        {{"lateral force before closing ends", "N", before}, {"|F_x| after", "N", x}, {"|F_z| after", "N", z}});
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
       "the peak |F_y| of a run depends on round-off, so that single runs decide nothing: of 2 draws or more for each "
       "closing time (16 in the study), made with solver.perturbation and different seeds, the mean of log peak |F_y| "
       "falls with the closing time, yes when all intervals of the differences between closing times lie on that side, "
       "no when one lies on the other (Welch's t intervals, together 95 %); one verdict for all",
       faster_is_harder},
      {"F4", "Faster closing gives an earlier first contact.",
       "over runs sorted by the end of closing, the first frame with contact comes strictly later; one verdict for all",
       faster_is_earlier},
      {"F5", "Forces in x and z appear only after closing; the closing time hardly changes them.",
       "|F_x| and |F_z| stay below 2 % of the run's peak |F_y| until closing ends and both exceed it afterwards, and "
       "the larger peaks after closing differ by less than a factor 2 between the runs; one verdict for all",
       lateral_forces_come_late},
      {"F6", "The force in y is negative, then positive, then negative while closing (case 1).",
       "a push down by the mouth, a push up by the cone near the spacecraft, a stop by the mouth: the first three "
       "pushes "
       "before closing ends, each with a quarter or more of the largest impulse (smaller ones between two pushes are "
       "merged into them), are -, +, -, and more than half of each acts where it should; the mouth is rods, net and "
       "ropes "
       "above the kink row, the cone those below it, where they are at the start; the impulse between two frames goes "
       "to "
       "them as the forces of their contact points in its direction at the two frames, or at the nearest within 0.1 s "
       "that "
       "have any",
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
  const auto labels = run_labels(recordings);
  for (std::size_t i = 0; i < recordings.size(); ++i) runs.emplace_back(*recordings[i], labels[i]);
  std::vector<Finding> findings;
  for (const Statement& s : statements()) {
    Finding finding{s.id, s.text, s.rule, s.judge(runs)};
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (std::string why = runs[i].divergence(); !why.empty()) finding.cases[i] = diverged(runs[i], std::move(why));
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace netpocket
