// How the window is put together: its parts, docks and menus.

#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>

#include "gui/workbench/campaign/campaign_actions.h"
#include "gui/workbench/control/control_actions.h"
#include "gui/workbench/control/control_panel.h"
#include "gui/workbench/dialogs/about_dialog.h"
#include "gui/workbench/dialogs/shortcut_sheet.h"
#include "gui/workbench/edit_actions.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/filming/film_actions.h"
#include "gui/workbench/filming/film_indicator.h"
#include "gui/workbench/findings_updater.h"
#include "gui/workbench/lost_runs_bar.h"
#include "gui/workbench/main_window.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/presentation/headline.h"
#include "gui/workbench/presentation/presentation.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/run_status_bar.h"
#include "gui/workbench/runs_panel.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

void go_to_panel(QDockWidget& dock) {
  dock.show();
  dock.raise();
  const QWidget* content = dock.widget();
  for (QWidget* part = dock.widget(); part != nullptr; part = part->nextInFocusChain()) {
    const bool takes_keys = part->isVisible() && part->isEnabled() && (part->focusPolicy() & Qt::TabFocus);
    if (takes_keys && (part == content || content->isAncestorOf(part))) return part->setFocus(Qt::ShortcutFocusReason);
    if (part->nextInFocusChain() == content) return;
  }
}

}  // namespace

QWidget* MainWindow::make_center(const QString& run_folder) {
  auto* center = new QWidget;
  viewport_ = new Viewport(presenter_);
  views_ = new QSplitter(Qt::Horizontal);
  views_->setChildrenCollapsible(false);
  views_->addWidget(viewport_);
  timeline_ = new TimelineBar(*session_);
  notice_ = new MessageBar(Tone::warning);
  notice_->add_close_button();
  lost_runs_ = new LostRunsBar(session_->runs(), run_folder);
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  headline_ = new Headline;
  layout->addWidget(headline_);
  layout->addWidget(lost_runs_);
  layout->addWidget(notice_);
  layout->addWidget(views_, 1);
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
  control_ = new ControlPanel(*document_);
  campaign_ = new CampaignPanel(*document_);
  findings_updater_ = std::make_unique<FindingsUpdater>(*session_, [this] { return runs_panel_->compared(); });
  auto* scenario = add(tr("Scenario"), "scenario", editor_, Qt::LeftDockWidgetArea);
  auto* control = add(tr("Control"), "control", control_, Qt::LeftDockWidgetArea);
  auto* campaign = add(tr("Campaign"), "campaign", campaign_, Qt::LeftDockWidgetArea);
  auto* plots = add(tr("Plots"), "plots", plots_, Qt::RightDockWidgetArea);
  auto* findings = add(tr("Findings"), "findings", findings_, Qt::RightDockWidgetArea);
  auto* runs = add(tr("Runs"), "runs", runs_panel_, Qt::RightDockWidgetArea);
  tabifyDockWidget(scenario, control);
  tabifyDockWidget(control, campaign);
  control->hide();   // until there are loops
  campaign->hide();  // until it is asked for
  tabifyDockWidget(findings, runs);
  findings->raise();
  resizeDocks({scenario, plots}, {330, 420}, Qt::Horizontal);
  resizeDocks({plots, findings}, {3, 2}, Qt::Vertical);
}

QString MainWindow::default_folder() const {
  const QString path = document_->path();
  return path.isEmpty() ? read_preferences(*settings_).folder_for_new_files() : QFileInfo(path).path();
}

void MainWindow::make_filming() {
  const auto stem = [this] {
    const QString name = QFileInfo(document_->path()).completeBaseName();
    return QDir(default_folder()).filePath(name.isEmpty() ? "netpocket" : name);
  };
  film_actions_ = new FilmActions(this, {stem, [this] { return read_preferences(*settings_).film_rate; }});
  // Permanent, so that messages do not hide it; after the exports, before the numbers.
  status_->insertPermanentWidget(1, new FilmIndicator(film_actions_->film()));
  connect(film_actions_, &FilmActions::problem, this, &MainWindow::show_notice);
  connect(film_actions_, &FilmActions::told, this, [this](const QString& text) { status_->showMessage(text, 10000); });
  connect(film_actions_, &FilmActions::close_window, this, &QWidget::close);
}

void MainWindow::make_presentation() {
  presentation_ = new Presentation(*this, *headline_, *viewport_);
  headline_->add_corner(new FilmIndicator(film_actions_->film()));
  connect(presentation_, &Presentation::changed, this, [this](bool on, double scale) {
    if (on) start_page_->close_page();
    view_actions_->set_annotation_scale(scale);
  });
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
  file_actions_->set_commit([this] {
    QWidget* typed_in = focusWidget();
    const bool done = commit_text();
    if (done && typed_in != nullptr) typed_in->setFocus(Qt::OtherFocusReason);
    return done;
  });
  file_actions_->fill(*file, *bar);
  file->addSeparator();
  run_files_ = new RunFileActions(
      *session_, *viewport_, *exports_,
      {options.program, [this] { return default_folder(); }, [this] { return read_preferences(*settings_); }}, this);
  run_files_->fill(*file);
  film_actions_->fill(*file);
  file->addSeparator();
  auto* quit = file->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), this, &QWidget::close);
  quit->setMenuRole(QAction::QuitRole);

  edit_actions_ = new EditActions(*document_, this);
  edit_actions_->fill(*edit);
  edit->addSeparator();
  auto* find =
      edit->addAction(tr("Find parameter"), QKeySequence(QKeySequence::Find), editor_, &ScenarioEditor::focus_search);
  find->setStatusTip(tr("Search the scenario's parameters"));
  edit->addSeparator();
  auto* preferences = edit->addAction(tr("Preferences…"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P), this,
                                      &MainWindow::ask_for_preferences);
  preferences->setStatusTip(tr("Type size, colours, language, folders, pictures, memory, drawing"));
  preferences->setMenuRole(QAction::PreferencesRole);

  bar->addSeparator();
  run_actions_ = new RunActions(
      *session_, [this] { return scenario_to_run(); }, this);
  run_actions_->fill(*run, *bar);
  control_actions_ = new ControlActions(*session_, *control_, this);
  control_actions_->fill(*run);
  campaign_actions_ = new CampaignActions(
      *campaign_, *document_, *session_, options.program, [this] { return file_actions_->save(); }, this);
  campaign_actions_->fill(*run);
  bar->addSeparator();
  view_actions_ = new ViewActions(*viewport_, *settings_, this);
  view_actions_->fill(*view, *bar);
  time->addActions(timeline_->playback_actions());

  view->addSeparator();
  fill_panels(*view->addMenu(tr("Panels")));
  auto* full = view->addAction(tr("Full screen"), QKeySequence(Qt::Key_F11), this,
                               [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setStatusTip(tr("Use the whole screen"));

  presentation_->fill(*view);
  make_help(*help, options.about);
}

// Panels to show or hide, and keys that go to them.
void MainWindow::fill_panels(QMenu& menu) {
  QList<QDockWidget*> docks;
  for (const char* name : {"scenario", "plots", "findings", "runs", "control", "campaign"})
    docks << findChild<QDockWidget*>(name);
  for (auto* dock : docks) menu.addAction(dock->toggleViewAction());
  menu.addSeparator();
  menu.setToolTipsVisible(true);
  auto* view = menu.addAction(tr("Go to the view"), QKeySequence(Qt::ALT | Qt::Key_0), viewport_,
                              [this] { viewport_->setFocus(Qt::ShortcutFocusReason); });
  view->setStatusTip(tr("Let the keys act on the view"));
  for (int i = 0; i < docks.size(); ++i) {
    const Qt::Key key = static_cast<Qt::Key>(Qt::Key_1 + i);
    auto* go = menu.addAction(tr("Go to %1").arg(docks[i]->windowTitle().toLower()), QKeySequence(Qt::ALT | key), this,
                              [dock = docks[i]] { go_to_panel(*dock); });
    go->setStatusTip(tr("Show this panel and let the keys act on it"));
  }
}

void MainWindow::make_help(QMenu& menu, const QString& about) {
  auto* start = menu.addAction(tr("Start page"), this, &MainWindow::show_start_page);
  start->setStatusTip(tr("Recent files, scenarios as pictures, a guided first capture"));
  auto* guide = menu.addAction(tr("Guided first capture"), this, &MainWindow::begin_first_capture);
  guide->setStatusTip(tr("Six steps from the pocket to a picture of its capture"));
  menu.addSeparator();
  auto* keys = menu.addAction(tr("Keyboard and mouse"), QKeySequence(Qt::Key_F1), this,
                              [this] { ShortcutSheet(*menuBar(), this).exec(); });
  keys->setStatusTip(tr("All keys and what the mouse does"));
  auto* about_action = menu.addAction(tr("About Netpocket"), this, [this, about] {
    AboutDialog(about, viewport_->presenter_description(), this).exec();
  });
  about_action->setStatusTip(tr("Versions, and how pictures are drawn"));
}

}  // namespace netpocket
