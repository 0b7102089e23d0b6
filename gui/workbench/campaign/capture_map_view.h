#pragma once
// The captures of a campaign over two inputs, with contours of the probability of capture. The mouse and the keys
// choose captures: a click, or left and right from one point to the next. Thread contract: the user interface's thread;
// contours are computed in the background.

#include <QWidget>
#include <memory>
#include <optional>

#include "engine/study/study_results.h"
#include "gui/workbench/panels/figure_image.h"
#include "gui/workbench/simulation/latest_task.h"

namespace netpocket {

class CaptureMapView : public QWidget {
  Q_OBJECT
 public:
  explicit CaptureMapView(QWidget* parent = nullptr);
  ~CaptureMapView() override;

  // Must outlive the view or be replaced; null: none.
  void set_results(const StudyResults* results);
  // There are more of them.
  void refresh();
  // Names of inputs.
  void set_axes(const std::string& x, const std::string& y);

  // Rows of the results.
  std::optional<std::size_t> chosen() const { return chosen_; }
  std::optional<std::size_t> hovered() const { return hovered_; }
  void choose(std::optional<std::size_t> row);

  // Of the inputs on the axes, if there are any.
  const ResultColumn* x() const;
  const ResultColumn* y() const;
  bool has_contours() const { return !contours_.empty(); }
  // The drawn capture nearest to a point of the widget, a few pixels away at most.
  std::optional<std::size_t> row_at(const QPointF& point) const;
  // Where it is drawn.
  std::optional<QPointF> place_of(std::size_t row) const;

  QSize sizeHint() const override { return {320, 320}; }
  QSize minimumSizeHint() const override { return {220, 200}; }

 signals:
  void chosen_changed();
  void open_requested();  // of the chosen one: by a double click or Enter

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct ContourJob {
    StudyResults results;  // only the two inputs
    int axes = 0;          // number of the choice of axes
  };

  void redraw();
  void request_contours();
  void make_contours(const ContourJob& job);
  void step(int direction);
  void draw_mark(QPainter& painter, std::size_t row, bool strong) const;

  const StudyResults* results_ = nullptr;
  std::string x_, y_;
  int axes_ = 0;
  std::optional<std::size_t> chosen_, hovered_;
  std::vector<Curve> contours_;
  std::size_t rows_of_contours_ = 0;  // that were asked for last
  FigureImage drawn_;
  bool stale_ = true;
  std::unique_ptr<LatestTask<ContourJob>> task_;
};

}  // namespace netpocket
