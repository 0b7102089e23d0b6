#include "gui/workbench/run_status_bar.h"

#include <QEvent>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "engine/analysis/summary.h"
#include "engine/scenario/draft_bias.h"
#include "engine/scenario/fidelity.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

constexpr int kFieldMargin = 6;  // pixels

QString state_text(const Run& run) {
  switch (run.state) {
    case RunState::preparing:
      return RunStatusBar::tr("Preparing");
    case RunState::running:
      return RunStatusBar::tr("Running");
    case RunState::paused:
      return RunStatusBar::tr("Paused");
    case RunState::recorded:
      return RunStatusBar::tr("Recorded");
    case RunState::ended:
      break;
  }
  if (run.status.reason == RunReason::limited) return RunStatusBar::tr("At its limit of steps");
  return run.status.reason == RunReason::diverged ? RunStatusBar::tr("Diverged") : RunStatusBar::tr("Finished");
}

QString step_text(const RunStatistics& statistics, double step) {
  if (!(step > 0)) return {};
  const QString limit = engine_words(statistics.step_limit);
  if (step >= 1e-3) return RunStatusBar::tr("step %1 ms: %2").arg(1e3 * step, 0, 'f', 2).arg(limit);
  return RunStatusBar::tr("step %1 µs: %2").arg(1e6 * step, 0, 'f', 1).arg(limit);
}

// What a draft is worth; empty for a run of full fidelity.
QString draft_text(const Run& run) {
  if (run.scenario.solver.fidelity == Fidelity::full) return {};
  const MeasuredBias &captured = kDraftBias.probability, &impulse = kDraftBias.impulse;
  return RunStatusBar::tr("draft: capture %1 ± %2 points, impulse %3 ± %4 %")
      .arg(100 * captured.mean, 0, 'f', 1)
      .arg(100 * captured.half_width, 0, 'f', 1)
      .arg(100 * impulse.mean, 0, 'f', 1)
      .arg(100 * impulse.half_width, 0, 'f', 1);
}

// The error against the energy put in so far, if that is enough to compare with.
QString energy_text(const RunSeries& series, std::size_t frame) {
  const double input = std::max(std::abs(series.channel(Channel::energy_input)[frame]),
                                std::abs(series.channel(Channel::energy_kinetic)[frame]));
  const double error = series.channel(Channel::energy_error)[frame];
  if (!(input > kLeastComparableEnergy)) return RunStatusBar::tr("energy error %1 J").arg(error, 0, 'g', 2);
  const double percent = 100 * std::abs(error) / input;
  const QString number = percent < 10 ? QString::number(percent, 'g', 2) : QString::number(percent, 'f', 0);
  return RunStatusBar::tr("energy error %1 %").arg(number);
}

}  // namespace

RunStatusBar::RunStatusBar(QWidget* parent) : QStatusBar(parent) {
  setSizeGripEnabled(false);
  state_ = add_field(tr("What the run is doing"), tr("Preparing"));
  draft_ = add_field(QString(), QString());
  time_ = add_field(tr("Simulated time"), tr("t = %1 s").arg("000.000"));
  speed_ = add_field(tr("Speed of the simulation against real time"), tr("%1 × real time").arg("0.000"));
  step_ = add_field(tr("Integration step, and what limits it"), QString());
  contacts_ = add_field(tr("Contact points that touch the target"), tr("contacts: %1").arg("000"));
  energy_ =
      add_field(tr("Energy balance: its error against the energy put in"), tr("energy error %1 %").arg("0.0e-00"));
}

QLabel* RunStatusBar::add_field(const QString& help, const QString& widest) {
  auto* label = new QLabel;
  label->setToolTip(help);
  label->setContentsMargins(kFieldMargin, 0, kFieldMargin, 0);
  label->setMinimumWidth(fontMetrics().horizontalAdvance(widest) + 2 * kFieldMargin);
  addPermanentWidget(label);
  return label;
}

void RunStatusBar::show_run(const Run* run, std::size_t frame) {
  const bool any = run != nullptr && run->frame_count() > 0;
  state_->setText(run ? state_text(*run) : tr("No run"));
  diverged_ = run != nullptr && run->status.reason == RunReason::diverged;
  colour_state();
  draft_->setText(run ? draft_text(*run) : QString());
  draft_->setMinimumWidth(fontMetrics().horizontalAdvance(draft_->text()) + 2 * kFieldMargin);  // read whole
  draft_->setVisible(!draft_->text().isEmpty());
  draft_->setToolTip(run ? engine_words(draft_notice(run->scenario.solver.fidelity)) : QString());
  for (QLabel* label : {time_, speed_, step_, contacts_, energy_}) label->setVisible(any);
  if (!any) return;
  const std::size_t last = std::min(frame, run->frame_count() - 1);
  time_->setText(tr("t = %1 s").arg(run->series.times()[last], 0, 'f', 3));
  speed_->setVisible(run->speed > 0);
  speed_->setText(tr("%1 × real time").arg(run->speed, 0, 'g', 3));
  step_->setText(step_text(run->statistics, run->series.channel(Channel::time_step)[last]));
  step_->setVisible(!step_->text().isEmpty());
  const std::vector<double>& contacts = run->series.channel(Channel::contact_count);
  contacts_->setVisible(last < contacts.size());
  if (last < contacts.size()) contacts_->setText(tr("contacts: %1").arg(contacts[last]));
  energy_->setText(energy_text(run->series, last));
}

void RunStatusBar::colour_state() {
  QPalette own;
  if (diverged_) own.setColor(QPalette::WindowText, tone_colour(Tone::bad, palette()));
  state_->setPalette(own);
}

void RunStatusBar::changeEvent(QEvent* event) {
  QStatusBar::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour_state();
}

}  // namespace netpocket
