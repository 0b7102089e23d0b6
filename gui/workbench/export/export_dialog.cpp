#include "gui/workbench/export/export_dialog.h"

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
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <array>

namespace netpocket {
namespace {

struct KindEntry {
  const char* name;
  const char* target;  // appended to the run's name
  bool draws;          // size, camera, colours matter
  bool rate;           // frames a second matter
};

constexpr std::array kKinds = {
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "Pictures (PNG)"), "_frames", true, true},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "Video (MP4)"), ".mp4", true, true},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "Contact sheet (PNG)"), "_sheet.png", true, false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "This moment in three dimensions (glTF)"), ".glb", false,
              false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "Report (HTML)"), ".html", false, false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "Figures of the paper"), "_figures", false, false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "Channels (CSV)"), "_csv", false, false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "ParaView series"), "_paraview", false, false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "ParaView files with time steps (VTKHDF)"), "_vtkhdf", false,
              false},
    KindEntry{QT_TRANSLATE_NOOP("netpocket::ExportDialog", "The whole capture in three dimensions (glTF)"), ".glb",
              false, false},
};

QComboBox* make_choice(const std::initializer_list<std::pair<QString, QString>>& entries) {
  auto* choice = new QComboBox;
  for (const auto& [text, value] : entries) choice->addItem(text, value);
  return choice;
}

}  // namespace

ExportDialog::ExportDialog(const QString& folder, const QString& name, const ShownView& shown, QWidget* parent)
    : QDialog(parent),
      folder_(folder.isEmpty() ? QDir::homePath() : folder),
      name_(QString(name).replace(QRegularExpression("[^A-Za-z0-9._-]+"), "_")),
      shown_(shown),
      kind_(new QComboBox),
      target_(new QLineEdit),
      form_(new QFormLayout(this)),
      size_(make_choice({{"1280 × 720", "1280x720"}, {"1920 × 1080", "1920x1080"}, {"3840 × 2160", "3840x2160"}})),
      rate_(new QDoubleSpinBox),
      camera_(make_choice({{tr("As in the view"), ""},
                           {tr("Oblique"), "iso"},
                           {tr("Side"), "side"},
                           {tr("Front"), "front"},
                           {tr("Mouth"), "mouth"},
                           {tr("Follow"), "follow"}})),
      colors_(make_choice({{tr("Plain colours"), "none"},
                           {tr("Tension"), "tension"},
                           {tr("Strain"), "strain"},
                           {tr("Speed"), "speed"},
                           {tr("Contact force"), "contact"}})),
      background_(make_choice({{tr("White"), "white"}, {tr("Space"), "space"}})),
      format_(make_choice({{"PDF", "pdf"}, {"SVG", "svg"}, {"PNG", "png"}})),
      tables_(new QCheckBox(tr("beside each figure, as CSV"))),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  setWindowTitle(tr("Export"));
  for (const KindEntry& entry : kKinds) kind_->addItem(tr(entry.name));
  colors_->setCurrentIndex(static_cast<int>(shown_.display.color_by));
  background_->setCurrentIndex(shown_.display.background == Background::space ? 1 : 0);
  rate_->setRange(0.1, 1000);
  rate_->setValue(25);
  rate_->setDecimals(1);
  rate_->setSuffix(tr(" per simulated second"));
  form_->addRow(tr("&What:"), kind_);
  form_->addRow(tr("&To:"), make_target_row());
  qobject_cast<QLabel*>(form_->labelForField(target_->parentWidget()))->setBuddy(target_);
  form_->addRow(tr("&Pictures:"), rate_);
  form_->addRow(tr("&Size:"), size_);
  form_->addRow(tr("&Camera:"), camera_);
  form_->addRow(tr("C&olours:"), colors_);
  form_->addRow(tr("&Background:"), background_);
  form_->addRow(tr("&Format:"), format_);
  form_->addRow(tr("&Numbers:"), tables_);
  form_->addRow(buttons_);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Export"));
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(kind_, &QComboBox::currentIndexChanged, this, &ExportDialog::kind_changed);
  connect(target_, &QLineEdit::textChanged, this, [this](const QString& text) {
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(!text.trimmed().isEmpty());
  });
  target_->setAccessibleName(tr("File or folder to export to"));
  kind_changed();
  setMinimumWidth(460);
}

QWidget* ExportDialog::make_target_row() {
  auto* row = new QWidget;
  auto* browse_button = new QPushButton(tr("Browse…"));
  browse_button->setAutoDefault(false);
  connect(browse_button, &QPushButton::clicked, this, &ExportDialog::browse);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(target_, 1);
  layout->addWidget(browse_button);
  return row;
}

void ExportDialog::propose(const QSize& size, double rate) {
  const QString value = QString("%1x%2").arg(size.width()).arg(size.height());
  if (size_->findData(value) < 0) size_->addItem(QString(value).replace("x", QString::fromUtf8(" × ")), value);
  size_->setCurrentIndex(size_->findData(value));
  rate_->setValue(rate);
}

void ExportDialog::choose(ExportKind kind) { kind_->setCurrentIndex(static_cast<int>(kind)); }
ExportKind ExportDialog::kind() const { return static_cast<ExportKind>(kind_->currentIndex()); }
void ExportDialog::set_target(const QString& path) { target_->setText(QDir::toNativeSeparators(path)); }
QString ExportDialog::target() const { return target_->text().trimmed(); }
QString ExportDialog::label() const { return kind_->currentText(); }

void ExportDialog::kind_changed() {
  const KindEntry& entry = kKinds[static_cast<std::size_t>(kind_->currentIndex())];
  // In the folder that was chosen last.
  if (!target().isEmpty()) folder_ = QFileInfo(target()).path();
  set_target(QDir(folder_).filePath(name_ + entry.target));
  const auto show = [this](QWidget* field, bool shown) {
    field->setVisible(shown);
    form_->labelForField(field)->setVisible(shown);
  };
  for (QWidget* field : {static_cast<QWidget*>(size_), static_cast<QWidget*>(camera_), static_cast<QWidget*>(colors_),
                         static_cast<QWidget*>(background_)}) {
    show(field, entry.draws);
  }
  show(rate_, entry.rate);
  show(format_, kind() == ExportKind::figures);
  show(tables_, kind() == ExportKind::figures);
  adjustSize();
}

void ExportDialog::browse() {
  const bool is_file = kind() == ExportKind::video || kind() == ExportKind::sheet || kind() == ExportKind::moment ||
                       kind() == ExportKind::report || kind() == ExportKind::animation;
  const auto asks_later = QFileDialog::DontConfirmOverwrite;
  const QString path = is_file ? QFileDialog::getSaveFileName(this, tr("Export to"), target(), {}, nullptr, asks_later)
                               : QFileDialog::getExistingDirectory(this, tr("Export to"), folder_);
  if (!path.isEmpty()) set_target(path);
}

void ExportDialog::accept() {
  const QFileInfo place(target());
  const bool taken = place.isDir() ? !QDir(target()).isEmpty() : place.exists();
  if (taken) {
    QMessageBox box(QMessageBox::Question, tr("Export"), tr("\"%1\" exists already.").arg(target()),
                    QMessageBox::Yes | QMessageBox::Cancel, this);
    box.setInformativeText(place.isDir() ? tr("Files in it that have the same names will be replaced.")
                                         : tr("It will be replaced."));
    box.button(QMessageBox::Yes)->setText(tr("Replace"));
    box.setDefaultButton(QMessageBox::Cancel);
    if (box.exec() != QMessageBox::Yes) return;
  }
  QDialog::accept();
}

bool ExportDialog::uses_view() const {
  return kKinds[static_cast<std::size_t>(kind_->currentIndex())].draws && camera_->currentData().toString().isEmpty();
}

QStringList ExportDialog::look_arguments(const QString& view_file) const {
  const auto value = [](const QComboBox* choice) { return choice->currentData().toString(); };
  QStringList arguments{"--color-by", value(colors_), "--background", value(background_)};
  arguments << (uses_view() ? QStringList{"--view", view_file} : QStringList{"--camera", value(camera_)});
  const DisplayOptions& display = shown_.display;
  if (display.contact_arrows) arguments << "--arrows";
  if (display.trails) arguments << "--trails";
  if (display.ghost) arguments << "--ghost";
  if (display.target_opacity < 1) arguments << "--target-opacity" << QString::number(display.target_opacity);
  return arguments;
}

QStringList ExportDialog::arguments(const QString& recording, const QString& view_file) const {
  switch (kind()) {
    case ExportKind::figures:
      return QStringList{"plot", recording, "-o", target(), "--format", format_->currentData().toString()}
             << (tables_->isChecked() ? QStringList{"--csv"} : QStringList());
    case ExportKind::csv:
      return {"export", recording, "--csv", target()};
    case ExportKind::paraview:
      return {"export", recording, "--vtp", target()};
    case ExportKind::paraview_steps:
      return {"export", recording, "--vtkhdf", target()};
    case ExportKind::animation:
      return {"export", recording, "--gltf", target()};
    case ExportKind::report:
      return {"report", recording, "-o", target()};
    case ExportKind::moment:
      return {"render", recording, "--times", QString::number(shown_.time, 'g', 12), "--gltf", target()};
    default:
      break;
  }
  QStringList arguments{"render", recording};
  arguments << look_arguments(view_file);
  if (kind() == ExportKind::sheet) return arguments << "--sheet" << target();
  arguments << "--size" << size_->currentData().toString() << "--fps" << QString::number(rate_->value());
  return arguments << (kind() == ExportKind::video ? "--video" : "-o") << target();
}

}  // namespace netpocket
