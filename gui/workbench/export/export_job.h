#pragma once
// An export in a process of its own: this program's render, plot or export command. So the window stays quick and its
// OpenGL untouched, whatever the export does.
// Thread contract: the user interface's thread.

#include <QObject>
#include <QProcess>
#include <QStringList>

namespace netpocket {

class ExportJob : public QObject {
  Q_OBJECT
 public:
  // `label` names what is made, `result` the file or folder.
  ExportJob(const QString& program, const QStringList& arguments, const QString& label, const QString& result,
            QObject* parent = nullptr);
  ~ExportJob() override;  // cancels

  void start();
  // Whole files that are there already stay.
  void cancel();
  const QString& label() const { return label_; }
  const QString& result() const { return result_; }

 signals:
  void progressed(int percent);
  void succeeded();
  void cancelled();
  void failed(const QString& reason);  // one sentence

 private:
  void read_messages();
  void finish(int code, QProcess::ExitStatus status);

  QProcess process_;
  QString program_;
  QStringList arguments_;
  QString label_;
  QString result_;
  QString problem_;  // the last line that is not about progress
  bool cancelled_ = false;
};

}  // namespace netpocket
