#pragma once
// The plots dock: figures of one or several runs, linked to the timeline. Draws at most every 50 ms, and only while it
// can be seen, so runs may be set or grow as often as they like.

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "gui/workbench/panels/chart_view.h"
#include "render/figures/run_series.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace netpocket {

class PlotsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PlotsPanel(QWidget* parent = nullptr);

  // The runs drawn over each other; the first is the current one.
  void set_series(std::vector<RunSeries> runs);
  const std::vector<RunSeries>& series() const { return runs_; }

  // One more recorded frame of a run, by its channel_list. Without effect if there is no such run.
  void append(std::size_t run, const std::vector<double>& channels);

  // When closing ends and towing starts in a run, s; NaN: unknown or never. Without effect if there is no such run.
  // Takes over the channels and the phases of a run, which are known once it has begun. Other channels begin anew.
  void describe(std::size_t run, const RunSeries& series);

  // Panels of things picked in the view, over time; offered as a figure of its own when there are any.
  void set_picked(std::vector<Panel> panels);

  // The loop that the figure of control loops shows, by its name; empty: all.
  void set_loop(const QString& name);

  // The time of the timeline, s; empty: no cursor.
  void set_time(std::optional<double> time);

  // A name of figure_names() or "picked".
  void show_figure(const QString& name);
  QString figure_name() const;

  ChartView* chart() const { return chart_; }
  // The values at the mouse or else at the timeline's time, as shown.
  QString values_text() const;

  // Writes what is shown, by the extension of the path (.png, .svg, .pdf). Why not, when it fails.
  [[nodiscard]] std::optional<QString> export_figure(const QString& path) const;

 signals:
  void time_clicked(double time);
  void exported(const QString& path);
  void export_failed(const QString& reason);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void add_figures();
  void offer_figures();
  void request_redraw();
  void redraw();
  Figure make_figure() const;
  void show_values();
  void ask_for_export();

  std::vector<RunSeries> runs_;
  std::vector<Panel> picked_;
  QString loop_;
  QComboBox* figures_;
  QToolButton* reset_;
  QToolButton* export_;
  ChartView* chart_;
  QLabel* values_;
  QTimer throttle_;
  bool stale_ = true;
};

}  // namespace netpocket
