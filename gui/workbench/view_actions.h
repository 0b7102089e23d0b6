#pragma once
// Where from and how the pocket is looked at: cameras and display options.

#include <QActionGroup>
#include <QObject>
#include <QSettings>

#include "gui/workbench/viewport/viewport.h"

class QAction;
class QMenu;
class QToolBar;

namespace netpocket {

class ViewActions : public QObject {
  Q_OBJECT
 public:
  ViewActions(Viewport& viewport, QSettings& settings, QWidget* window);

  void fill(QMenu& menu, QToolBar& bar);
  // Puts what the run brings along into the options, e.g. the times of its phases.
  void set_phases(const std::vector<Phase>& phases);
  // Of labels, legend, scale bar and axes, against the usual size.
  void set_annotation_scale(double scale);
  // Light or dark of the window, or the size of its letters, has changed.
  void follow_theme();
  const SceneOptions& options() const { return options_; }
  QAction* move_action() const { return move_; }
  QAction* second_view_action() const { return second_; }

 signals:
  void options_changed(const netpocket::SceneOptions& options);
  void moving_toggled(bool on);
  void second_view_toggled(bool on);

 private:
  enum class Ground { theme, white, space };

  QAction* add(QMenu& menu, const QString& text, const QKeySequence& key, const QString& help);
  void add_cameras(QMenu& menu, QToolBar& bar);
  void add_saved_cameras(QMenu& menu);
  void add_colors(QMenu& menu, QToolBar& bar);
  void add_display(QMenu& menu);
  void add_switch(QMenu& menu, const char* key, const QString& text, const QKeySequence& shortcut,
                  bool SceneOptions::*option, const QString& help);
  void add_see_through(QMenu& menu);
  void save_camera(int slot);
  void recall_camera(int slot);
  void apply();

  Viewport& viewport_;
  QSettings& settings_;
  SceneOptions options_;
  double annotation_scale_ = 1;
  Ground ground_ = Ground::theme;
  QAction* follow_ = nullptr;
  QAction* move_ = nullptr;
  QAction* second_ = nullptr;
};

}  // namespace netpocket
