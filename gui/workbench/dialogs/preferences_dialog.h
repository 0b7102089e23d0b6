#pragma once
// Asks for the preferences.

#include <QDialog>

#include "gui/workbench/preferences.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;

namespace netpocket {

class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  // `used_bytes`: of frames in memory now.
  PreferencesDialog(const Preferences& preferences, std::size_t used_bytes, QWidget* parent);

  Preferences preferences() const;

 private:
  void fill(const Preferences& preferences);
  QWidget* make_window_page();
  QWidget* make_pictures_page();
  void browse();

  QComboBox* type_size_;
  QComboBox* theme_;
  QComboBox* beginning_;
  QLineEdit* folder_;
  QComboBox* export_size_;
  QDoubleSpinBox* export_rate_;
  QComboBox* film_rate_;
  QSpinBox* cache_;
  QSpinBox* threads_;
  QComboBox* presenter_;
  QCheckBox* ask_;
  QComboBox* language_;
};

}  // namespace netpocket
