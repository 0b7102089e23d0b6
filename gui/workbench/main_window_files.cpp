// Files that are opened in the window, dropped on it, or cannot be shown.

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "engine/base/file_kind.h"
#include "engine/study/study_folder.h"
#include "gui/workbench/campaign/campaign_actions.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/main_window.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/viewport/viewport.h"

namespace netpocket {
namespace {

bool is_recording(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == "h5" || suffix == "hdf5" || suffix == "part" || is_recording_file(path.toStdString());
}

// Any number of recordings, and one scenario. What is neither is opened, too: to be told what is wrong with it.
QStringList files_to_open(const QMimeData& data) {
  QStringList recordings, others;
  for (const QUrl& url : data.urls()) {
    const QString path = url.toLocalFile();
    if (path.isEmpty()) continue;
    (is_recording(path) ? recordings : others) << path;
  }
  const auto is_scenario = [](const QString& path) { return QFileInfo(path).suffix().toLower() == "toml"; };
  std::ranges::stable_partition(others, is_scenario);
  return recordings + others.mid(0, 1);
}

// Whether it is a scenario's text, if a faulty one, and not a file of another kind or none at all.
bool is_faulty_text(const Diagnostics& problems) {
  return std::ranges::any_of(problems.list(), [](const Diagnostic& problem) { return problem.line > 0; });
}

}  // namespace

void MainWindow::open(const QString& path) {
  show_notice({});
  if (holds_study(path.toStdString())) {
    start_page_->close_page();
    return campaign_actions_->open_folder(path);
  }
  if (is_recording(path)) {
    file_actions_->note_recent(path);
    session_->runs().open(path);
    return;
  }
  if (!file_actions_->may_discard()) return;
  if (const Diagnostics problems = document_->open(path); !problems.ok()) return refuse(path, problems);
  const Diagnostics problems = document_->located_diagnostics();
  if (problems.ok()) return;
  show_scenario_notice(diagnostics_words(problems));
  show_nothing_of(path);
  editor_->reveal(QString::fromStdString(problems.list().front().key));
}

void MainWindow::refuse(const QString& path, const Diagnostics& problems) {
  QFile file(path);
  if (!is_faulty_text(problems) || !file.open(QIODevice::ReadOnly)) return show_notice(diagnostics_words(problems));
  bring_up("scenario");
  editor_->mend(path, QString::fromUtf8(file.readAll()));
  show_scenario_notice(diagnostics_words(problems));
  show_nothing_of(path);
}

// The form and the picture of another scenario would pass for the file's. A run stays in sight.
void MainWindow::show_nothing_of(const QString& path) {
  if (session_->current() != nullptr) return;
  preview_->forget();
  viewport_->set_pocket(nullptr, nullptr);
  viewport_->set_message(tr("%1 cannot be shown: it has an error.").arg(QFileInfo(path).fileName()));
  shows_nothing_ = true;
}

void MainWindow::end_of_nothing() {
  if (std::exchange(shows_nothing_, false)) viewport_->set_message({});
}

void MainWindow::text_problem_changed() {
  withdraw_scenario_notice();
  // What was to be mended has been given up.
  if (!editor_->text_page()->has_problem() && shows_nothing_) preview_->build(document_->scenario());
}

bool MainWindow::commit_text() {
  if (editor_->commit()) return true;
  show_scenario_notice(tr("The scenario's text has an error: see the editor."));
  return false;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!files_to_open(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList paths = files_to_open(*event->mimeData());
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  // Afterwards: a question would hold up the program that the files come from.
  const auto open_all = [this, paths] {
    for (const QString& path : paths) open(path);
  };
  QMetaObject::invokeMethod(this, open_all, Qt::QueuedConnection);
}

}  // namespace netpocket
