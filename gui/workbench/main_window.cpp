#include "gui/workbench/main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QKeyEvent>
#include <QSplitter>
#include <algorithm>
#include <utility>

#include "gui/workbench/campaign/campaign_actions.h"
#include "gui/workbench/control/control_actions.h"
#include "gui/workbench/control/control_panel.h"
#include "gui/workbench/dialogs/preferences_dialog.h"
#include "gui/workbench/edit_actions.h"
#include "gui/workbench/editor/edit_command.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/filming/film_actions.h"
#include "gui/workbench/findings_updater.h"
#include "gui/workbench/lost_runs_bar.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/picked_plot.h"
#include "gui/workbench/placement_actions.h"
#include "gui/workbench/presentation/headline.h"
#include "gui/workbench/presentation/presentation.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/run_status_bar.h"
#include "gui/workbench/runs_panel.h"
#include "gui/workbench/second_view.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

constexpr int kLayoutVersion = 1;
constexpr const char* kGeometryKey = "window/geometry";
constexpr const char* kLayoutKey = "window/layout";

std::unique_ptr<QSettings> make_settings(const QString& file) {
  if (file.isEmpty()) return std::make_unique<QSettings>("netpocket", "workbench");
  return std::make_unique<QSettings>(file, QSettings::IniFormat);
}

QString recovery_folder(const WindowOptions& options) {
  return options.recovery_folder.isEmpty() ? default_recovery_folder() : options.recovery_folder;
}

// Next to the unsaved scenarios: unsaved runs.
QString run_folder(const WindowOptions& options) { return recovery_folder(options) + "/runs"; }

SessionOptions session_options(const WindowOptions& options, const Preferences& preferences) {
  SessionOptions session{options.origin, preferences.cache_bytes(), run_folder(options)};
  session.origin.threads = options.threads.value_or(preferences.threads);
  return session;
}

void use_look(const Preferences& preferences) {
  use_theme(preferences.theme);
  use_type_size(preferences.type_size);
}

}  // namespace

MainWindow::MainWindow(const WindowOptions& options)
    : settings_(make_settings(options.settings_file)),
      session_(std::make_unique<CaptureSession>(session_options(options, read_preferences(*settings_)))),
      document_(std::make_unique<ScenarioDocument>(recovery_folder(options))),
      preview_(std::make_unique<PreviewBuilder>()),
      presenter_(options.presenter.value_or(read_preferences(*settings_).presenter)) {
  use_look(read_preferences(*settings_));
  setAcceptDrops(true);
  QApplication::instance()->installEventFilter(this);
  setDockNestingEnabled(true);
  setCentralWidget(make_center(run_folder(options)));
  make_docks();
  status_ = new RunStatusBar;
  setStatusBar(status_);
  exports_ = new ExportTray;
  status_->addWidget(exports_);
  make_filming();
  make_presentation();
  make_menus(options);
  make_start();
  connect_document();
  connect_session();
  connect_panels();
  restore_layout();
  run_changed();
  update_title();
  preview_->build(document_->scenario());
  editor_->offer_recovery();
}

MainWindow::~MainWindow() {
  // What is still under way must not reach a window that is half gone.
  findings_updater_.reset();
  preview_.reset();
  session_->disconnect(this);
  document_->disconnect(this);
  delete takeCentralWidget();
  for (auto* dock : findChildren<QDockWidget*>()) delete dock;
}

void MainWindow::connect_document() {
  connect(document_.get(), &ScenarioDocument::modified_changed, this, &MainWindow::update_title);
  connect(document_.get(), &ScenarioDocument::path_changed, this, &MainWindow::update_title);
  connect(document_.get(), &ScenarioDocument::changed, this, [this] { preview_->build(document_->scenario()); });
  connect(document_.get(), &ScenarioDocument::changed, this, &MainWindow::withdraw_scenario_notice);
  connect(editor_->text_page(), &TextPage::problem_changed, this, &MainWindow::text_problem_changed);
  connect(editor_, &ScenarioEditor::preview, preview_.get(), &PreviewBuilder::build);
  connect(editor_, &ScenarioEditor::strategy_edited, this,
          [this] { session_->change_strategy(document_->scenario()); });
  connect(editor_, &ScenarioEditor::restart_requested, run_actions_, &RunActions::restart);
  connect(preview_.get(), &PreviewBuilder::built, this, &MainWindow::show_preview);
  connect(edit_actions_, &EditActions::problem, this, &MainWindow::show_notice);
  connect(edit_actions_, &EditActions::told, this, [this](const QString& text) { status_->showMessage(text, 10000); });
  connect(edit_actions_, &EditActions::key_chosen, this, [this](const QString& key) {
    bring_up("scenario");
    editor_->reveal(key);
  });
  connect(file_actions_, &FileActions::open_requested, this, &MainWindow::open);
  connect(file_actions_, &FileActions::problem, this, &MainWindow::show_notice);
  new PlacementActions(*viewport_, *document_, this);
}

void MainWindow::connect_session() {
  auto& runs = session_->runs();
  // A preview that was asked for before comes too late to take its place.
  connect(session_.get(), &CaptureSession::frame_wanted, preview_.get(), &PreviewBuilder::forget);
  connect(session_.get(), &CaptureSession::frame_shown, this, &MainWindow::show_frame);
  connect(session_.get(), &CaptureSession::current_changed, this, &MainWindow::run_changed);
  connect(session_.get(), &CaptureSession::failed, this, &MainWindow::show_notice);
  connect(session_.get(), &CaptureSession::run_diverged, this, &MainWindow::show_notice);
  connect(session_.get(), &CaptureSession::strategy_answered, this, &MainWindow::strategy_answered);
  connect(&runs, &RunLibrary::run_changed, this, &MainWindow::run_changed);
  connect(&runs, &RunLibrary::frames_added, findings_updater_.get(), &FindingsUpdater::request);
  connect(&runs, &RunLibrary::frames_added, this, [this](RunId id) {
    std::vector<double> values;
    for (const std::vector<double>& channel : session_->runs().find(id)->series.channels) {
      values.push_back(channel.back());
    }
    plots_->append(plotted(id), values);
  });
  // Known once the run has begun, and other ones with its strategy.
  connect(&runs, &RunLibrary::run_changed, this, [this](RunId id) {
    const Run* run = session_->runs().find(id);
    if (run != nullptr) plots_->describe(plotted(id), run->series);
  });
  connect(&runs, &RunLibrary::run_added, this, [this](RunId id) {
    const Run* run = session_->runs().find(id);
    if (run->simulated_here) return;
    if (!document_->is_modified()) document_->start_from(run->scenario);
    to_be_framed_ = id;
    session_->show_run(id);
  });
}

void MainWindow::connect_panels() {
  picked_plot_ = new PickedPlot(*session_, *plots_, this);
  connect(exports_, &ExportTray::failed, this, &MainWindow::show_notice);
  connect(exports_, &ExportTray::finished, this,
          [this](const QString& result) { status_->showMessage(tr("Exported %1").arg(result), 10000); });
  connect(exports_, &ExportTray::cancelled, this,
          [this](const QString& label) { status_->showMessage(tr("Export cancelled: %1").arg(label), 10000); });
  connect(&session_->runs(), &RunLibrary::saved, this,
          [this](const QString& path) { status_->showMessage(tr("Saved %1").arg(path), 10000); });
  connect(plots_, &PlotsPanel::time_clicked, timeline_, &TimelineBar::go_to);
  connect(plots_, &PlotsPanel::export_failed, this, &MainWindow::show_notice);
  connect(findings_, &FindingsPanel::export_failed, this, &MainWindow::show_notice);
  connect(viewport_, &Viewport::plot_requested, this,
          [this](const Pick& pick) { plot_pick(session_->current() ? session_->current()->id : -1, pick); });
  connect(view_actions_, &ViewActions::moving_toggled, this, &MainWindow::set_moving);
  connect(view_actions_, &ViewActions::second_view_toggled, this, &MainWindow::show_second_view);
  connect(view_actions_, &ViewActions::options_changed, this, [this](const SceneOptions& options) {
    const Run* run = session_->current();
    const bool shown = run != nullptr && run->structure && viewport_->state().structure == run->structure;
    if (shown) viewport_->set_history(history_.of(*run, options));
  });
  connect(campaign_actions_, &CampaignActions::panel_wanted, this, [this] { bring_up("campaign"); });
  connect(campaign_actions_, &CampaignActions::scenario_adopted, this, [this] { bring_up("scenario"); });
  connect(control_actions_, &ControlActions::problem, this, &MainWindow::show_notice);
  connect(control_actions_, &ControlActions::comparison_begun, this, &MainWindow::show_comparison);
  connect(control_, &ControlPanel::loops_appeared, this, &MainWindow::offer_control);
  connect(control_, &ControlPanel::loop_chosen, plots_, &PlotsPanel::set_loop);
  connect(run_files_, &RunFileActions::problem, this, &MainWindow::show_notice);
  connect(run_files_, &RunFileActions::file_used, file_actions_, &FileActions::note_recent);
  connect(run_files_, &RunFileActions::close_window, this, &QWidget::close);
  connect(runs_panel_, &RunsPanel::compared_changed, this, &MainWindow::update_plots);
  connect(runs_panel_, &RunsPanel::remove_requested, this, [this](RunId id) {
    if (!read_preferences(*settings_).ask_about_runs || run_files_->may_remove(id)) session_->remove_run(id);
  });
  connect(findings_updater_.get(), &FindingsUpdater::evaluated, this, [this](const FindingsResult& result) {
    findings_->set_findings(result.findings, result.running);
    const bool known = !result.findings.empty();
    // A run that goes on may still capture the target.
    const bool open = !known || (result.running && result.captured != Verdict::yes);
    const Verdict captured = open ? Verdict::unknown : result.captured;
    findings_->set_capture(captured, QString::fromStdString(known ? result.why_not : result.failure));
    headline_->set_capture(captured);
  });
}

void MainWindow::restore_layout() {
  resize(1280, 800);
  restoreGeometry(settings_->value(kGeometryKey).toByteArray());
  restoreState(settings_->value(kLayoutKey).toByteArray(), kLayoutVersion);
}

QString MainWindow::notice() const { return notice_->isHidden() ? QString() : notice_->text(); }

void MainWindow::show_notice(const QString& text) {
  scenario_notice_ = false;
  if (!text.isEmpty()) start_page_->close_page();  // which would cover it
  // The libraries' sentences go on after "netpocket: ", here they begin.
  const QString words = engine_words(text);
  notice_->show_text(words.startsWith("cannot ") ? "C" + words.mid(1) : words);
}

void MainWindow::show_scenario_notice(const QString& text) {
  show_notice(text);
  scenario_notice_ = true;
}

void MainWindow::withdraw_scenario_notice() {
  const bool sound = !editor_->text_page()->has_problem() && document_->diagnostics().ok();
  if (scenario_notice_ && sound) show_notice({});
}

void MainWindow::ask_for_preferences() {
  PreferencesDialog dialog(read_preferences(*settings_), session_->runs().cache_bytes(), this);
  if (dialog.exec() == QDialog::Accepted) apply_preferences(dialog.preferences());
}

void MainWindow::apply_preferences(const Preferences& preferences) {
  write_preferences(preferences, *settings_);
  use_look(preferences);
  session_->runs().set_cache_bytes(preferences.cache_bytes());
  session_->set_threads(preferences.threads);
}

std::optional<Scenario> MainWindow::scenario_to_run() {
  if (!commit_text()) return std::nullopt;
  const Diagnostics& problems = document_->diagnostics();
  if (!problems.ok()) {
    const Diagnostic& first = problems.list().front();
    show_scenario_notice(tr("This scenario cannot be simulated: %1").arg(diagnostic_words(first)));
    editor_->reveal(QString::fromStdString(first.key));
    return std::nullopt;
  }
  show_notice({});
  return document_->scenario();
}

void MainWindow::show_preview(const PocketPreview& preview) {
  // While a run goes on it is shown, whatever is edited.
  if (session_->is_running()) return;
  // Nor does one of before the start, that came late, take the place of what the run has come to.
  const Run* run = session_->current();
  const bool shown = run != nullptr && viewport_->state().structure == run->structure;
  if (shown && !view_actions_->move_action()->isChecked()) {
    Scenario edited = document_->scenario();
    edited.disturbances = run->scenario.disturbances;  // a run has those of its clicks, too
    if (differing_keys(run->scenario, edited).isEmpty()) return;
  }
  view_actions_->set_phases({});
  end_of_nothing();
  if (session_->current()) viewport_->set_hint(tr("Edited scenario, not simulated yet"));
  viewport_->set_history(nullptr);
  viewport_->set_pocket(preview.structure, preview.snapshot);
  // What the run does stays in sight as long as its loops are those of the scenario.
  if (run == nullptr || !run->structure || run->structure->loops != preview.structure->loops) {
    control_->show_frame(preview.structure, nullptr);
  }
  if (second_view_) second_view_->refresh();
}

void MainWindow::show_frame(const std::shared_ptr<const Snapshot>& snapshot) {
  const Run* run = session_->current();
  if (run == nullptr) return;
  // What is moved is the start of a capture, not a recorded moment of one.
  view_actions_->move_action()->setChecked(false);
  end_of_nothing();
  if (!viewport_->is_measuring()) viewport_->set_hint({});
  view_actions_->set_phases(run->series.phases);
  viewport_->set_pocket(run->structure, snapshot);
  viewport_->set_history(history_.of(*run, view_actions_->options()));
  // Of another size than what was there, but for a camera that somebody has turned to see something.
  if (run->id == std::exchange(to_be_framed_, -1) && viewport_->preset()) viewport_->set_preset(*viewport_->preset());
  if (second_view_) second_view_->refresh();
  plots_->set_time(snapshot->time);
  control_->show_frame(run->structure, snapshot);
  show_numbers();
}

void MainWindow::show_numbers() {
  const Run* run = session_->current();
  status_->show_run(run, session_->shown_index());
  headline_->show_run(run, session_->shown_index(), document_->display_name());
}

void MainWindow::set_moving(bool moving) {
  if (moving && session_->is_running()) {
    show_notice(tr("While a run goes on its pocket is shown: pause it to move the bodies."));
    view_actions_->move_action()->setChecked(false);
    return;
  }
  if (moving) preview_->build(document_->scenario());
  viewport_->set_moving(moving);
}

void MainWindow::show_second_view(bool shown) {
  if (second_view_ == nullptr) {
    second_view_ = new SecondView(*session_, *viewport_, presenter_);
    second_view_->set_options(view_actions_->options());
    connect(view_actions_, &ViewActions::options_changed, second_view_, &SecondView::set_options);
    connect(second_view_, &SecondView::plot_requested, this, &MainWindow::plot_pick);
    views_->addWidget(second_view_);
  }
  second_view_->setVisible(shown);
  if (shown) views_->setSizes({1, 1});
}

void MainWindow::bring_up(const char* dock) {
  auto* widget = findChild<QDockWidget*>(dock);
  widget->show();
  if (isVisible()) {
    widget->raise();
  } else {
    raised_ = widget;
  }
}

// Tabs come up only in a window that is shown and laid out; raised a second time they would not.
void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (QWidget* dock = std::exchange(raised_, nullptr)) {
    QMetaObject::invokeMethod(dock, &QWidget::raise, Qt::QueuedConnection);
  }
}

// Behind the scenario, which stays in front.
void MainWindow::offer_control() {
  auto *scenario = findChild<QDockWidget*>("scenario"), *control = findChild<QDockWidget*>("control");
  if (control->isVisible()) return;
  control->show();
  if (scenario->isVisible()) scenario->raise();
}

void MainWindow::show_comparison(RunId with_loop) {
  runs_panel_->compare_with(with_loop);
  update_plots();
  plots_->show_figure("control_loops");
}

void MainWindow::plot_pick(RunId id, const Pick& pick) {
  if (!picked_plot_->plot(id, pick)) show_notice(tr("There is no run yet whose frames could be plotted."));
}

void MainWindow::run_changed() {
  const Run* run = session_->current();
  show_numbers();
  editor_->set_running(session_->live() ? &session_->live()->scenario : nullptr);
  control_->set_running(session_->live() ? &session_->live()->scenario : nullptr);
  findings_updater_->request();
  if (run == nullptr) plots_->set_time(std::nullopt);
}

std::size_t MainWindow::plotted(RunId id) const {
  const auto compared = runs_panel_->compared();
  return static_cast<std::size_t>(std::ranges::find(compared, id) - compared.begin());
}

void MainWindow::update_plots() {
  std::vector<RunSeries> series;
  for (const RunId id : runs_panel_->compared()) series.push_back(session_->runs().find(id)->series);
  plots_->set_series(std::move(series));
  findings_updater_->request();
}

void MainWindow::strategy_answered(RunId id, const Diagnostics& refused, double time) {
  if (!refused.ok()) return;  // the editor says what needs a restart
  if (const Run* run = session_->runs().find(id); run != nullptr && run->frame_count() > 1) {
    session_->runs().add_note(id, {TimeMark::Kind::strategy, time, tr("Strategy changed")});
  }
}

void MainWindow::update_title() {
  setWindowModified(document_->is_modified());
  setWindowTitle(tr("%1[*] – Netpocket").arg(document_->display_name()));
  show_numbers();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const bool keeps_runs = read_preferences(*settings_).ask_about_runs;
  if (!exports_->may_close() || !campaign_actions_->may_close() || !file_actions_->may_discard() ||
      (keeps_runs && !run_files_->may_close())) {
    event->ignore();
    return;
  }
  if (!film_actions_->may_close()) {
    event->ignore();
    return;
  }
  presentation_->set_on(false);
  settings_->setValue(kGeometryKey, saveGeometry());
  settings_->setValue(kLayoutKey, saveState(kLayoutVersion));
  event->accept();
}

// A focused button or list keeps the space bar, which runs and pauses everywhere else.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool uses_space = qobject_cast<QAbstractButton*>(watched) || qobject_cast<QAbstractItemView*>(watched) ||
                            qobject_cast<QComboBox*>(watched);
    if (uses_space && key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier) {
      event->accept();
      return true;
    }
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if ((event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) && view_actions_)
    view_actions_->follow_theme();
}

}  // namespace netpocket
