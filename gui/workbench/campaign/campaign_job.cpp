#include "gui/workbench/campaign/campaign_job.h"

#include "engine/study/study_folder.h"

namespace netpocket {
namespace {

constexpr int kTimeToLeave = 5000;  // ms, for a stopped study to put its tables in order
constexpr int kInterrupted = 130;   // exit code of the command

}  // namespace

CampaignJob::CampaignJob(QObject* parent) : QObject(parent) {
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.setReadChannel(QProcess::StandardError);
  connect(&process_, &QProcess::readyReadStandardError, this, &CampaignJob::read_messages);
  connect(&process_, &QProcess::finished, this, &CampaignJob::finish);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) emit failed(tr("cannot start \"%1\"").arg(process_.program()));
  });
}

CampaignJob::~CampaignJob() {
  process_.disconnect(this);
  if (!is_running()) return;
  process_.terminate();
  if (!process_.waitForFinished(kTimeToLeave)) process_.kill();
  process_.waitForFinished(kTimeToLeave);
}

void CampaignJob::start(const QString& program, const QString& study, const QString& folder, int jobs) {
  if (is_running()) return;
  problem_.clear();
  stopping_ = false;
  QStringList arguments = {"study", study, "-o", folder, "--quiet", "--jobs", QString::number(jobs)};
  if (holds_study(folder.toStdString())) arguments << "--resume";
  process_.start(program, arguments);
}

void CampaignJob::stop() {
  stopping_ = true;
  process_.terminate();
}

void CampaignJob::read_messages() {
  while (process_.canReadLine() || process_.state() == QProcess::NotRunning) {
    const QString line = QString::fromUtf8(process_.readLine()).trimmed();
    if (line.isEmpty()) break;
    problem_ = line.startsWith("netpocket: ") ? line.mid(11) : line;
  }
}

void CampaignJob::finish(int code, QProcess::ExitStatus status) {
  read_messages();
  if (status == QProcess::NormalExit && code == 0) {
    emit finished();
  } else if (stopping_ || (status == QProcess::NormalExit && code == kInterrupted)) {
    emit stopped();
  } else {
    emit failed(problem_.isEmpty() ? tr("the study ended unexpectedly") : problem_);
  }
}

}  // namespace netpocket
