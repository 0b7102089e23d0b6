#pragma once
// The runs of the session: which one is shown, which are drawn over it in the plots.

#include <QTreeWidget>
#include <QWidget>

#include "gui/workbench/session/capture_session.h"

class QLabel;

namespace netpocket {

class RunsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunsPanel(CaptureSession& session, QWidget* parent = nullptr);

  // The shown run first, then those checked for comparison.
  std::vector<RunId> compared() const;
  // Ticks a run.
  void compare_with(RunId id);
  QTreeWidget* list() const { return list_; }

 signals:
  void compared_changed();
  void remove_requested(netpocket::RunId id);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QTreeWidgetItem* item_of(RunId id) const;
  void add(RunId id);
  void remove(RunId id);
  void refresh(RunId id);
  void mark_current();
  void show_list();
  void show_menu(const QPoint& position);

  CaptureSession& session_;
  QTreeWidget* list_;
  QLabel* empty_;  // instead of a list without runs
};

}  // namespace netpocket
