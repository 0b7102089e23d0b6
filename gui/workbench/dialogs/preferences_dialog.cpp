#include "gui/workbench/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

namespace netpocket {
namespace {

QLabel* make_note(const QString& text) {
  auto* note = new QLabel(text);
  note->setWordWrap(true);
  note->setForegroundRole(QPalette::PlaceholderText);
  return note;
}

// Languages are called what they call themselves, so that everybody finds the own one.
QComboBox* make_languages(const QString& system) {
  auto* choice = new QComboBox;
  choice->addItem(system, kSystemLanguage);
  for (const Language& language : languages()) choice->addItem(language.name, language.code);
  return choice;
}

}  // namespace

PreferencesDialog::PreferencesDialog(const Preferences& preferences, std::size_t used_bytes, QWidget* parent)
    : QDialog(parent),
      cache_(new QSpinBox),
      threads_(new QSpinBox),
      presenter_(new QComboBox),
      ask_(new QCheckBox(tr("Ask before unsaved runs are lost"))),
      language_(make_languages(tr("As the system"))) {
  setWindowTitle(tr("Preferences"));
  cache_->setRange(Preferences::kSmallestCache, Preferences::kLargestCache);
  cache_->setSingleStep(128);
  cache_->setSuffix(tr(" MiB"));
  threads_->setRange(1, most_threads());
  presenter_->addItems({tr("Automatic"), tr("OpenGL in the window"), tr("Images drawn in the background")});
  auto* form = new QFormLayout;
  form->setVerticalSpacing(5);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Frames in memory:"), cache_);
  form->addRow(QString(),
               make_note(tr("%1 MiB are in use. Older frames are read from the recording when they are shown.")
                             .arg(used_bytes >> 20)));
  form->addRow(tr("&Threads of a simulation:"), threads_);
  form->addRow(QString(),
               make_note(tr("From the next run on. The result is the same for any number; one is fastest for "
                            "pockets of the usual size.")));
  form->addRow(tr("&Drawing:"), presenter_);
  form->addRow(QString(), make_note(tr("From the next start on.")));
  form->addRow(tr("&Language:"), language_);
  form->addRow(QString(), make_note(tr("Of the window, from the next start on. Commands and files stay English.")));
  form->addRow(QString(), ask_);
  auto* buttons =
      new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] { fill({}); });
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  layout->addLayout(form);
  layout->addWidget(buttons);
  setMinimumWidth(460);
  fill(preferences);
}

void PreferencesDialog::fill(const Preferences& preferences) {
  cache_->setValue(preferences.cache_mebibytes);
  threads_->setValue(preferences.threads);
  presenter_->setCurrentIndex(static_cast<int>(preferences.presenter));
  ask_->setChecked(preferences.ask_about_runs);
  language_->setCurrentIndex(std::max(0, language_->findData(preferences.language)));
}

Preferences PreferencesDialog::preferences() const {
  return {cache_->value(), threads_->value(), static_cast<PresenterKind>(presenter_->currentIndex()), ask_->isChecked(),
          language_->currentData().toString()};
}

}  // namespace netpocket
