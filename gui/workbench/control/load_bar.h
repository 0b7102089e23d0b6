#pragma once
// How much of a limit is asked for: a bar with a mark at the limit, and words.

#include <QWidget>
#include <optional>

namespace netpocket {

class LoadBar : public QWidget {
  Q_OBJECT
 public:
  explicit LoadBar(QWidget* parent = nullptr);

  // Part of the limit; 1 or more: saturated. Empty: nothing is known. `limited`: whether there is a limit.
  void show_load(std::optional<double> load, bool limited, bool saturated);
  // "43 %", "saturated", "no limit", or empty.
  QString text() const { return text_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<double> load_;
  bool saturated_ = false;
  QString text_;
};

}  // namespace netpocket
