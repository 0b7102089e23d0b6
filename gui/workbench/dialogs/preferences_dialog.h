#pragma once
// Asks for the preferences.

#include <QDialog>

#include "gui/workbench/preferences.h"

class QCheckBox;
class QComboBox;
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

  QSpinBox* cache_;
  QSpinBox* threads_;
  QComboBox* presenter_;
  QCheckBox* ask_;
  QComboBox* language_;
};

}  // namespace netpocket
