#include "gui/workbench/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QToolBar>

#include "gui/workbench/action_icons.h"
#include "gui/workbench/editor/presets.h"
#include "gui/workbench/panels/ask_for_file.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/preferences.h"

namespace netpocket {
namespace {

constexpr qsizetype kMostRecent = 10;
constexpr const char* kRecentKey = "files/recent";

}  // namespace

FileActions::FileActions(ScenarioDocument& document, QSettings& settings, QWidget* window)
    : QObject(window), document_(document), settings_(settings), window_(window) {
  connect(&document_, &ScenarioDocument::path_changed, this, [this](const QString& path) {
    if (!path.isEmpty()) note_recent(path);
  });
}

QAction* FileActions::add(QMenu& menu, const QString& text, const QKeySequence& key, const QString& help) {
  auto* action = menu.addAction(text);
  action->setShortcut(key);
  action->setToolTip(key.isEmpty() ? help : QString("%1 (%2)").arg(help, key.toString(QKeySequence::NativeText)));
  action->setStatusTip(help);
  return action;
}

void FileActions::fill(QMenu& menu, QToolBar& bar) {
  connect(add(menu, tr("&New scenario"), QKeySequence::New, tr("Start from the defaults")), &QAction::triggered, this,
          &FileActions::new_scenario);
  auto* open = add(menu, tr("&Open…"), QKeySequence::Open, tr("Open a scenario (.toml) or a recording (.h5)"));
  open->setIcon(action_icon(ActionIcon::open));
  connect(open, &QAction::triggered, this, &FileActions::ask_to_open);
  auto* presets_menu = menu.addMenu(tr("&Presets"));
  fill_presets(*presets_menu);
  auto* recent_menu = menu.addMenu(tr("Open &recent"));
  connect(recent_menu, &QMenu::aboutToShow, this, [this, recent_menu] { fill_recent(*recent_menu); });
  menu.addSeparator();
  auto* save_action = add(menu, tr("&Save scenario"), QKeySequence::Save, tr("Save the scenario"));
  save_action->setIcon(action_icon(ActionIcon::save));
  connect(save_action, &QAction::triggered, this, &FileActions::save);
  connect(add(menu, tr("Save scenario &as…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S, tr("Save under another name")),
          &QAction::triggered, this, &FileActions::save_as);
  bar.addActions({open, save_action});
}

void FileActions::fill_presets(QMenu& menu) {
  menu.setToolTipsVisible(true);
  for (const Preset& preset : presets()) {
    auto* action = add(menu, preset.name, {}, sentence_of(preset));
    connect(action, &QAction::triggered, this, [this, name = preset.name] { open_preset(name); });
  }
}

void FileActions::fill_recent(QMenu& menu) {
  menu.clear();
  for (const QString& path : recent()) {
    auto* action = menu.addAction(QFileInfo(path).fileName());
    action->setStatusTip(path);
    action->setToolTip(path);
    connect(action, &QAction::triggered, this, [this, path] { emit open_requested(path); });
  }
  if (menu.isEmpty()) menu.addAction(tr("No recent files"))->setEnabled(false);
}

QStringList FileActions::recent() const { return settings_.value(kRecentKey).toStringList(); }

void FileActions::note_recent(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList paths = recent();
  paths.removeAll(absolute);
  paths.prepend(absolute);
  settings_.setValue(kRecentKey, paths.mid(0, kMostRecent));
}

void FileActions::new_scenario() {
  if (may_discard()) document_.start_from(Scenario{});
}

void FileActions::ask_to_open() {
  const QString folder = document_.path().isEmpty() ? read_preferences(settings_).folder_for_new_files()
                                                    : QFileInfo(document_.path()).path();
  const QString path = QFileDialog::getOpenFileName(
      window_, tr("Open"), folder, tr("Scenarios and recordings (*.toml *.h5);;Scenarios (*.toml);;Recordings (*.h5)"));
  if (!path.isEmpty()) emit open_requested(path);
}

bool FileActions::open_preset(const QString& name) {
  for (const Preset& preset : presets()) {
    if (preset.name != name || !may_discard()) continue;
    const Diagnostics problems = document_.start_from(preset.text);
    if (!problems.ok()) emit problem(diagnostics_words(problems));
    return problems.ok();
  }
  return false;
}

bool FileActions::save() {
  if (!commit_()) return false;
  if (document_.path().isEmpty()) return save_as();
  const auto refusal = document_.save();
  if (refusal) emit problem(*refusal);
  return !refusal;
}

bool FileActions::save_as() {
  if (!commit_()) return false;
  const QDir folder(read_preferences(settings_).folder_for_new_files());
  const QString name = document_.path().isEmpty()
                           ? folder.filePath(QString::fromStdString(document_.scenario().name) + ".toml")
                           : document_.path();
  const QString path = ask_for_path(window_, {tr("Save scenario"), name, tr("Scenarios (*.toml)"), "toml"});
  if (path.isEmpty()) return false;
  const auto refusal = document_.save_as(path);
  if (refusal) emit problem(*refusal);
  return !refusal;
}

bool FileActions::may_discard() {
  if (!document_.is_modified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("Save the changes to \"%1\"?").arg(document_.display_name()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setInformativeText(tr("Otherwise they are lost."));
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

}  // namespace netpocket
