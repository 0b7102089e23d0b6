#pragma once
// What this program is, its versions, and what draws its pictures.

#include <QDialog>

namespace netpocket {

class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  // `versions`: one a line; `drawing`: the back end in use.
  AboutDialog(const QString& versions, const QString& drawing, QWidget* parent);
};

}  // namespace netpocket
