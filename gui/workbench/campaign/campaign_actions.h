#pragma once
// What can be done with campaigns: define, run, stop, open, and take a capture over into the window.
// Thread contract: the user interface's thread.

#include <QObject>
#include <functional>
#include <memory>

#include "gui/workbench/campaign/campaign_panel.h"
#include "gui/workbench/session/capture_session.h"

class QAction;
class QMenu;
class QWidget;

namespace netpocket {

class CampaignActions : public QObject {
  Q_OBJECT
 public:
  // `program`: runs studies. `save`: saves the scenario that is being edited, asks for a name if it has none, and says
  // whether it is saved. All must outlive the actions.
  CampaignActions(CampaignPanel& panel, ScenarioDocument& document, CaptureSession& session, const QString& program,
                  std::function<bool()> save, QWidget* window);
  ~CampaignActions() override;

  void fill(QMenu& menu);

  // Null when there is none.
  Campaign* campaign() const { return campaign_.get(); }
  // Writes the form as a study. False: not written, and the panel says why.
  bool save_study(const QString& path);
  // Runs a study into a folder, which it made before or which is new.
  void run_study(const QString& study, const QString& folder);
  void open_folder(const QString& folder);
  // Rows of the campaign's results. False: it cannot be made, and the panel says why.
  bool open_capture(std::size_t row);
  bool adopt(std::size_t row);
  // Whether the window may close: no campaign runs here, or it is stopped on purpose.
  bool may_close();

 signals:
  void panel_wanted();
  void scenario_adopted();

 private:
  void define_and_run();
  void ask_where_to_save();
  void ask_for_study();
  void ask_for_folder();
  void leave();
  QString folder() const;  // to propose
  bool is_scenario_saved();
  QString suggested_study() const;
  void show(std::unique_ptr<Campaign> campaign);
  std::optional<Scenario> scenario_at(std::size_t row);

  CampaignPanel& panel_;
  ScenarioDocument& document_;
  CaptureSession& session_;
  QString program_;
  std::function<bool()> save_;
  QWidget* window_;
  QAction *define_, *open_;
  std::unique_ptr<Campaign> campaign_;
};

// A folder for the results of a study beside its file, that does not exist yet.
QString unused_results_folder(const QString& study);

}  // namespace netpocket
