#pragma once
// The exports under way, in the status bar: progress and a button to cancel.

#include <QWidget>
#include <memory>
#include <vector>

#include "gui/workbench/export/export_job.h"

class QLabel;
class QProgressBar;

namespace netpocket {

class ExportTray : public QWidget {
  Q_OBJECT
 public:
  explicit ExportTray(QWidget* parent = nullptr);

  // One after the other.
  void add(std::unique_ptr<ExportJob> job);
  bool is_busy() const { return job_ != nullptr; }
  void cancel();
  // Whether the window may close: nothing is under way, or it is given up on purpose.
  bool may_close();

 signals:
  void finished(const QString& result);
  void failed(const QString& reason);
  void cancelled(const QString& label);

 private:
  void start_next();
  void end();

  QLabel* label_;
  QProgressBar* progress_;
  std::unique_ptr<ExportJob> job_;
  std::vector<std::unique_ptr<ExportJob>> waiting_;
};

}  // namespace netpocket
