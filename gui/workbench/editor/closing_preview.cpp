#include "gui/workbench/editor/closing_preview.h"

#include <QVBoxLayout>
#include <algorithm>

#include "engine/control/closing_law.h"
#include "engine/scenario/pocket_outline.h"
#include "gui/workbench/panels/chart_view.h"

namespace netpocket {
namespace {

constexpr int kHeight = 160;      // pixels
constexpr int kPanelWidth = 160;  // pixels
constexpr int kPoints = 241;
constexpr double kBefore = 0.05;  // of the duration, shown before the start
constexpr double kAfter = 0.1;    // and after the end

// Whether ClosingSchedule can be made of it.
bool is_valid(const Scenario& scenario) {
  if (scenario.rods.profile.size() != 3) return false;
  if (scenario.closing.law != ClosingLaw::table) return true;
  const auto& table = scenario.closing.table;
  const auto not_later = [](const auto& a, const auto& b) { return b.x() <= a.x(); };
  return table.size() >= 2 && std::adjacent_find(table.begin(), table.end(), not_later) == table.end();
}

Panel panel(const QString& title, const QString& y_title, FigureColour colour) {
  Panel result;
  result.title = title.toStdString();
  result.x.title = ClosingPreview::tr("Time *t* (s)").toStdString();
  result.y.title = y_title.toStdString();
  result.curves.emplace_back();
  result.curves.back().colour = colour;
  result.curves.back().width = 1.2;
  return result;
}

Figure closing_figure(const Scenario& scenario) {
  const ClosingSchedule schedule(scenario.closing, open_tip_distance(scenario));
  const double duration = schedule.end() - schedule.start();
  const double begin = std::max(0.0, schedule.start() - kBefore * duration);
  const double end = schedule.end() + kAfter * duration;
  Panel length = panel(ClosingPreview::tr("Rope length"), ClosingPreview::tr("Length *L* (m)"), kBlue);
  Panel speed = panel(ClosingPreview::tr("Closing speed"), ClosingPreview::tr("Speed d*L*/d*t* (m/s)"), kVermillion);
  for (int i = 0; i < kPoints; ++i) {
    const double time = begin + (end - begin) * i / (kPoints - 1);
    const ClosingState state = schedule.at(time);
    length.curves[0].x.push_back(time);
    length.curves[0].y.push_back(state.length);
    speed.curves[0].x.push_back(time);
    speed.curves[0].y.push_back(state.speed);
  }
  Figure figure;
  figure.panels = {std::move(length), std::move(speed)};
  figure.columns = 2;
  return figure;
}

}  // namespace

ClosingPreview::ClosingPreview(QWidget* parent) : QWidget(parent), chart_(new ChartView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 4, 10, 4);
  layout->addWidget(chart_);
  chart_->setFixedHeight(kHeight);
  chart_->set_panel_width(kPanelWidth);
  chart_->setAccessibleName(tr("Preview of the closing law"));
  chart_->setToolTip(tr("Rope length between adjacent rod tips and its speed, as the closing law commands them"));
  chart_->set_placeholder(tr("The closing law needs two points or more with increasing times."));
}

void ClosingPreview::show_scenario(const Scenario& scenario) {
  chart_->set_figure(is_valid(scenario) ? closing_figure(scenario) : Figure{});
}

}  // namespace netpocket
