#pragma once
// Opening and saving: scenarios, recordings, presets, recent files.

#include <QObject>
#include <QSettings>
#include <QStringList>
#include <functional>
#include <utility>

#include "gui/workbench/editor/scenario_document.h"

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace netpocket {

class FileActions : public QObject {
  Q_OBJECT
 public:
  FileActions(ScenarioDocument& document, QSettings& settings, QWidget* window);

  // To be called before saving: takes over what is being typed, or says why not and returns false.
  void set_commit(std::function<bool()> commit) { commit_ = std::move(commit); }

  // Adds to the menu, before what the window itself adds.
  void fill(QMenu& menu, QToolBar& bar);
  void note_recent(const QString& path);
  QStringList recent() const;

  // Saves; asks for a name when there is none. False: not saved.
  bool save();
  bool save_as();
  // Whether unsaved changes may go: saved, or given up on purpose.
  bool may_discard();
  // False: not opened.
  bool open_preset(const QString& name);
  void ask_to_open();
  void new_scenario();

 signals:
  void open_requested(const QString& path);
  void problem(const QString& sentence);

 private:
  QAction* add(QMenu& menu, const QString& text, const QKeySequence& key, const QString& help);
  void fill_presets(QMenu& menu);
  void fill_recent(QMenu& menu);

  ScenarioDocument& document_;
  QSettings& settings_;
  QWidget* window_;
  std::function<bool()> commit_ = [] { return true; };
};

}  // namespace netpocket
