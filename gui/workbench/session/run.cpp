#include "gui/workbench/session/run.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/workbench/control/disturbance_words.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

struct MarkWords {
  Q_DECLARE_TR_FUNCTIONS(TimeMark)
};

std::optional<double> first_contact(const RunSeries& series) {
  const auto& contacts = series.channel(Channel::contact_count);
  const auto found = std::ranges::find_if(contacts, [](double count) { return count > 0; });
  if (found == contacts.end()) return std::nullopt;
  return series.times()[static_cast<std::size_t>(found - contacts.begin())];
}

struct Peak {
  double time = 0;
  double force = 0;
};

Peak peak_force(const RunSeries& series) {
  Peak peak;
  const auto &x = series.channel(Channel::contact_fx), &y = series.channel(Channel::contact_fy),
             &z = series.channel(Channel::contact_fz);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double force = std::hypot(x[i], y[i], z[i]);
    if (force > peak.force) peak = {series.times()[i], force};
  }
  return peak;
}

}  // namespace

std::size_t Run::frame_at(double time) const {
  const auto& times = series.times();
  const auto later = std::ranges::lower_bound(times, time);
  if (later == times.begin()) return 0;
  const auto index = static_cast<std::size_t>(later - times.begin());
  if (later == times.end()) return index - 1;
  return *later - time < time - times[index - 1] ? index : index - 1;
}

bool Run::can_go_on() const {
  constexpr double kRounding = 1e-6;  // s
  if (status.reason == RunReason::diverged || status.reason == RunReason::limited) return false;
  if (state == RunState::paused || state == RunState::running) return true;
  return end_time() < scenario.output.end_time - kRounding;
}

namespace {

QString capitalised(const std::string& name) {
  QString text = engine_words(name);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

std::vector<TimeMark> time_marks(const Run& run) {
  using Kind = TimeMark::Kind;
  std::vector<TimeMark> marks = run.notes;
  if (const auto time = first_contact(run.series))
    marks.push_back({Kind::first_contact, *time, MarkWords::tr("First contact")});
  if (const Peak peak = peak_force(run.series); peak.force > 0) {
    marks.push_back(
        {Kind::peak_force, peak.time, MarkWords::tr("Peak contact force, %1 N").arg(peak.force, 0, 'g', 3)});
  }
  for (const DisturbanceParameters& disturbance : run.scenario.disturbances) {
    marks.push_back(
        {Kind::disturbance, disturbance.start, MarkWords::tr("Disturbance: %1").arg(disturbance_words(disturbance))});
  }
  for (const Phase& phase : run.series.phases) {
    if (phase.at_rest) continue;
    const QString name = capitalised(phase.name);
    if (phase.begin > 0) marks.push_back({Kind::phase_start, phase.begin, MarkWords::tr("%1 starts").arg(name)});
    if (std::isfinite(phase.end)) marks.push_back({Kind::phase_end, phase.end, MarkWords::tr("%1 ends").arg(name)});
  }
  std::ranges::stable_sort(marks, {}, &TimeMark::time);
  return marks;
}

}  // namespace netpocket
