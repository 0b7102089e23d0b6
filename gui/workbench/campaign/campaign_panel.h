#pragma once
// The campaign dock: defines a campaign for the scenario, or shows one that runs or is done.
// Thread contract: the user interface's thread.

#include <QWidget>

#include "gui/workbench/campaign/campaign_view.h"
#include "gui/workbench/campaign/study_form.h"

class QStackedWidget;

namespace netpocket {

class MessageBar;

class CampaignPanel : public QWidget {
  Q_OBJECT
 public:
  // The document must outlive the panel.
  explicit CampaignPanel(ScenarioDocument& document, QWidget* parent = nullptr);

  StudyForm* form() const { return form_; }
  CampaignView* view() const { return view_; }
  // Null: the form is shown.
  void show_campaign(Campaign* campaign);
  bool shows_campaign() const;
  // A sentence at the top; an empty one takes it away.
  void show_problem(const QString& text);
  QString problem() const;

 private:
  MessageBar* problem_;
  QStackedWidget* pages_;
  StudyForm* form_;
  CampaignView* view_;
};

}  // namespace netpocket
