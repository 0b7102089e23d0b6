#pragma once
// A heading that folds away the widgets below it.

#include <QWidget>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace netpocket {

class GroupBox : public QWidget {
  Q_OBJECT
 public:
  GroupBox(const QString& title, const QString& tool_tip, QWidget* parent = nullptr);

  void add(QWidget* widget);

  bool is_expanded() const;
  void set_expanded(bool expanded);
  // Unfolds without forgetting whether it was folded, as long as it is set.
  void force_open(bool open);
  // Shown at the right of the heading: how many values have changed, how many problems there are.
  void set_counts(int changed, int problems);

  QToolButton* heading() const { return heading_; }

 signals:
  void toggled();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_state();
  void show_counts();

  QToolButton* heading_;
  QLabel* counts_;
  QWidget* body_;
  QVBoxLayout* body_layout_;
  bool forced_ = false;
  int changed_ = 0;
  int problems_ = 0;
};

}  // namespace netpocket
