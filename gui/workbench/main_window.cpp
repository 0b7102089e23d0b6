#include "gui/workbench/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/workbench/dialogs/about_dialog.h"
#include "gui/workbench/dialogs/shortcut_sheet.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/export/export_dialog.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/findings_updater.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/picked_series.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/run_status_bar.h"
#include "gui/workbench/runs_panel.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

constexpr int kLayoutVersion = 1;
constexpr const char* kGeometryKey = "window/geometry";
constexpr const char* kLayoutKey = "window/layout";

bool is_recording(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == "h5" || suffix == "hdf5" || suffix == "part";
}

QString file_to_open(const QMimeData& data) {
  if (data.urls().size() != 1 || !data.urls().front().isLocalFile()) return {};
  const QString path = data.urls().front().toLocalFile();
  return is_recording(path) || QFileInfo(path).suffix().toLower() == "toml" ? path : QString();
}

}  // namespace

MainWindow::MainWindow(const WindowOptions& options)
    : settings_(options.settings_file.isEmpty()
                    ? std::make_unique<QSettings>("netpocket", "workbench")
                    : std::make_unique<QSettings>(options.settings_file, QSettings::IniFormat)),
      session_(std::make_unique<CaptureSession>(options.session)),
      document_(options.recovery_folder.isEmpty() ? std::make_unique<ScenarioDocument>()
                                                  : std::make_unique<ScenarioDocument>(options.recovery_folder)),
      preview_(std::make_unique<PreviewBuilder>()),
      program_(options.program) {
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  setCentralWidget(make_center(options.presenter));
  make_docks();
  status_ = new RunStatusBar;
  setStatusBar(status_);
  exports_ = new ExportTray;
  status_->addWidget(exports_);
  make_menus(options);
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
  delete takeCentralWidget();
  for (auto* dock : findChildren<QDockWidget*>()) delete dock;
}

QWidget* MainWindow::make_center(PresenterKind presenter) {
  auto* center = new QWidget;
  viewport_ = new Viewport(presenter);
  timeline_ = new TimelineBar(*session_);
  notice_bar_ = new QFrame;
  notice_bar_->setAutoFillBackground(true);
  notice_bar_->setBackgroundRole(QPalette::ToolTipBase);
  notice_bar_->setForegroundRole(QPalette::ToolTipText);
  notice_ = new QLabel;
  notice_->setWordWrap(true);
  notice_->setForegroundRole(QPalette::ToolTipText);
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton;
  close->setText(QString::fromUtf8("×"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  connect(close, &QToolButton::clicked, notice_bar_, &QWidget::hide);
  auto* bar = new QHBoxLayout(notice_bar_);
  bar->setContentsMargins(10, 4, 4, 4);
  bar->addWidget(notice_, 1);
  bar->addWidget(close);
  notice_bar_->hide();
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(notice_bar_);
  layout->addWidget(viewport_, 1);
  layout->addWidget(timeline_);
  return center;
}

void MainWindow::make_docks() {
  const auto add = [this](const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    return dock;
  };
  editor_ = new ScenarioEditor(document_.get());
  plots_ = new PlotsPanel;
  findings_ = new FindingsPanel;
  runs_panel_ = new RunsPanel(*session_);
  findings_updater_ = std::make_unique<FindingsUpdater>(*session_, [this] { return runs_panel_->compared(); });
  auto* scenario = add(tr("Scenario"), "scenario", editor_, Qt::LeftDockWidgetArea);
  auto* plots = add(tr("Plots"), "plots", plots_, Qt::RightDockWidgetArea);
  auto* findings = add(tr("Findings"), "findings", findings_, Qt::RightDockWidgetArea);
  auto* runs = add(tr("Runs"), "runs", runs_panel_, Qt::RightDockWidgetArea);
  tabifyDockWidget(findings, runs);
  findings->raise();
  resizeDocks({scenario, plots}, {330, 420}, Qt::Horizontal);
  resizeDocks({plots, findings}, {3, 2}, Qt::Vertical);
}

void MainWindow::make_menus(const WindowOptions& options) {
  auto* bar = addToolBar(tr("Toolbar"));
  bar->setObjectName("toolbar");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  auto* file = menuBar()->addMenu(tr("&File"));
  auto* edit = menuBar()->addMenu(tr("&Edit"));
  auto* run = menuBar()->addMenu(tr("&Run"));
  auto* time = menuBar()->addMenu(tr("&Time"));
  auto* view = menuBar()->addMenu(tr("&View"));
  auto* help = menuBar()->addMenu(tr("&Help"));
  for (QMenu* menu : {file, edit, run, time, view, help}) menu->setToolTipsVisible(true);

  file_actions_ = new FileActions(*document_, *settings_, this);
  file_actions_->fill(*file, *bar);
  file->addSeparator();
  file->addAction(tr("Save run as…"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S), this, &MainWindow::save_run)
      ->setStatusTip(tr("Save the shown run as a recording"));
  file->addAction(tr("&Export…"), QKeySequence(Qt::CTRL | Qt::Key_E), this, &MainWindow::ask_for_export)
      ->setStatusTip(tr("Pictures, video, figures, tables of the shown run"));
  file->addSeparator();
  auto* quit = file->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), this, &QWidget::close);
  quit->setMenuRole(QAction::QuitRole);

  auto* undo = document_->undo_stack()->createUndoAction(this, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  auto* redo = document_->undo_stack()->createRedoAction(this, tr("Redo"));
  redo->setShortcut(QKeySequence::Redo);
  edit->addActions({undo, redo});
  edit->addSeparator();
  edit->addAction(tr("Find parameter"), QKeySequence(QKeySequence::Find), editor_, &ScenarioEditor::focus_search);

  bar->addSeparator();
  run_actions_ = new RunActions(
      *session_, [this] { return scenario_to_run(); }, this);
  run_actions_->fill(*run, *bar);
  bar->addSeparator();
  view_actions_ = new ViewActions(*viewport_, *settings_, this);
  view_actions_->fill(*view, *bar);
  time->addActions(timeline_->playback_actions());

  view->addSeparator();
  auto* docks = view->addMenu(tr("Panels"));
  for (auto* dock : findChildren<QDockWidget*>()) docks->addAction(dock->toggleViewAction());
  auto* full = view->addAction(tr("Full screen"), QKeySequence(Qt::Key_F11), this,
                               [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setStatusTip(tr("Use the whole screen"));

  help->addAction(tr("Keyboard and mouse"), QKeySequence(Qt::Key_F1), this,
                  [this] { ShortcutSheet(*menuBar(), this).exec(); });
  help->addAction(tr("About Netpocket"), this, [this, about = options.about] {
    AboutDialog(about, viewport_->presenter_description(), this).exec();
  });
}

void MainWindow::connect_document() {
  connect(document_.get(), &ScenarioDocument::modified_changed, this, &MainWindow::update_title);
  connect(document_.get(), &ScenarioDocument::path_changed, this, &MainWindow::update_title);
  connect(document_.get(), &ScenarioDocument::changed, this, [this] { preview_->build(document_->scenario()); });
  connect(editor_, &ScenarioEditor::preview, preview_.get(), &PreviewBuilder::build);
  connect(editor_, &ScenarioEditor::strategy_edited, this,
          [this] { session_->change_strategy(document_->scenario()); });
  connect(editor_, &ScenarioEditor::restart_requested, run_actions_, &RunActions::restart);
  connect(preview_.get(), &PreviewBuilder::built, this, &MainWindow::show_preview);
  connect(file_actions_, &FileActions::open_requested, this, &MainWindow::open);
  connect(file_actions_, &FileActions::problem, this, &MainWindow::show_notice);
}

void MainWindow::connect_session() {
  auto& runs = session_->runs();
  connect(session_.get(), &CaptureSession::frame_shown, this, &MainWindow::show_frame);
  connect(session_.get(), &CaptureSession::current_changed, this, &MainWindow::run_changed);
  connect(session_.get(), &CaptureSession::failed, this, &MainWindow::show_notice);
  connect(session_.get(), &CaptureSession::run_diverged, this, &MainWindow::show_notice);
  connect(session_.get(), &CaptureSession::strategy_answered, this, &MainWindow::strategy_answered);
  connect(&runs, &RunLibrary::run_changed, this, &MainWindow::run_changed);
  connect(&runs, &RunLibrary::frames_added, findings_updater_.get(), &FindingsUpdater::request);
  connect(&runs, &RunLibrary::frames_added, this, [this](RunId id) {
    const auto compared = runs_panel_->compared();
    const auto place = std::find(compared.begin(), compared.end(), id);
    if (place == compared.end()) return;
    std::array<double, kChannelCount> values;
    const RunSeries& series = session_->runs().find(id)->series;
    for (std::size_t i = 0; i < kChannelCount; ++i) values[i] = series.channels[i].back();
    plots_->append(static_cast<std::size_t>(place - compared.begin()), values);
  });
  connect(&runs, &RunLibrary::run_added, this, [this](RunId id) {
    const Run* run = session_->runs().find(id);
    if (run->simulated_here) return;
    if (!document_->is_modified()) document_->start_from(run->scenario);
    session_->show_run(id);
  });
}

void MainWindow::connect_panels() {
  connect(exports_, &ExportTray::failed, this, &MainWindow::show_notice);
  connect(exports_, &ExportTray::finished, this,
          [this](const QString& result) { status_->showMessage(tr("Exported %1").arg(result), 10000); });
  connect(&session_->runs(), &RunLibrary::saved, this,
          [this](const QString& path) { status_->showMessage(tr("Saved %1").arg(path), 10000); });
  connect(plots_, &PlotsPanel::time_clicked, timeline_, &TimelineBar::go_to);
  connect(plots_, &PlotsPanel::export_failed, this, &MainWindow::show_notice);
  connect(findings_, &FindingsPanel::export_failed, this, &MainWindow::show_notice);
  connect(viewport_, &Viewport::plot_requested, this, &MainWindow::plot_pick);
  connect(runs_panel_, &RunsPanel::compared_changed, this, &MainWindow::update_plots);
  connect(findings_updater_.get(), &FindingsUpdater::evaluated, this, [this](const FindingsResult& result) {
    findings_->set_findings(result.findings, result.running);
    const bool known = !result.findings.empty();
    findings_->set_capture(!known            ? CaptureState::unknown
                           : result.captured ? CaptureState::captured
                                             : CaptureState::not_captured,
                           QString::fromStdString(known ? result.why_not : result.failure));
  });
}

void MainWindow::restore_layout() {
  resize(1280, 800);
  restoreGeometry(settings_->value(kGeometryKey).toByteArray());
  restoreState(settings_->value(kLayoutKey).toByteArray(), kLayoutVersion);
}

QString MainWindow::notice() const { return notice_bar_->isHidden() ? QString() : notice_->text(); }

void MainWindow::show_notice(const QString& text) {
  notice_->setText(text);
  notice_bar_->setHidden(text.isEmpty());
}

std::optional<Scenario> MainWindow::scenario_to_run() {
  if (!editor_->commit()) {
    show_notice(tr("The scenario's text has an error: see the editor."));
    return std::nullopt;
  }
  const Diagnostics& problems = document_->diagnostics();
  if (!problems.ok()) {
    const Diagnostic& first = problems.list().front();
    show_notice(tr("This scenario cannot be simulated: %1").arg(QString::fromStdString(first.text())));
    editor_->reveal(QString::fromStdString(first.key));
    return std::nullopt;
  }
  show_notice({});
  return document_->scenario();
}

void MainWindow::open(const QString& path) {
  show_notice({});
  if (is_recording(path)) {
    file_actions_->note_recent(path);
    session_->runs().open(path);
    return;
  }
  if (!file_actions_->may_discard()) return;
  const Diagnostics problems = document_->open(path);
  if (!problems.ok()) show_notice(QString::fromStdString(problems.text()));
}

void MainWindow::show_preview(const PocketPreview& preview) {
  // While a run goes on it is shown, whatever is edited.
  if (session_->is_running()) return;
  view_actions_->set_phases(std::nullopt);
  if (session_->current()) viewport_->set_hint(tr("Edited scenario, not simulated yet"));
  viewport_->set_pocket(preview.structure, preview.snapshot);
}

void MainWindow::show_frame(const std::shared_ptr<const Snapshot>& snapshot) {
  const Run* run = session_->current();
  if (run == nullptr) return;
  if (!viewport_->is_measuring()) viewport_->set_hint({});
  view_actions_->set_phases(phase_times(run->scenario));
  viewport_->set_pocket(run->structure, snapshot);
  plots_->set_time(snapshot->time);
  status_->show_run(run, session_->shown_index());
}

void MainWindow::plot_pick(const Pick& pick) {
  const Run* run = session_->current();
  if (run == nullptr || run->frame_count() == 0) {
    show_notice(tr("There is no run yet whose frames could be plotted."));
    return;
  }
  const auto quantities = quantities_of(pick);
  session_->runs().collect(
      run->id, [pick, structure = run->structure](const Snapshot& frame) { return values_of(pick, *structure, frame); },
      [this, quantities](const std::vector<double>& times, const std::vector<std::vector<double>>& rows) {
        plots_->set_picked(picked_panels(quantities, times, rows));
        plots_->show_figure("picked");
      });
}

void MainWindow::run_changed() {
  const Run* run = session_->current();
  status_->show_run(run, session_->shown_index());
  editor_->set_run_active(session_->live() != nullptr);
  findings_updater_->request();
  if (run == nullptr) plots_->set_time(std::nullopt);
}

void MainWindow::update_plots() {
  std::vector<RunSeries> series;
  for (const RunId id : runs_panel_->compared()) series.push_back(session_->runs().find(id)->series);
  plots_->set_series(std::move(series));
  findings_updater_->request();
}

void MainWindow::strategy_answered(const Diagnostics& refused, double time) {
  if (!refused.ok()) return;  // the editor says what needs a restart
  if (const Run* live = session_->live(); live != nullptr && live->frame_count() > 1) {
    session_->runs().add_note(live->id, {TimeMark::Kind::strategy, time, tr("Strategy changed")});
  }
}

void MainWindow::ask_for_export() {
  const Run* run = session_->current();
  if (run == nullptr || run->frame_count() == 0) {
    show_notice(tr("There is no run to export yet."));
    return;
  }
  const QString folder = QFileInfo(document_->path()).path();
  ExportDialog dialog(document_->path().isEmpty() ? QString() : folder, run->name, this);
  if (dialog.exec() != QDialog::Accepted) return;
  export_run([&dialog](const QString& recording) { return dialog.arguments(recording); }, dialog.label(),
             dialog.target());
}

void MainWindow::export_run(const std::function<QStringList(const QString& recording)>& arguments, const QString& label,
                            const QString& result) {
  const Run* run = session_->current();
  if (run == nullptr) return;
  const QStringList command = arguments(QString::fromStdString(run->file->path()));
  session_->runs().flush(run->id, [this, command, label, result](const QString&) {
    exports_->add(std::make_unique<ExportJob>(program_, command, label, result));
  });
}

void MainWindow::save_run() {
  const Run* run = session_->current();
  if (run == nullptr || run->frame_count() == 0) {
    show_notice(tr("There is no run to save yet."));
    return;
  }
  QString path = QFileDialog::getSaveFileName(this, tr("Save run"), run->name + ".h5", tr("Recordings (*.h5)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ".h5";
  file_actions_->note_recent(path);
  session_->runs().save(run->id, path);
}

void MainWindow::update_title() {
  setWindowModified(document_->is_modified());
  setWindowTitle(tr("%1[*] – Netpocket").arg(document_->display_name()));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!file_actions_->may_discard()) {
    event->ignore();
    return;
  }
  settings_->setValue(kGeometryKey, saveGeometry());
  settings_->setValue(kLayoutKey, saveState(kLayoutVersion));
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!file_to_open(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = file_to_open(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  open(path);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && view_actions_) view_actions_->follow_theme();
}

}  // namespace netpocket
