#include "gui/workbench/campaign/campaign_panel.h"

#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {

CampaignPanel::CampaignPanel(ScenarioDocument& document, QWidget* parent)
    : QWidget(parent),
      problem_(new MessageBar(Tone::warning)),
      pages_(new QStackedWidget),
      form_(new StudyForm(document)),
      view_(new CampaignView) {
  problem_->add_close_button();
  problem_->show_text({});
  pages_->addWidget(form_);
  pages_->addWidget(view_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(problem_);
  layout->addWidget(pages_, 1);
}

void CampaignPanel::show_campaign(Campaign* campaign) {
  show_problem({});
  view_->set_jobs(form_->jobs());
  view_->set_campaign(campaign);
  pages_->setCurrentWidget(campaign != nullptr ? static_cast<QWidget*>(view_) : form_);
}

bool CampaignPanel::shows_campaign() const { return pages_->currentWidget() == view_; }

void CampaignPanel::show_problem(const QString& text) {
  const QString words = engine_words(text);
  problem_->show_text(words.isEmpty() ? words : words.left(1).toUpper() + words.mid(1));
}

QString CampaignPanel::problem() const { return problem_->isHidden() ? QString() : problem_->text(); }

}  // namespace netpocket
