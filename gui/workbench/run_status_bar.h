#pragma once
// The status bar: what the run is doing, in numbers.

#include <QStatusBar>

#include "gui/workbench/session/run.h"

class QLabel;

namespace netpocket {

class RunStatusBar : public QStatusBar {
  Q_OBJECT
 public:
  explicit RunStatusBar(QWidget* parent = nullptr);

  // The run that is shown, if any, and which of its frames.
  void show_run(const Run* run, std::size_t frame);
  const QLabel* state_field() const { return state_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QLabel* add_field(const QString& help, const QString& widest);

  void colour_state();

  bool diverged_ = false;
  QLabel *state_, *draft_, *time_, *speed_, *step_, *contacts_, *energy_;
};

}  // namespace netpocket
