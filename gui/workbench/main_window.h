#pragma once
// The workbench's window: a scenario to edit, runs to watch, and everything around them.

#include <QMainWindow>
#include <QSettings>
#include <memory>
#include <optional>

#include "gui/workbench/editor/scenario_document.h"
#include "gui/workbench/preferences.h"
#include "gui/workbench/preview_builder.h"
#include "gui/workbench/session/capture_session.h"
#include "gui/workbench/view_history.h"
#include "gui/workbench/viewport/picker.h"
#include "gui/workbench/viewport/presenter.h"

class QSplitter;

namespace netpocket {

class CampaignActions;
class CampaignPanel;
class ControlActions;
class ControlPanel;
class EditActions;
class ExportTray;
class FileActions;
class FilmActions;
enum class GuideStep;
class FindingsPanel;
class FindingsUpdater;
class FirstCapture;
class Headline;
class LostRunsBar;
class MessageBar;
class PickedPlot;
class PlotsPanel;
class Presentation;
class RunActions;
class RunFileActions;
class RunStatusBar;
class RunsPanel;
class ScenarioEditor;
class SecondView;
class StartPage;
class TimelineBar;
class ViewActions;
class Viewport;

struct WindowOptions {
  std::optional<PresenterKind> presenter;  // absent: as the preferences say
  std::optional<int> threads;              // of a simulation; absent: as the preferences say
  RunOptions origin;                       // of the recordings made
  QString about;                           // versions, one a line
  QString settings_file;                   // instead of the user's settings
  QString recovery_folder;                 // instead of the user's
  QString program;                         // that exports are made with: this program
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(const WindowOptions& options);
  ~MainWindow() override;

  // A scenario or a recording, by what the file holds, or the folder of a study. Problems are shown.
  void open(const QString& path);
  // Ways to begin, over the whole window until something is opened.
  void show_start_page();
  // The start page or the file used last, as the preferences say.
  void begin();
  // Whether it asks about work that a crashed session has left.
  bool offers_recovery() const;
  // Opens case 1 and leads through its capture.
  void begin_first_capture();

  CaptureSession& session() { return *session_; }
  ScenarioDocument& document() { return *document_; }
  Viewport& viewport() { return *viewport_; }
  TimelineBar& timeline() { return *timeline_; }
  ScenarioEditor& editor() { return *editor_; }
  PlotsPanel& plots() { return *plots_; }
  FindingsPanel& findings() { return *findings_; }
  ControlPanel& control() { return *control_; }
  ControlActions& control_actions() { return *control_actions_; }
  CampaignPanel& campaign() { return *campaign_; }
  CampaignActions& campaign_actions() { return *campaign_actions_; }
  RunActions& run_actions() { return *run_actions_; }
  EditActions& edit_actions() { return *edit_actions_; }
  FileActions& file_actions() { return *file_actions_; }
  RunFileActions& run_files() { return *run_files_; }
  ViewActions& view_actions() { return *view_actions_; }
  LostRunsBar& lost_runs() { return *lost_runs_; }
  ExportTray& exports() { return *exports_; }
  FilmActions& film_actions() { return *film_actions_; }
  Presentation& presentation() { return *presentation_; }
  Headline& headline() { return *headline_; }
  StartPage& start_page() { return *start_page_; }
  FirstCapture& first_capture() { return *first_capture_; }
  // Null until it is shown for the first time.
  SecondView* second_view() { return second_view_; }
  QSettings& settings() { return *settings_; }
  // The sentence in the bar under the toolbar; empty when there is none.
  QString notice() const;

  // What can be simulated; nothing, and the problem is shown, when the scenario has an error.
  std::optional<Scenario> scenario_to_run();
  void show_notice(const QString& text);
  void apply_preferences(const Preferences& preferences);

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* make_center(const QString& run_folder);
  void make_docks();
  void make_menus(const WindowOptions& options);
  void fill_panels(QMenu& menu);
  void make_help(QMenu& menu, const QString& about);
  void make_start();
  void make_filming();
  void make_presentation();
  void show_numbers();
  // Beside the scenario, or where the preferences say.
  QString default_folder() const;
  void show_guided_place(GuideStep step);
  void connect_document();
  void connect_session();
  void connect_panels();
  void restore_layout();

  // What is wrong with the scenario: goes when it has been put right.
  void show_scenario_notice(const QString& text);
  void withdraw_scenario_notice();
  void text_problem_changed();
  // Says why the file is not opened. Text of a scenario is there to be mended.
  void refuse(const QString& path, const Diagnostics& problems);
  void show_nothing_of(const QString& path);
  void end_of_nothing();
  // Takes over what is being typed. False: it has an error, which is shown.
  bool commit_text();
  void show_preview(const PocketPreview& preview);
  void show_frame(const std::shared_ptr<const Snapshot>& snapshot);
  void run_changed();
  void update_title();
  void update_plots();
  // Which of the plotted runs it is; their number when it is none of them.
  std::size_t plotted(RunId id) const;
  void plot_pick(RunId id, const Pick& pick);
  void show_second_view(bool shown);
  void show_comparison(RunId with_loop);
  void offer_control();
  void bring_up(const char* dock);
  void set_moving(bool moving);
  void ask_for_preferences();
  void strategy_answered(RunId id, const Diagnostics& refused, double time);

  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<CaptureSession> session_;
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<PreviewBuilder> preview_;
  std::unique_ptr<FindingsUpdater> findings_updater_;
  Viewport* viewport_ = nullptr;
  TimelineBar* timeline_ = nullptr;
  QSplitter* views_ = nullptr;
  SecondView* second_view_ = nullptr;
  MessageBar* notice_ = nullptr;
  LostRunsBar* lost_runs_ = nullptr;
  ScenarioEditor* editor_ = nullptr;
  PlotsPanel* plots_ = nullptr;
  FindingsPanel* findings_ = nullptr;
  ControlPanel* control_ = nullptr;
  ControlActions* control_actions_ = nullptr;
  CampaignPanel* campaign_ = nullptr;
  CampaignActions* campaign_actions_ = nullptr;
  PickedPlot* picked_plot_ = nullptr;
  RunsPanel* runs_panel_ = nullptr;
  RunStatusBar* status_ = nullptr;
  RunActions* run_actions_ = nullptr;
  ViewActions* view_actions_ = nullptr;
  EditActions* edit_actions_ = nullptr;
  FileActions* file_actions_ = nullptr;
  RunFileActions* run_files_ = nullptr;
  ExportTray* exports_ = nullptr;
  FilmActions* film_actions_ = nullptr;
  Headline* headline_ = nullptr;
  Presentation* presentation_ = nullptr;
  StartPage* start_page_ = nullptr;
  FirstCapture* first_capture_ = nullptr;
  QWidget* raised_ = nullptr;  // dock that is to be in front once the window is shown
  bool scenario_notice_ = false;
  RunId to_be_framed_ = -1;     // recording that was opened and not yet seen
  bool shows_nothing_ = false;  // because what was opened cannot be shown
  PresenterKind presenter_;
  ViewHistory history_;  // of the first view
};

}  // namespace netpocket
