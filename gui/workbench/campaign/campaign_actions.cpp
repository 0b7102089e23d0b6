#include "gui/workbench/campaign/campaign_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "engine/base/whole_file.h"
#include "engine/scenario/write_scenario.h"
#include "engine/study/read_study.h"
#include "gui/workbench/editor/edit_command.h"
#include "gui/workbench/panels/ask_for_file.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

// Nothing but where files are sought may differ.
bool say_the_same(const Scenario& a, const Scenario& b) { return write_scenario_text(a) == write_scenario_text(b); }

}  // namespace

QString unused_results_folder(const QString& study) {
  const QFileInfo file(study);
  const QString base = file.dir().filePath(file.completeBaseName());
  QString folder = base + "_results";
  for (int i = 2; QFileInfo::exists(folder); ++i) folder = QString("%1_results_%2").arg(base).arg(i);
  return folder;
}

CampaignActions::CampaignActions(CampaignPanel& panel, ScenarioDocument& document, CaptureSession& session,
                                 const QString& program, std::function<bool()> save, QWidget* window)
    : QObject(window),
      panel_(panel),
      document_(document),
      session_(session),
      program_(program),
      save_(std::move(save)),
      window_(window),
      define_(new QAction(tr("Campaign…"), this)),
      open_(new QAction(tr("Open campaign…"), this)) {
  define_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_C);
  define_->setStatusTip(tr("How often the scenario catches its target when its inputs are uncertain"));
  open_->setStatusTip(tr("Look at the folder of a study that runs, was interrupted or is done"));
  connect(define_, &QAction::triggered, this, &CampaignActions::panel_wanted);
  connect(open_, &QAction::triggered, this, &CampaignActions::ask_for_folder);
  StudyForm* form = panel_.form();
  connect(form->run_button(), &QPushButton::clicked, this, &CampaignActions::define_and_run);
  connect(form->save_button(), &QPushButton::clicked, this, &CampaignActions::ask_where_to_save);
  connect(form->open_study_button(), &QPushButton::clicked, this, &CampaignActions::ask_for_study);
  connect(form->open_folder_button(), &QPushButton::clicked, this, &CampaignActions::ask_for_folder);
  CampaignView* view = panel_.view();
  connect(view, &CampaignView::leave_requested, this, &CampaignActions::leave);
  connect(view, &CampaignView::open_requested, this, &CampaignActions::open_capture);
  connect(view, &CampaignView::adopt_requested, this, &CampaignActions::adopt);
}

CampaignActions::~CampaignActions() = default;

void CampaignActions::fill(QMenu& menu) {
  menu.addSeparator();
  menu.addActions({define_, open_});
}

QString CampaignActions::folder() const {
  return document_.path().isEmpty() ? QDir::homePath() : QFileInfo(document_.path()).path();
}

QString CampaignActions::suggested_study() const {
  return QDir(folder()).filePath(QFileInfo(document_.path()).completeBaseName() + "_campaign.toml");
}

// A study starts from a file, and what it runs is what that says.
bool CampaignActions::is_scenario_saved() {
  if (!document_.path().isEmpty() && !document_.is_modified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Campaign"), tr("Save the scenario \"%1\"?").arg(document_.display_name()),
                  QMessageBox::Save | QMessageBox::Cancel, window_);
  box.setInformativeText(tr("A campaign runs the scenario's file as it is saved."));
  box.setDefaultButton(QMessageBox::Save);
  return box.exec() == QMessageBox::Save && save_();
}

bool CampaignActions::save_study(const QString& path) {
  panel_.show_problem({});
  StudyDraft draft = panel_.form()->draft();
  draft.base = QFileInfo(path).dir().relativeFilePath(document_.path()).toStdString();
  if (const auto problem = draft_problem(draft, document_.scenario())) {
    panel_.show_problem(QString::fromStdString(*problem));
    return false;
  }
  if (QFileInfo(path) == QFileInfo(document_.path())) {
    panel_.show_problem(tr("\"%1\" is the scenario itself: name another file for its study.").arg(path));
    return false;
  }
  try {
    write_whole_file(path.toStdString(), FileKind::scenario, study_text(draft, document_.scenario()));
  } catch (const FileError& error) {
    panel_.show_problem(QString::fromStdString(error.what()));
    return false;
  }
  const StudyResult read = read_study_file(path.toStdString());
  if (!read.ok()) panel_.show_problem(diagnostic_words(read.diagnostics.list().front()));
  return read.ok();
}

void CampaignActions::ask_where_to_save() {
  if (!is_scenario_saved()) return;
  const QString path = ask_for_path(window_, {tr("Save study"), suggested_study(), tr("Studies (*.toml)"), "toml"});
  if (!path.isEmpty()) save_study(path);
}

void CampaignActions::define_and_run() {
  panel_.show_problem({});
  if (const auto problem = draft_problem(panel_.form()->draft(), document_.scenario())) {
    return panel_.show_problem(QString::fromStdString(*problem));
  }
  if (!is_scenario_saved()) return;
  const QString path =
      ask_for_path(window_, {tr("Save study and run it"), suggested_study(), tr("Studies (*.toml)"), "toml"});
  if (!path.isEmpty() && save_study(path)) run_study(path, unused_results_folder(path));
}

void CampaignActions::ask_for_study() {
  const QString path = QFileDialog::getOpenFileName(window_, tr("Run study"), folder(), tr("Studies (*.toml)"));
  if (!path.isEmpty()) run_study(path, unused_results_folder(path));
}

void CampaignActions::ask_for_folder() {
  const QString path = QFileDialog::getExistingDirectory(window_, tr("Open the folder of a study"), folder());
  if (!path.isEmpty()) open_folder(path);
}

void CampaignActions::run_study(const QString& study, const QString& folder) {
  const StudyResult read = read_study_file(study.toStdString());
  if (!read.ok()) {
    emit panel_wanted();
    return panel_.show_problem(diagnostic_words(read.diagnostics.list().front()));
  }
  show(std::make_unique<Campaign>(program_, study, folder));
  campaign_->start(panel_.form()->jobs());
}

void CampaignActions::open_folder(const QString& folder) {
  if (campaign_ && campaign_->is_running()) {
    emit panel_wanted();
    return panel_.show_problem(tr("A campaign is running: stop it before another one is opened."));
  }
  try {
    read_study_manifest(folder.toStdString());
  } catch (const FileError& error) {
    emit panel_wanted();
    return panel_.show_problem(QString::fromStdString(error.what()));
  }
  show(std::make_unique<Campaign>(program_, QString(), folder));
}

void CampaignActions::show(std::unique_ptr<Campaign> campaign) {
  connect(campaign.get(), &Campaign::failed, &panel_, &CampaignPanel::show_problem);
  panel_.show_campaign(campaign.get());
  campaign_ = std::move(campaign);
  emit panel_wanted();
}

void CampaignActions::leave() {
  if (campaign_ && campaign_->is_running()) return;
  panel_.show_campaign(nullptr);
  campaign_.reset();
}

std::optional<Scenario> CampaignActions::scenario_at(std::size_t row) {
  if (!campaign_ || campaign_->results() == nullptr || row >= campaign_->results()->results().size()) {
    return std::nullopt;
  }
  StudyScenario made = campaign_->scenario_of(row);
  if (!made.diagnostics.ok()) {
    panel_.show_problem(diagnostics_words(made.diagnostics));
    return std::nullopt;
  }
  panel_.show_problem({});
  return std::move(made.scenario);
}

bool CampaignActions::open_capture(std::size_t row) {
  auto scenario = scenario_at(row);
  if (!scenario) return false;
  const auto point = static_cast<qlonglong>(campaign_->results()->results().points[row]);
  scenario->name = tr("%1, point %2").arg(campaign_->name()).arg(point).toStdString();
  session_.start(*scenario, true);
  return true;
}

bool CampaignActions::adopt(std::size_t row) {
  auto target = scenario_at(row);
  if (!target) return false;
  target->name = document_.scenario().name;
  target->description = document_.scenario().description;
  const auto point = static_cast<qlonglong>(campaign_->results()->results().points[row]);
  std::vector<ScenarioDocument::Setting> settings;
  if (target->system == document_.scenario().system) {
    for (const QString& key : differing_keys(document_.scenario(), *target)) {
      const Parameter* parameter = find_parameter(key.toStdString(), *target);
      if (parameter != nullptr) settings.emplace_back(parameter, parameter->get(*target));
    }
  }
  std::optional<QString> refusal;
  if (!settings.empty())
    refusal = document_.set_values(settings, tr("point %1 of %2").arg(point).arg(campaign_->name()));
  // Another system, or lists of other lengths: the whole text.
  if (refusal || !say_the_same(document_.scenario(), *target)) {
    const Diagnostics problems = document_.set_text(QString::fromStdString(write_scenario_text(*target)));
    if (!problems.ok()) {
      panel_.show_problem(diagnostics_words(problems));
      return false;
    }
  }
  emit scenario_adopted();
  return true;
}

bool CampaignActions::may_close() {
  if (!campaign_ || !campaign_->is_running()) return true;
  QMessageBox box(QMessageBox::Question, tr("Campaign"), tr("The campaign \"%1\" is running.").arg(campaign_->name()),
                  QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setInformativeText(
      tr("Closing the window stops it. Points that are done are kept; open its folder to go on later."));
  box.button(QMessageBox::Discard)->setText(tr("Stop and close"));
  box.button(QMessageBox::Cancel)->setText(tr("Wait"));
  box.setDefaultButton(QMessageBox::Cancel);
  // It may end while the question stands.
  connect(campaign_.get(), &Campaign::changed, &box, [this, &box] {
    if (!campaign_->is_running()) box.done(QMessageBox::Discard);
  });
  return box.exec() == QMessageBox::Discard;
}

}  // namespace netpocket
