#include "gui/workbench/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
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

QString size_words(const QSize& size) { return QString::fromUtf8("%1 × %2").arg(size.width()).arg(size.height()); }

}  // namespace

PreferencesDialog::PreferencesDialog(const Preferences& preferences, std::size_t used_bytes, QWidget* parent)
    : QDialog(parent),
      type_size_(new QComboBox),
      theme_(new QComboBox),
      beginning_(new QComboBox),
      folder_(new QLineEdit),
      export_size_(new QComboBox),
      export_rate_(new QDoubleSpinBox),
      film_rate_(new QComboBox),
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
  form->addRow(QString(), ask_);
  auto* buttons =
      new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] { fill({}); });
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  auto* simulation = new QWidget;
  simulation->setLayout(form);
  auto* pages = new QTabWidget;
  pages->setAccessibleName(tr("Kinds of preferences"));
  pages->addTab(make_window_page(), tr("Window"));
  pages->addTab(make_pictures_page(), tr("Pictures and videos"));
  pages->addTab(simulation, tr("Simulation and drawing"));
  layout->addWidget(pages);
  layout->addWidget(buttons);
  // Tab comes to the first of the buttons and would leave out those that were made before it.
  setTabOrder(buttons->button(QDialogButtonBox::RestoreDefaults), buttons->button(QDialogButtonBox::Ok));
  setTabOrder(buttons->button(QDialogButtonBox::Ok), buttons->button(QDialogButtonBox::Cancel));
  setMinimumWidth(460);
  fill(preferences);
}

QWidget* PreferencesDialog::make_window_page() {
  type_size_->addItems({tr("Normal"), tr("Larger"), tr("Largest")});
  theme_->addItems({tr("As the desktop"), tr("Light"), tr("Dark")});
  beginning_->addItems({tr("The start page"), tr("The file used last"), tr("A new scenario")});
  folder_->setPlaceholderText(QDir::toNativeSeparators(QDir::homePath()));
  auto* browse_button = new QPushButton(tr("Browse…"));
  browse_button->setAutoDefault(false);
  connect(browse_button, &QPushButton::clicked, this, &PreferencesDialog::browse);
  auto* folder_row = new QHBoxLayout;
  folder_row->addWidget(folder_, 1);
  folder_row->addWidget(browse_button);
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("T&ype size:"), type_size_);
  form->addRow(tr("&Colours:"), theme_);
  form->addRow(tr("&Language:"), language_);
  form->addRow(QString(), make_note(tr("Of the window, from the next start on. Commands and files stay English.")));
  form->addRow(tr("&Begin with:"), beginning_);
  auto* folder_label = new QLabel(tr("F&older for new files:"));
  folder_label->setBuddy(folder_);
  form->addRow(folder_label, folder_row);
  return page;
}

QWidget* PreferencesDialog::make_pictures_page() {
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)}) {
    export_size_->addItem(size_words(size), size);
  }
  export_rate_->setRange(Preferences::kLeastRate, Preferences::kMostRate);
  export_rate_->setDecimals(1);
  export_rate_->setSuffix(tr(" per simulated second"));
  for (const int rate : {25, 30}) film_rate_->addItem(tr("%1 pictures a second").arg(rate), rate);
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Size of exports:"), export_size_);
  form->addRow(tr("&Pictures of exports:"), export_rate_);
  form->addRow(QString(), make_note(tr("What the export dialog proposes.")));
  form->addRow(tr("&Videos of the window:"), film_rate_);
  return page;
}

void PreferencesDialog::browse() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Folder for new files"), folder_->text());
  if (!path.isEmpty()) folder_->setText(QDir::toNativeSeparators(path));
}

void PreferencesDialog::fill(const Preferences& preferences) {
  type_size_->setCurrentIndex(static_cast<int>(preferences.type_size));
  theme_->setCurrentIndex(static_cast<int>(preferences.theme));
  beginning_->setCurrentIndex(static_cast<int>(preferences.beginning));
  folder_->setText(QDir::toNativeSeparators(preferences.folder));
  if (export_size_->findData(preferences.export_size) < 0) {
    export_size_->addItem(size_words(preferences.export_size), preferences.export_size);
  }
  export_size_->setCurrentIndex(export_size_->findData(preferences.export_size));
  export_rate_->setValue(preferences.export_rate);
  film_rate_->setCurrentIndex(std::max(0, film_rate_->findData(preferences.film_rate)));
  cache_->setValue(preferences.cache_mebibytes);
  threads_->setValue(preferences.threads);
  presenter_->setCurrentIndex(static_cast<int>(preferences.presenter));
  ask_->setChecked(preferences.ask_about_runs);
  language_->setCurrentIndex(std::max(0, language_->findData(preferences.language)));
}

Preferences PreferencesDialog::preferences() const {
  Preferences chosen;
  chosen.cache_mebibytes = cache_->value();
  chosen.threads = threads_->value();
  chosen.presenter = static_cast<PresenterKind>(presenter_->currentIndex());
  chosen.ask_about_runs = ask_->isChecked();
  chosen.language = language_->currentData().toString();
  chosen.type_size = static_cast<TypeSize>(type_size_->currentIndex());
  chosen.theme = static_cast<Theme>(theme_->currentIndex());
  chosen.beginning = static_cast<Beginning>(beginning_->currentIndex());
  chosen.folder = QDir::fromNativeSeparators(folder_->text().trimmed());
  chosen.export_size = export_size_->currentData().toSize();
  chosen.export_rate = export_rate_->value();
  chosen.film_rate = film_rate_->currentData().toInt();
  return chosen;
}

}  // namespace netpocket
