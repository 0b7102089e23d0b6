#pragma once
// Runs as files: saving, exporting, and not losing any.
// Thread contract: the user interface's thread.

#include <QObject>
#include <QTemporaryDir>
#include <functional>

#include "gui/workbench/preferences.h"
#include "gui/workbench/session/capture_session.h"
#include "gui/workbench/viewport/viewport.h"

class QMenu;

namespace netpocket {

class ExportDialog;
class ExportTray;

class RunFileActions : public QObject {
  Q_OBJECT
 public:
  struct Choices {
    QString program;                           // makes the exports
    std::function<QString()> folder;           // where to propose to write
    std::function<Preferences()> preferences;  // that say what is proposed
  };

  // All must outlive the actions.
  RunFileActions(CaptureSession& session, Viewport& viewport, ExportTray& tray, Choices choices, QWidget* window);

  void fill(QMenu& menu);
  void ask_for_export();

  // As chosen in a dialog that was accepted.
  void export_as(const ExportDialog& dialog);

  // Exports the shown run as the program's command `arguments`, made for its recording.
  void export_run(const std::function<QStringList(const QString& recording)>& arguments, const QString& label,
                  const QString& result);
  // Writes all unsaved runs into a folder, each under a name of its own.
  void save_unsaved_to(const QString& folder);
  // Whether the window may close as far as runs are concerned. False: the user wants to keep them, and close_window()
  // follows once they are saved.
  bool may_close();
  // Whether a run may go: saved, or given up on purpose.
  bool may_remove(RunId id);

 signals:
  void problem(const QString& sentence);
  void file_used(const QString& path);
  void close_window();

 private:
  void save_shown();
  void run_saved();

  CaptureSession& session_;
  Viewport& viewport_;
  ExportTray& tray_;
  Choices choices_;
  QWidget* window_;
  QTemporaryDir views_;  // view files of exports
  int view_count_ = 0;
  bool closing_ = false;  // as soon as no run is unsaved
};

}  // namespace netpocket
