#pragma once
// The workbench's window: a scenario to edit, runs to watch, and everything around them.

#include <QMainWindow>
#include <QSettings>
#include <functional>
#include <memory>

#include "gui/workbench/editor/scenario_document.h"
#include "gui/workbench/preview_builder.h"
#include "gui/workbench/session/capture_session.h"
#include "gui/workbench/viewport/picker.h"
#include "gui/workbench/viewport/presenter.h"

class QLabel;

namespace netpocket {

class ExportTray;
class FileActions;
class FindingsPanel;
class FindingsUpdater;
class PlotsPanel;
class RunActions;
class RunStatusBar;
class RunsPanel;
class ScenarioEditor;
class TimelineBar;
class ViewActions;
class Viewport;

struct WindowOptions {
  PresenterKind presenter = PresenterKind::automatic;
  SessionOptions session;
  QString about;            // versions, one a line
  QString settings_file;    // instead of the user's settings
  QString recovery_folder;  // instead of the user's
  QString program;          // that exports are made with: this program
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(const WindowOptions& options);
  ~MainWindow() override;

  // A scenario or a recording, by what the file holds. Problems are shown.
  void open(const QString& path);

  CaptureSession& session() { return *session_; }
  ScenarioDocument& document() { return *document_; }
  Viewport& viewport() { return *viewport_; }
  TimelineBar& timeline() { return *timeline_; }
  ScenarioEditor& editor() { return *editor_; }
  PlotsPanel& plots() { return *plots_; }
  FindingsPanel& findings() { return *findings_; }
  RunActions& run_actions() { return *run_actions_; }
  FileActions& file_actions() { return *file_actions_; }
  ExportTray& exports() { return *exports_; }
  QSettings& settings() { return *settings_; }
  // The sentence in the bar under the toolbar; empty when there is none.
  QString notice() const;

  // What can be simulated; nothing, and the problem is shown, when the scenario has an error.
  std::optional<Scenario> scenario_to_run();
  void show_notice(const QString& text);
  // Exports the shown run as the program's command `arguments`, made for its recording.
  void export_run(const std::function<QStringList(const QString& recording)>& arguments, const QString& label,
                  const QString& result);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_center(PresenterKind presenter);
  void make_docks();
  void make_menus(const WindowOptions& options);
  void connect_document();
  void connect_session();
  void connect_panels();
  void restore_layout();

  void show_preview(const PocketPreview& preview);
  void show_frame(const std::shared_ptr<const Snapshot>& snapshot);
  void run_changed();
  void update_title();
  void update_plots();
  void plot_pick(const Pick& pick);
  void ask_for_export();
  void save_run();
  void strategy_answered(const Diagnostics& refused, double time);

  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<CaptureSession> session_;
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<PreviewBuilder> preview_;
  std::unique_ptr<FindingsUpdater> findings_updater_;
  Viewport* viewport_ = nullptr;
  TimelineBar* timeline_ = nullptr;
  QWidget* notice_bar_ = nullptr;
  QLabel* notice_ = nullptr;
  ScenarioEditor* editor_ = nullptr;
  PlotsPanel* plots_ = nullptr;
  FindingsPanel* findings_ = nullptr;
  RunsPanel* runs_panel_ = nullptr;
  RunStatusBar* status_ = nullptr;
  RunActions* run_actions_ = nullptr;
  ViewActions* view_actions_ = nullptr;
  FileActions* file_actions_ = nullptr;
  ExportTray* exports_ = nullptr;
  QString program_;
};

}  // namespace netpocket
