#include "gui/workbench/campaign/capture_map_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/workbench/campaign/point_words.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/figure_words.h"
#include "gui/workbench/panels/tones.h"
#include "render/figures/capture_map.h"
#include "render/figures/drawn_captures.h"

namespace netpocket {
namespace {

constexpr double kGrasp = 9;                // pixels
constexpr double kRing = 6;                 // pixels
constexpr double kRoomBeside = 0.04;        // of the range, beside the outermost points
constexpr double kGrowthForContours = 0.2;  // of the rows, before they are worth computing anew
constexpr std::size_t kFewestForContours = 60;

const ResultColumn* input_named(const StudyResults* results, const std::string& name) {
  if (results == nullptr) return nullptr;
  const auto found = std::ranges::find(results->inputs, name, &ResultColumn::name);
  return found == results->inputs.end() ? nullptr : &*found;
}

std::optional<AxisLimits> padded(const ColumnRange& range) {
  if (!(range.to >= range.from)) return std::nullopt;
  const double size = range.to > range.from ? range.to - range.from : std::max(std::abs(range.to), 1.0);
  return AxisLimits{range.from - kRoomBeside * size, range.to + kRoomBeside * size};
}

}  // namespace

CaptureMapView::CaptureMapView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Map of the captures"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  task_ = std::make_unique<LatestTask<ContourJob>>([this](const ContourJob& job) { make_contours(job); });
}

CaptureMapView::~CaptureMapView() { task_.reset(); }

void CaptureMapView::set_results(const StudyResults* results) {
  if (results == results_) return refresh();
  results_ = results;
  hovered_.reset();
  choose(std::nullopt);
  contours_.clear();
  rows_of_contours_ = 0;
  ++axes_;
  refresh();
}

void CaptureMapView::refresh() {
  const std::size_t rows = results_ != nullptr ? results_->size() : 0;
  const bool has_grown = static_cast<double>(rows) > (1 + kGrowthForContours) * static_cast<double>(rows_of_contours_);
  if (rows >= kFewestForContours && has_grown) request_contours();
  redraw();
}

void CaptureMapView::set_axes(const std::string& x, const std::string& y) {
  if (x == x_ && y == y_) return;
  x_ = x;
  y_ = y;
  ++axes_;
  contours_.clear();
  hovered_.reset();
  rows_of_contours_ = 0;
  refresh();
}

const ResultColumn* CaptureMapView::x() const { return input_named(results_, x_); }
const ResultColumn* CaptureMapView::y() const { return input_named(results_, y_); }

void CaptureMapView::redraw() {
  stale_ = true;
  update();
}

// ---- contours ----

void CaptureMapView::request_contours() {
  if (x() == nullptr || y() == nullptr || x() == y()) return;
  rows_of_contours_ = results_->size();
  ContourJob job;
  job.results.inputs = {*x(), *y()};
  job.results.points = results_->points;
  job.results.captured = results_->captured;
  job.axes = axes_;
  task_->submit(std::move(job));
}

void CaptureMapView::make_contours(const ContourJob& job) {
  auto curves = probability_contours(job.results, job.results.inputs[0], job.results.inputs[1]).curves;
  QMetaObject::invokeMethod(
      this,
      [this, axes = job.axes, curves = std::move(curves)] {
        if (axes != axes_) return;  // others are shown by now
        contours_ = curves;
        redraw();
      },
      Qt::QueuedConnection);
}

// ---- captures and pixels ----

std::optional<QPointF> CaptureMapView::place_of(std::size_t row) const {
  if (drawn_.panels.empty() || x() == nullptr || y() == nullptr || row >= results_->size()) return std::nullopt;
  const PanelFrame& frame = drawn_.panels.front();
  const double across = (x()->values[row] - frame.x.low) / frame.x.span();
  const double up = (y()->values[row] - frame.y.low) / frame.y.span();
  if (!(across >= 0 && across <= 1 && up >= 0 && up <= 1)) return std::nullopt;
  return QPointF(frame.box.x + across * frame.box.width, frame.box.bottom() - up * frame.box.height);
}

std::optional<std::size_t> CaptureMapView::row_at(const QPointF& point) const {
  std::optional<std::size_t> nearest;
  double least = kGrasp;
  const std::size_t rows = results_ != nullptr ? results_->size() : 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const bool is_shown = !std::isnan(results_->captured[row]) && is_drawn(row, rows);
    const auto place = is_shown ? place_of(row) : std::nullopt;
    const double distance = place ? std::hypot(place->x() - point.x(), place->y() - point.y()) : kGrasp;
    if (distance >= least) continue;
    least = distance;
    nearest = row;
  }
  return nearest;
}

void CaptureMapView::choose(std::optional<std::size_t> row) {
  if (row == chosen_) return;
  chosen_ = row;
  update();
  emit chosen_changed();
}

// The next judged point by number.
void CaptureMapView::step(int direction) {
  if (results_ == nullptr) return;
  std::optional<std::size_t> next;
  const double from = chosen_ ? results_->points[*chosen_] : (direction > 0 ? 0 : INFINITY);
  for (std::size_t row = 0; row < results_->size(); ++row) {
    const double way = direction * (results_->points[row] - from);
    if (std::isnan(results_->captured[row]) || !(way > 0)) continue;
    if (!next || way < direction * (results_->points[*next] - from)) next = row;
  }
  if (next) choose(next);
}

// ---- painting ----

void CaptureMapView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (x() == nullptr || y() == nullptr) {
    painter.fillRect(rect(), palette().base());
    painter.setPen(tone_colour(Tone::muted, palette()));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The map fills as captures are done."));
    return;
  }
  if (stale_) {
    Figure figure = in_window_language(make_capture_map(*results_, *x(), *y()));
    figure.title = engine_words(std::string_view(drawn_text(results_->size()))).toStdString();
    Panel& panel = figure.panels.front();
    panel.x.limits = padded(range_of(*x()));
    panel.y.limits = padded(range_of(*y()));
    panel.curves.insert(panel.curves.end(), contours_.begin(), contours_.end());
    drawn_ = figure_image(figure, size(), devicePixelRatioF(), palette());
    stale_ = false;
  }
  painter.drawImage(QPoint(0, 0), drawn_.image);
  painter.setRenderHint(QPainter::Antialiasing);
  if (hovered_) draw_mark(painter, *hovered_, false);
  if (chosen_) draw_mark(painter, *chosen_, true);
}

void CaptureMapView::draw_mark(QPainter& painter, std::size_t row, bool strong) const {
  const auto place = place_of(row);
  if (!place) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Text), strong ? 2.5 : 1.2));
  painter.drawEllipse(*place, kRing, kRing);
}

void CaptureMapView::resizeEvent(QResizeEvent*) { redraw(); }

void CaptureMapView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) redraw();
  QWidget::changeEvent(event);
}

// ---- mouse and keyboard ----

void CaptureMapView::mouseMoveEvent(QMouseEvent* event) {
  const auto row = row_at(event->position());
  if (row == hovered_) return;
  hovered_ = row;
  setCursor(row ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (row) {
    QToolTip::showText(event->globalPosition().toPoint(), point_words(*results_, *row), this);
  } else {
    QToolTip::hideText();
  }
  update();
}

void CaptureMapView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setFocus(Qt::MouseFocusReason);
  choose(row_at(event->position()));
}

void CaptureMapView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && chosen_) emit open_requested();
}

void CaptureMapView::leaveEvent(QEvent*) {
  hovered_.reset();
  update();
}

void CaptureMapView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return step(-1);
    case Qt::Key_Right:
      return step(1);
    case Qt::Key_Escape:
      return choose(std::nullopt);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (chosen_) emit open_requested();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace netpocket
