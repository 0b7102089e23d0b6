#pragma once
// What lies over the picture: the selection's mark, the measured distance, and what to do when there is nothing to see.

#include <QWidget>
#include <optional>
#include <vector>

#include "gui/workbench/viewport/orbit_camera.h"

namespace netpocket {

class ViewportOverlay : public QWidget {
  Q_OBJECT
 public:
  explicit ViewportOverlay(QWidget* parent);

  void set_camera(const CameraView& view);
  // Points in the world, m.
  void set_selection(const std::optional<Eigen::Vector3d>& point);
  // None, the first or both ends of the measured distance.
  void set_measure(const std::vector<Eigen::Vector3d>& points);
  // In the middle of an empty viewport, and below the picture's top edge.
  void set_message(const QString& message);
  void set_hint(const QString& hint);
  void set_dark(bool dark);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_hint(QPainter& painter) const;
  void paint_selection(QPainter& painter) const;
  void paint_measure(QPainter& painter) const;
  void paint_label(QPainter& painter, const QPointF& center, const QString& text) const;

  OrbitCamera camera_;
  std::optional<Eigen::Vector3d> selection_;
  std::vector<Eigen::Vector3d> measure_;
  QString message_;
  QString hint_;
  bool dark_ = false;
};

}  // namespace netpocket
