#pragma once
// A line across the top of a panel that says one thing and offers what to do about it. Never in the way.

#include <QFrame>

#include "gui/workbench/panels/tones.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace netpocket {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  MessageBar(Tone tone, QWidget* parent = nullptr);

  // A button at the right end.
  QPushButton* add_button(const QString& text);

  // A cross at the right end that hides the bar.
  void add_close_button();

  // Shows the bar; an empty text hides it.
  void show_text(const QString& text);
  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void set_colours();

  Tone tone_;
  QLabel* label_;
  QHBoxLayout* layout_;
};

}  // namespace netpocket
