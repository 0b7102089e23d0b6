#include "gui/workbench/dialogs/about_dialog.h"

#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QVBoxLayout>

namespace netpocket {

AboutDialog::AboutDialog(const QString& versions, const QString& drawing, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("About Netpocket"));
  auto* title = new QLabel(tr("Netpocket"));
  QFont font = title->font();
  font.setPointSizeF(1.8 * font.pointSizeF());
  font.setBold(true);
  title->setFont(font);
  auto* what = new QLabel(tr("Simulates and shows how a netted pocket captures a target in orbit."));
  const QString details = QString("%1\nQt %2 (%3)\n%4")
                              .arg(versions, QString::fromLatin1(qVersion()), QGuiApplication::platformName(),
                                   tr("Pictures: %1").arg(drawing));
  auto* text = new QLabel(details);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 20, 24, 16);
  layout->setSpacing(12);
  for (QWidget* widget : std::initializer_list<QWidget*>{title, what, text, buttons}) layout->addWidget(widget);
}

}  // namespace netpocket
