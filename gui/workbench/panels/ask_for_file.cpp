#include "gui/workbench/panels/ask_for_file.h"

#include <QFileDialog>

namespace netpocket {

void ask_for_file(QWidget* parent, const FileQuestion& question, const std::function<void(const QString&)>& write) {
  auto* dialog = new QFileDialog(parent, question.title, question.name, question.filters);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(question.suffix);
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, write);
  dialog->open();
}

}  // namespace netpocket
