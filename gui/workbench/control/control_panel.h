#pragma once
// The control dock: the control loops of the shown run at the shown frame, the gains of the chosen one, disturbances,
// and the comparison with a run without the loops. It knows loops as data only (state/control_loop_info.h), so it works
// for any capture system.

#include <QWidget>
#include <memory>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "gui/workbench/editor/scenario_document.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace netpocket {

class DisturbanceForm;
class GainForm;
class GroupBox;
class LoopValues;

class ControlPanel : public QWidget {
  Q_OBJECT
 public:
  // The document must outlive the panel.
  explicit ControlPanel(ScenarioDocument& document, QWidget* parent = nullptr);

  // The loops of a structure; null: none. `frame`: null while there is none.
  void show_frame(const std::shared_ptr<const Structure>& structure, const std::shared_ptr<const Snapshot>& frame);
  // The scenario of the run that goes on; null: none.
  void set_running(const Scenario* running);

  QTreeWidget* list() const { return list_; }
  LoopValues* values() const { return values_; }
  GainForm* gains() const { return gains_; }
  DisturbanceForm* disturbances() const { return disturbances_; }
  QPushButton* compare_button() const { return compare_; }
  // State and load of a loop as shown: "active", "saturated".
  QString text(int loop, int column) const;

 signals:
  void loops_appeared();
  void loop_chosen(const QString& name);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_details();
  void rebuild();
  void refresh();
  void show_chosen();
  const ControlLoopInfo* chosen() const;

  std::vector<ControlLoopInfo> loops_;
  std::shared_ptr<const Snapshot> frame_;
  QTreeWidget* list_;
  QLabel* empty_;
  GroupBox* values_box_;
  LoopValues* values_;
  GroupBox* gains_box_;
  GainForm* gains_;
  DisturbanceForm* disturbances_;
  QPushButton* compare_;
};

}  // namespace netpocket
