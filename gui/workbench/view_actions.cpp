#include "gui/workbench/view_actions.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QToolBar>
#include <algorithm>
#include <array>

#include "gui/workbench/action_icons.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/panels/window_look.h"
#include "gui/workbench/viewport/camera_names.h"
#include "render/scene/color_scale.h"

namespace netpocket {
namespace {

constexpr int kSavedCameras = 4;
constexpr double kAnnotationScale = 0.9;

QString key_of(int slot) { return QString("view/camera%1").arg(slot); }

QVariantList numbers(const CameraView& view) {
  QVariantList list;
  for (const Eigen::Vector3d& v : {view.position, view.focal_point, view.view_up}) list << v.x() << v.y() << v.z();
  return list << view.view_angle << view.half_height;
}

std::optional<CameraView> view_from(const QVariantList& list) {
  if (list.size() != 11) return std::nullopt;
  const auto vector = [&](int i) {
    return Eigen::Vector3d(list[i].toDouble(), list[i + 1].toDouble(), list[i + 2].toDouble());
  };
  CameraView view{vector(0), vector(3), vector(6), list[9].toDouble(), list[10].toDouble()};
  const bool sound = view.position.allFinite() && (view.position - view.focal_point).norm() > 0 && view.view_angle > 0;
  return sound ? std::optional(view) : std::nullopt;
}

}  // namespace

ViewActions::ViewActions(Viewport& viewport, QSettings& settings, QWidget* window)
    : QObject(window), viewport_(viewport), settings_(settings) {
  options_.color_by = static_cast<ColorBy>(std::clamp(settings.value("view/color_by", 0).toInt(), 0, 4));
  ground_ = static_cast<Ground>(std::clamp(settings.value("view/ground", 0).toInt(), 0, 2));
  options_.legend_ground = true;
  options_.fast_smoothing = true;
  apply();
}

QAction* ViewActions::add(QMenu& menu, const QString& text, const QKeySequence& key, const QString& help) {
  auto* action = menu.addAction(text);
  action->setShortcut(key);
  action->setToolTip(key.isEmpty() ? help : QString("%1 (%2)").arg(help, key.toString(QKeySequence::NativeText)));
  action->setStatusTip(help);
  return action;
}

void ViewActions::fill(QMenu& menu, QToolBar& bar) {
  add_cameras(menu, bar);
  menu.addSeparator();
  add_colors(menu, bar);
  add_display(menu);
}

void ViewActions::add_cameras(QMenu& menu, QToolBar& bar) {
  auto* choice = new QComboBox;
  choice->setToolTip(tr("Where from (1 to 5)"));
  choice->setAccessibleName(tr("Camera"));
  for (int i = 0; i < static_cast<int>(kCameraPresets.size()); ++i) {
    const CameraPreset preset = kCameraPresets[static_cast<std::size_t>(i)];
    auto* action = add(menu, camera_name(preset), QKeySequence(Qt::Key_1 + i), camera_help(preset));
    choice->addItem(camera_name(preset));
    connect(action, &QAction::triggered, this, [this, preset] {
      follow_->setChecked(preset == CameraPreset::follow);
      viewport_.set_preset(preset);
    });
    connect(choice, &QComboBox::activated, action, [action, i](int index) {
      if (index == i) action->trigger();
    });
  }
  choice->setPlaceholderText(tr("Free"));
  connect(&viewport_, &Viewport::view_changed, choice, [this, choice] {
    const auto preset = std::ranges::find(kCameraPresets, viewport_.preset());
    choice->setCurrentIndex(preset == kCameraPresets.end() ? -1 : static_cast<int>(preset - kCameraPresets.begin()));
  });
  auto* fit = add(menu, tr("Fit"), Qt::Key_F, tr("Show everything, from where one looks now"));
  fit->setIcon(action_icon(ActionIcon::fit));
  connect(fit, &QAction::triggered, &viewport_, &Viewport::fit);
  follow_ = add(menu, tr("Follow target"), Qt::Key_T, tr("Let the camera move with the target"));
  follow_->setIcon(action_icon(ActionIcon::follow));
  follow_->setCheckable(true);
  connect(follow_, &QAction::toggled, &viewport_, &Viewport::set_follow_target);
  auto* measure = add(menu, tr("Measure distance"), Qt::Key_D, tr("Click two points to measure their distance"));
  measure->setIcon(action_icon(ActionIcon::measure));
  measure->setCheckable(true);
  connect(measure, &QAction::toggled, &viewport_, &Viewport::set_measuring);
  move_ = add(menu, tr("Move bodies"), Qt::Key_G, tr("Drag the target or the spacecraft to where the capture starts"));
  move_->setIcon(action_icon(ActionIcon::move));
  move_->setCheckable(true);
  connect(move_, &QAction::toggled, this, &ViewActions::moving_toggled);
  // One tool at a time.
  connect(move_, &QAction::toggled, measure, [measure](bool on) {
    if (on) measure->setChecked(false);
  });
  connect(measure, &QAction::toggled, move_, [this](bool on) {
    if (on) move_->setChecked(false);
  });
  second_ = add(menu, tr("Second view"), Qt::Key_V, tr("Another view beside this one, of this run or of another"));
  second_->setIcon(action_icon(ActionIcon::split));
  second_->setCheckable(true);
  connect(second_, &QAction::toggled, this, &ViewActions::second_view_toggled);
  add_saved_cameras(menu);
  bar.addWidget(choice);
  bar.addActions({fit, follow_, measure, move_, second_});
}

void ViewActions::add_saved_cameras(QMenu& menu) {
  auto* saved = menu.addMenu(tr("Saved cameras"));
  saved->setToolTipsVisible(true);
  for (int slot = 0; slot < kSavedCameras; ++slot) {
    const Qt::Key key = static_cast<Qt::Key>(Qt::Key_6 + slot);
    auto* recall = add(*saved, tr("Camera %1").arg(slot + 1), key, tr("Go back to a saved camera"));
    connect(recall, &QAction::triggered, this, [this, slot] { recall_camera(slot); });
    auto* save = add(*saved, tr("Save as camera %1").arg(slot + 1), Qt::CTRL | Qt::SHIFT | key, tr("Save this camera"));
    connect(save, &QAction::triggered, this, [this, slot] { save_camera(slot); });
  }
}

void ViewActions::save_camera(int slot) { settings_.setValue(key_of(slot), numbers(viewport_.view())); }

void ViewActions::recall_camera(int slot) {
  if (const auto view = view_from(settings_.value(key_of(slot)).toList())) viewport_.set_view(*view);
}

void ViewActions::add_colors(QMenu& menu, QToolBar& bar) {
  auto* choice = new QComboBox;
  choice->setToolTip(tr("What the colours of cords and rods show (C)"));
  choice->setAccessibleName(tr("Colours"));
  choice->addItems({tr("Plain colours"), tr("Tension"), tr("Strain"), tr("Speed"), tr("Contact force")});
  choice->setCurrentIndex(static_cast<int>(options_.color_by));
  connect(choice, &QComboBox::currentIndexChanged, this, [this](int index) {
    options_.color_by = static_cast<ColorBy>(index);
    settings_.setValue("view/color_by", index);
    apply();
  });
  bar.addWidget(choice);
  auto* colors = menu.addMenu(tr("Colours"));
  auto* next = add(*colors, tr("Next colours"), Qt::Key_C, tr("Colour by the next quantity"));
  connect(next, &QAction::triggered, choice,
          [choice] { choice->setCurrentIndex((choice->currentIndex() + 1) % choice->count()); });
  for (int i = 0; i < choice->count(); ++i) {
    connect(add(*colors, choice->itemText(i), {}, tr("Colour cords and rods")), &QAction::triggered, choice,
            [choice, i] { choice->setCurrentIndex(i); });
  }
}

void ViewActions::add_see_through(QMenu& menu) {
  constexpr double kSeeThrough = 0.35;
  auto* action = add(menu, tr("See through the target"), Qt::Key_O, tr("Let what is behind the target shine through"));
  action->setCheckable(true);
  connect(action, &QAction::toggled, this, [this](bool on) {
    options_.target_opacity = on ? kSeeThrough : 1;
    settings_.setValue("view/see_through", on);
    apply();
  });
  action->setChecked(settings_.value("view/see_through", false).toBool());
}

void ViewActions::add_switch(QMenu& menu, const char* key, const QString& text, const QKeySequence& shortcut,
                             bool SceneOptions::*option, const QString& help) {
  auto* action = add(menu, text, shortcut, help);
  options_.*option = settings_.value(key, options_.*option).toBool();
  action->setCheckable(true);
  action->setChecked(options_.*option);
  connect(action, &QAction::toggled, this, [this, option, key](bool on) {
    options_.*option = on;
    settings_.setValue(key, on);
    apply();
  });
}

void ViewActions::add_display(QMenu& menu) {
  auto* display = menu.addMenu(tr("Show"));
  add_switch(*display, "view/contact forces", tr("Contact forces"), Qt::Key_A, &SceneOptions::contact_arrows,
             tr("Show the force of each contact as an arrow"));
  add_switch(*display, "view/trails", tr("Trails"), Qt::Key_R, &SceneOptions::trails,
             tr("Show where the centres of mass have been so far"));
  add_switch(*display, "view/initial shape", tr("Initial shape"), Qt::Key_I, &SceneOptions::ghost,
             tr("Show the pocket as it was at the start, too"));
  add_see_through(*display);
  display->addSeparator();
  add_switch(*display, "view/legend", tr("Legend"), {}, &SceneOptions::legend, tr("Show what the colours mean"));
  add_switch(*display, "view/time", tr("Time"), {}, &SceneOptions::time_label, tr("Show the time in the picture"));
  add_switch(*display, "view/scale bar", tr("Scale bar"), {}, &SceneOptions::scale_bar, tr("Show how long a metre is"));
  add_switch(*display, "view/axes", tr("Axes"), {}, &SceneOptions::axes, tr("Show the world's directions"));
  add_switch(*display, "view/smooth lines", tr("Smooth lines"), {}, &SceneOptions::fast_smoothing,
             tr("Smooth edges; off: faster"));
  auto* ground = menu.addMenu(tr("Background"));
  auto* group = new QActionGroup(this);
  const std::array names = {tr("As the window"), tr("White"), tr("Space")};
  for (int i = 0; i < 3; ++i) {
    auto* action = add(*ground, names[static_cast<std::size_t>(i)], {}, tr("Background of the picture"));
    action->setCheckable(true);
    action->setChecked(static_cast<int>(ground_) == i);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, i] {
      ground_ = static_cast<Ground>(i);
      settings_.setValue("view/ground", i);
      apply();
    });
  }
  apply();
}

void ViewActions::set_phases(const std::vector<Phase>& phases) {
  std::vector<Phase> shown = phases;
  for (Phase& phase : shown) phase.name = engine_words(phase.name).toStdString();
  if (shown == options_.phases) return;
  options_.phases = std::move(shown);
  apply();
}

void ViewActions::set_annotation_scale(double scale) {
  annotation_scale_ = scale;
  apply();
}

void ViewActions::follow_theme() { apply(); }

void ViewActions::apply() {
  const bool dark = ground_ == Ground::space || (ground_ == Ground::theme && is_dark(QApplication::palette()));
  options_.annotation_scale = kAnnotationScale * annotation_scale_ * type_scale();
  options_.background = dark ? Background::space : Background::white;
  options_.legend_title = engine_words(color_label(options_.color_by)).toStdString();
  viewport_.set_options(options_);
  emit options_changed(options_);
}

}  // namespace netpocket
