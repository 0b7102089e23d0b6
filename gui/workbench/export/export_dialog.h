#pragma once
// Asks what to export of a run, how and where to.

#include <QDialog>
#include <QStringList>

#include "render/scene/camera.h"
#include "render/scene/scene_options.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;

namespace netpocket {

enum class ExportKind { pictures, video, sheet, moment, report, figures, csv, paraview, paraview_steps, animation };

// What the view shows, which pictures may show alike.
struct ShownView {
  CameraView camera;
  DisplayOptions display;
  double time = 0;  // s
};

class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  // `folder`: where to propose to write; `name`: of the run.
  ExportDialog(const QString& folder, const QString& name, const ShownView& shown, QWidget* parent);

  // Proposes a size (pixels) and pictures per simulated second.
  void propose(const QSize& size, double rate);
  void choose(ExportKind kind);
  ExportKind kind() const;
  void set_target(const QString& path);
  QString target() const;
  // What the job is called, and the arguments of the program for a recording.
  QString label() const;
  // The camera of the view, if it is chosen, is written to the file `view_file` names.
  QStringList arguments(const QString& recording, const QString& view_file) const;
  // Whether arguments() needs the view's camera.
  bool uses_view() const;
  const CameraView& view() const { return shown_.camera; }

  // Asks first when something is there already that would be replaced.
  void accept() override;

 private:
  QWidget* make_target_row();
  void kind_changed();
  void browse();
  QStringList look_arguments(const QString& view_file) const;

  QString folder_;
  QString name_;
  ShownView shown_;
  QComboBox* kind_;
  QLineEdit* target_;
  QFormLayout* form_;
  QComboBox* size_;
  QDoubleSpinBox* rate_;
  QComboBox* camera_;
  QComboBox* colors_;
  QComboBox* background_;
  QComboBox* format_;
  QCheckBox* tables_;
  QDialogButtonBox* buttons_;
};

}  // namespace netpocket
