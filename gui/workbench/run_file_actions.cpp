#include "gui/workbench/run_file_actions.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>

#include "gui/workbench/export/export_dialog.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/panels/ask_for_file.h"
#include "render/scene/view_file.h"

namespace netpocket {
namespace {

// A file in `folder` that is neither there yet nor among those `taken`.
QString unused_path(const QString& folder, const QString& name, QSet<QString>& taken) {
  const QString base = QString(name).replace(QRegularExpression("[^A-Za-z0-9._-]+"), "_");
  QString path = QDir(folder).filePath(base + ".h5");
  for (int i = 2; QFileInfo::exists(path) || taken.contains(path); ++i) {
    path = QDir(folder).filePath(QString("%1_%2.h5").arg(base).arg(i));
  }
  taken << path;
  return path;
}

}  // namespace

RunFileActions::RunFileActions(CaptureSession& session, Viewport& viewport, ExportTray& tray, Choices choices,
                               QWidget* window)
    : QObject(window),
      session_(session),
      viewport_(viewport),
      tray_(tray),
      choices_(std::move(choices)),
      window_(window) {
  connect(&session_.runs(), &RunLibrary::saved, this, &RunFileActions::run_saved);
  connect(&session_.runs(), &RunLibrary::failed, this, [this] { closing_ = false; });
}

void RunFileActions::fill(QMenu& menu) {
  auto* save = menu.addAction(tr("Save run as…"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S), this,
                              &RunFileActions::save_shown);
  save->setStatusTip(tr("Save the shown run as a recording"));
  auto* export_action =
      menu.addAction(tr("&Export…"), QKeySequence(Qt::CTRL | Qt::Key_E), this, &RunFileActions::ask_for_export);
  export_action->setStatusTip(tr("Pictures, video, figures, tables of the shown run"));
}

void RunFileActions::save_shown() {
  const Run* run = session_.current();
  if (run == nullptr || run->frame_count() == 0) {
    emit problem(tr("There is no run to save yet."));
    return;
  }
  const RunId id = run->id;
  const QString name = QDir(choices_.folder()).filePath(run->name + ".h5");
  const QString path = ask_for_path(window_, {tr("Save run"), name, tr("Recordings (*.h5)"), "h5"});
  if (path.isEmpty()) return;
  emit file_used(path);
  session_.runs().save(id, path);
}

void RunFileActions::ask_for_export() {
  const Run* run = session_.current();
  if (run == nullptr || run->frame_count() == 0) {
    emit problem(tr("There is no run to export yet."));
    return;
  }
  const double time = viewport_.state().snapshot ? viewport_.state().snapshot->time : 0;
  ExportDialog dialog(choices_.folder(), run->name, {viewport_.view(), viewport_.options(), time}, window_);
  const Preferences preferences = choices_.preferences();
  dialog.propose(preferences.export_size, preferences.export_rate);
  if (dialog.exec() == QDialog::Accepted) export_as(dialog);
}

void RunFileActions::export_as(const ExportDialog& dialog) {
  const QString view_file = views_.filePath(QString("view%1.toml").arg(view_count_++));
  if (dialog.uses_view()) {
    QFile file(view_file);
    const QByteArray text = QByteArray::fromStdString(view_text(dialog.view()));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      emit problem(tr("Cannot write '%1': %2").arg(view_file, file.errorString()));
      return;
    }
  }
  export_run([&](const QString& recording) { return dialog.arguments(recording, view_file); }, dialog.label(),
             dialog.target());
}

void RunFileActions::export_run(const std::function<QStringList(const QString& recording)>& arguments,
                                const QString& label, const QString& result) {
  const Run* run = session_.current();
  if (run == nullptr) return;
  const QStringList command = arguments(QString::fromStdString(run->file->path()));
  session_.runs().flush(run->id, [this, command, label, result](const QString&) {
    tray_.add(std::make_unique<ExportJob>(choices_.program, command, label, result));
  });
}

void RunFileActions::save_unsaved_to(const QString& folder) {
  QSet<QString> taken;
  for (const RunId id : session_.runs().unsaved()) {
    const QString path = unused_path(folder, session_.runs().find(id)->name, taken);
    emit file_used(path);
    session_.runs().save(id, path);
  }
}

bool RunFileActions::may_close() {
  const std::vector<RunId> unsaved = session_.runs().unsaved();
  if (unsaved.empty()) return true;
  if (session_.is_running()) session_.pause();
  const auto count = unsaved.size();
  QMessageBox box(QMessageBox::Question, tr("Unsaved runs"),
                  count == 1 ? tr("Save the run \"%1\"?").arg(session_.runs().find(unsaved.front())->name)
                             : tr("Save %1 runs?").arg(count),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setInformativeText(tr("Otherwise what was simulated is lost."));
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  const QString folder = QFileDialog::getExistingDirectory(window_, tr("Save runs in"), choices_.folder());
  if (folder.isEmpty()) return false;
  closing_ = true;
  save_unsaved_to(folder);
  return false;
}

bool RunFileActions::may_remove(RunId id) {
  const Run* run = session_.runs().find(id);
  if (run == nullptr || !run->is_unsaved()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved run"), tr("Remove the run \"%1\"?").arg(run->name),
                  QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setInformativeText(tr("It is not saved: what was simulated is lost."));
  box.button(QMessageBox::Discard)->setText(tr("Remove"));
  box.setDefaultButton(QMessageBox::Cancel);
  return box.exec() == QMessageBox::Discard;
}

void RunFileActions::run_saved() {
  if (!closing_ || !session_.runs().unsaved().empty()) return;
  closing_ = false;
  emit close_window();
}

}  // namespace netpocket
