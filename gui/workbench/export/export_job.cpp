#include "gui/workbench/export/export_job.h"

#include <QRegularExpression>

namespace netpocket {
namespace {

constexpr int kPatience = 3000;  // ms, for a cancelled export to put its files in order

}  // namespace

ExportJob::ExportJob(const QString& program, const QStringList& arguments, const QString& label, const QString& result,
                     QObject* parent)
    : QObject(parent), program_(program), arguments_(arguments), label_(label), result_(result) {
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.setReadChannel(QProcess::StandardError);
  connect(&process_, &QProcess::readyReadStandardError, this, &ExportJob::read_messages);
  connect(&process_, &QProcess::finished, this, &ExportJob::finish);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) emit failed(tr("%1: cannot start \"%2\"").arg(label_, program_));
  });
}

ExportJob::~ExportJob() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();
  if (!process_.waitForFinished(kPatience)) process_.kill();
  process_.waitForFinished(kPatience);
}

void ExportJob::start() { process_.start(program_, arguments_); }

void ExportJob::cancel() {
  cancelled_ = true;
  process_.terminate();
}

void ExportJob::read_messages() {
  static const QRegularExpression percent("^\\s*(\\d+) %");
  while (process_.canReadLine() || process_.state() == QProcess::NotRunning) {
    const QString line = QString::fromUtf8(process_.readLine()).trimmed();
    if (line.isEmpty()) break;
    if (const auto match = percent.match(line); match.hasMatch()) {
      emit progressed(match.captured(1).toInt());
    } else {
      problem_ = line.startsWith("netpocket: ") ? line.mid(11) : line;
    }
  }
}

void ExportJob::finish(int code, QProcess::ExitStatus status) {
  read_messages();
  if (cancelled_) {
    emit cancelled();
  } else if (status == QProcess::NormalExit && code == 0) {
    emit succeeded();
  } else {
    emit failed(problem_.isEmpty() ? tr("%1 failed").arg(label_) : tr("%1: %2").arg(label_, problem_));
  }
}

}  // namespace netpocket
