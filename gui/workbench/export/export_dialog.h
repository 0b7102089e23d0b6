#pragma once
// Asks what to export of a run, how and where to.

#include <QDialog>
#include <QStringList>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;

namespace netpocket {

enum class ExportKind { pictures, video, sheet, figures, csv, paraview };

class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  // `folder`: where to propose to write; `name`: of the run.
  ExportDialog(const QString& folder, const QString& name, QWidget* parent);

  void choose(ExportKind kind);
  ExportKind kind() const;
  void set_target(const QString& path);
  QString target() const;
  // What the job is called, and the arguments of the program for a recording.
  QString label() const;
  QStringList arguments(const QString& recording) const;

 private:
  QWidget* make_target_row();
  void kind_changed();
  void browse();

  QString folder_;
  QString name_;
  QComboBox* kind_;
  QLineEdit* target_;
  QFormLayout* form_;
  QComboBox* size_;
  QDoubleSpinBox* rate_;
  QComboBox* camera_;
  QComboBox* colors_;
  QComboBox* background_;
  QComboBox* format_;
  QDialogButtonBox* buttons_;
};

}  // namespace netpocket
