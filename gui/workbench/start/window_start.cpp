// How the window begins: its start page and the guided first capture.

#include <QBoxLayout>
#include <QDockWidget>
#include <QFileInfo>
#include <QSplitter>

#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/lost_runs_bar.h"
#include "gui/workbench/main_window.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/start/first_capture.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

constexpr const char* kGuidedScenario = "case1";
constexpr const char* kGuidedKey = "closing.duration";

}  // namespace

void MainWindow::make_start() {
  first_capture_ = new FirstCapture({*document_, *session_, *viewport_, *plots_, *exports_});
  // Below the messages, above the views.
  auto* layout = static_cast<QBoxLayout*>(centralWidget()->layout());
  layout->insertWidget(layout->indexOf(views_), first_capture_);
  connect(first_capture_, &FirstCapture::place_wanted, this, &MainWindow::show_guided_place);

  start_page_ = new StartPage(this);
  connect(start_page_, &StartPage::guide_chosen, this, &MainWindow::begin_first_capture);
  connect(start_page_, &StartPage::new_chosen, file_actions_, &FileActions::new_scenario);
  connect(start_page_, &StartPage::open_chosen, file_actions_, &FileActions::ask_to_open);
  connect(start_page_, &StartPage::file_chosen, this, &MainWindow::open);
  connect(start_page_, &StartPage::scenario_chosen, file_actions_, &FileActions::open_preset);
  // Whatever has been opened or begun is to be seen; so is what is wrong with it.
  connect(document_.get(), &ScenarioDocument::saved_changed, start_page_, &StartPage::close_page);
  connect(session_.get(), &CaptureSession::current_changed, start_page_, &StartPage::close_page);
  connect(start_page_, &StartPage::closed, viewport_, [this] { viewport_->setFocus(Qt::OtherFocusReason); });
}

void MainWindow::show_start_page() {
  start_page_->set_recent(file_actions_->recent());
  start_page_->open_page();
}

void MainWindow::begin() {
  const Beginning beginning = read_preferences(*settings_).beginning;
  const QString last = file_actions_->recent().value(0);
  if (beginning == Beginning::last_file && QFileInfo::exists(last)) {
    open(last);
  } else if (beginning != Beginning::empty) {
    show_start_page();
  }
}

bool MainWindow::offers_recovery() const { return !editor_->recovery_bar()->isHidden() || !lost_runs_->isHidden(); }

void MainWindow::begin_first_capture() {
  if (!file_actions_->open_preset(kGuidedScenario)) return;
  start_page_->close_page();
  first_capture_->begin();
}

void MainWindow::show_guided_place(GuideStep step) {
  const auto raise = [this](const char* name) {
    auto* dock = findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
  };
  switch (step) {
    case GuideStep::look:
    case GuideStep::run:
      viewport_->setFocus(Qt::ShortcutFocusReason);
      return;
    case GuideStep::change:
      raise("scenario");
      editor_->reveal(kGuidedKey);
      return;
    case GuideStep::scrub:
      timeline_->strip()->setFocus(Qt::ShortcutFocusReason);
      return;
    case GuideStep::force:
      raise("plots");
      plots_->show_figure("figure05_force");
      return;
    case GuideStep::picture:
      run_files_->ask_for_export();
      return;
    case GuideStep::end:
      return;
  }
}

}  // namespace netpocket
