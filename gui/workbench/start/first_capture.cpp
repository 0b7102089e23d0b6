#include "gui/workbench/start/first_capture.h"

#include <QAccessible>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gui/workbench/editor/edit_command.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

constexpr double kTurned = 5 * std::numbers::pi / 180;  // rad, that count as another side
constexpr int kSteps = static_cast<int>(GuideStep::end);

struct StepWords {
  QString name;  // in the trail
  QString title;
  QString text;
};

StepWords words_of(GuideStep step) {
  switch (step) {
    case GuideStep::look:
      return {FirstCapture::tr("Look"), FirstCapture::tr("Look at the pocket"),
              FirstCapture::tr("Drag in the view with the left mouse button, or press the arrow keys there, to see the "
                               "pocket from another side. The wheel comes nearer; F shows everything again.")};
    case GuideStep::change:
      return {FirstCapture::tr("Change"), FirstCapture::tr("Change one number"),
              FirstCapture::tr("Change a value of the scenario, such as the duration of the closing, and press Enter. "
                               "Tool tips say what a value is; Ctrl+Z takes the change back.")};
    case GuideStep::run:
      return {FirstCapture::tr("Run"), FirstCapture::tr("Run the simulation"),
              FirstCapture::tr("Press the space bar, or the first button with a triangle. This step is done when the "
                               "pocket touches the target; the run goes on.")};
    case GuideStep::scrub:
      return {FirstCapture::tr("Scrub"), FirstCapture::tr("Go back in time"),
              FirstCapture::tr("Drag in the strip of time below the view, or press the comma key: the recorded moments "
                               "are shown, also while the simulation goes on.")};
    case GuideStep::force:
      return {FirstCapture::tr("Force"), FirstCapture::tr("Look at the force"),
              FirstCapture::tr("Choose “Contact force on the target” in the plots and go to another moment: click in "
                               "the curve, or step through time. View and plot show the same moment.")};
    case GuideStep::picture:
      return {FirstCapture::tr("Picture"), FirstCapture::tr("Export a picture"),
              FirstCapture::tr("Press Ctrl+E, choose what is to be written and where to, and press Export. The status "
                               "bar says when it is done.")};
    case GuideStep::end:
      break;
  }
  return {
      {},
      FirstCapture::tr("That was a capture"),
      FirstCapture::tr("Change what you like and run again: the panel Runs keeps all of them and draws one over the "
                       "other. F1 shows all keys.")};
}

}  // namespace

FirstCapture::FirstCapture(const GuidedParts& parts, QWidget* parent)
    : QFrame(parent),
      parts_(parts),
      title_(new QLabel),
      text_(new QLabel),
      trail_(new QLabel),
      show_(new QPushButton(tr("Show me"))),
      skip_(new QPushButton(tr("Skip"))),
      leave_(new QPushButton(tr("Leave"))) {
  setAccessibleName(tr("Guided first capture"));
  setAutoFillBackground(true);
  make_layout();
  connect(show_, &QPushButton::clicked, this, [this] { emit place_wanted(step_); });
  connect(skip_, &QPushButton::clicked, this, [this] { go_to(static_cast<GuideStep>(static_cast<int>(step_) + 1)); });
  connect(leave_, &QPushButton::clicked, this, &FirstCapture::leave);
  watch();
  set_colours();
  hide();
}

void FirstCapture::make_layout() {
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  text_->setWordWrap(true);
  trail_->setWordWrap(true);
  show_->setToolTip(tr("Go to where this step is done"));
  skip_->setToolTip(tr("Go on with the next step"));
  leave_->setToolTip(tr("Close the guide; the menu Help brings it back"));
  auto* texts = new QVBoxLayout;
  texts->setSpacing(3);
  for (QLabel* label : {title_, text_, trail_}) texts->addWidget(label);
  auto* buttons = new QVBoxLayout;
  buttons->setSpacing(3);
  for (QPushButton* button : {show_, skip_, leave_}) buttons->addWidget(button);
  buttons->addStretch();
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 6, 6, 6);
  layout->addLayout(texts, 1);
  layout->addLayout(buttons);
}

void FirstCapture::watch() {
  auto& runs = parts_.session.runs();
  connect(&parts_.viewport, &Viewport::view_changed, this, &FirstCapture::check);
  connect(&parts_.document, &ScenarioDocument::changed, this, &FirstCapture::check);
  connect(&runs, &RunLibrary::frames_added, this, &FirstCapture::check);
  connect(&runs, &RunLibrary::run_changed, this, &FirstCapture::check);
  connect(&parts_.session, &CaptureSession::frame_shown, this, &FirstCapture::check);
  const auto exported = [this] {
    exported_ = true;
    check();
  };
  connect(&parts_.exports, &ExportTray::finished, this, exported);
  connect(&parts_.plots, &PlotsPanel::exported, this, exported);
}

void FirstCapture::begin() {
  go_to(GuideStep::look);
  show();
}

void FirstCapture::check() {
  if (isHidden() || !is_done()) return;
  go_to(static_cast<GuideStep>(static_cast<int>(step_) + 1));
}

bool FirstCapture::has_turned() const {
  const CameraView& view = parts_.viewport.view();
  const double cosine = (view.focal_point - view.position).normalized().dot(start_.direction);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) > kTurned;
}

// To the first touch, or to an end without one.
bool FirstCapture::has_run() const {
  const Run* run = parts_.session.current();
  if (run == nullptr || !run->simulated_here || run->frame_count() < 2) return false;
  const auto touches = [](const TimeMark& mark) { return mark.kind == TimeMark::Kind::first_contact; };
  return !run->can_go_on() || std::ranges::any_of(time_marks(*run), touches);
}

bool FirstCapture::is_done() const {
  const Run* run = parts_.session.current();
  const bool moved = run != nullptr && !parts_.session.follows() && parts_.session.shown_index() != start_.frame;
  switch (step_) {
    case GuideStep::look:
      return has_turned();
    case GuideStep::change:
      return parts_.document.diagnostics().ok() &&
             !differing_keys(parts_.document.scenario(), start_.scenario).isEmpty();
    case GuideStep::run:
      return has_run();
    case GuideStep::scrub:
      return moved && parts_.session.shown_index() + 1 < run->frame_count();
    case GuideStep::force:
      return moved && parts_.plots.figure_name() == "figure05_force" && !parts_.plots.visibleRegion().isEmpty();
    case GuideStep::picture:
      return exported_;
    case GuideStep::end:
      break;
  }
  return false;
}

void FirstCapture::go_to(GuideStep step) {
  step_ = std::min(step, GuideStep::end);
  const CameraView& view = parts_.viewport.view();
  start_ = {(view.focal_point - view.position).normalized(), parts_.document.scenario(), parts_.session.shown_index()};
  exported_ = false;
  show_step();
}

void FirstCapture::show_step() {
  const StepWords words = words_of(step_);
  const bool at_end = step_ == GuideStep::end;
  title_->setText(at_end ? words.title
                         : tr("Step %1 of %2: %3").arg(static_cast<int>(step_) + 1).arg(kSteps).arg(words.title));
  text_->setText(words.text);
  QStringList trail;
  for (int i = 0; i < kSteps; ++i) {
    const QString sign = i < static_cast<int>(step_) ? "✓" : i == static_cast<int>(step_) ? "●" : "○";
    trail << sign + QChar(QChar::Nbsp) + words_of(static_cast<GuideStep>(i)).name;
  }
  trail_->setText(trail.join("   "));
  show_->setVisible(!at_end);
  skip_->setVisible(!at_end);
  leave_->setText(at_end ? tr("Close") : tr("Leave"));
  setAccessibleDescription(text());
  QAccessibleEvent event(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

QString FirstCapture::text() const { return title_->text() + ". " + text_->text(); }

void FirstCapture::set_colours() {
  const QPalette inherited = parentWidget() != nullptr ? parentWidget()->palette() : QApplication::palette();
  const QColor ground = ground_colour(Tone::accent, inherited);
  if (palette().color(QPalette::Window) == ground) return;
  QPalette own;
  own.setColor(QPalette::Window, ground);
  setPalette(own);
}

void FirstCapture::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ParentChange || event->type() == QEvent::PaletteChange) set_colours();
  QFrame::changeEvent(event);
}

}  // namespace netpocket
