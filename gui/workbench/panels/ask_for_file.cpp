#include "gui/workbench/panels/ask_for_file.h"

#include <QFileDialog>

namespace netpocket {

QString ask_for_path(QWidget* parent, const FileQuestion& question) {
  QFileDialog dialog(parent, question.title, question.name, question.filters);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(question.suffix);
  dialog.selectFile(question.name);
  const bool chosen = dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty();
  return chosen ? dialog.selectedFiles().front() : QString();
}

void ask_for_file(QWidget* parent, const FileQuestion& question, const std::function<void(const QString&)>& write) {
  auto* dialog = new QFileDialog(parent, question.title, question.name, question.filters);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(question.suffix);
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, write);
  dialog->open();
}

}  // namespace netpocket
