#pragma once
// A study in a process of its own: this program's study command. What holds for the command holds here: points that are
// done survive the process, and it goes on where it was.
// Thread contract: the user interface's thread.

#include <QObject>
#include <QProcess>
#include <QString>

namespace netpocket {

class CampaignJob : public QObject {
  Q_OBJECT
 public:
  explicit CampaignJob(QObject* parent = nullptr);
  ~CampaignJob() override;  // stops it; waits a while

  // Begins the study, or goes on with it when the folder holds it already.
  void start(const QString& program, const QString& study, const QString& folder, int jobs);
  // Lets it end cleanly: the points that are being run are lost, those that are done are kept.
  void stop();
  bool is_running() const { return process_.state() != QProcess::NotRunning; }
  bool is_stopping() const { return stopping_ && is_running(); }

 signals:
  void finished();                     // all points are done, and the tables are written
  void stopped();                      // as it was told to
  void failed(const QString& reason);  // one sentence

 private:
  void read_messages();
  void finish(int code, QProcess::ExitStatus status);

  QProcess process_;
  QString problem_;  // the last line that it said
  bool stopping_ = false;
};

}  // namespace netpocket
