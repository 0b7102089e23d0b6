#pragma once
// The closing law of a scenario as curves: rope length and its speed over time.

#include <QWidget>

#include "engine/scenario/scenario.h"

namespace netpocket {

class ChartView;

class ClosingPreview : public QWidget {
  Q_OBJECT
 public:
  explicit ClosingPreview(QWidget* parent = nullptr);

  // Drawn at once; where the law makes no sense, says so instead.
  void show_scenario(const Scenario& scenario);

  ChartView* chart() const { return chart_; }

 private:
  ChartView* chart_;
};

}  // namespace netpocket
