#pragma once
// The scenario that is being edited: its values, its TOML text, its file, its history.
//
// Text and values always say the same. An edit of a value changes only that value's place in the text, so a person's
// comments and order survive; an edit of the text counts only if it can be read. Every edit is one command of the undo
// stack; edits of the same keys within one interaction (a drag, a turn of the wheel) become one command.
// Thread contract: the user interface's thread; scenario() can be copied to others. Nothing is thrown.

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"
#include "gui/workbench/editor/recovery.h"

namespace netpocket {

class ScenarioDocument : public QObject {
  Q_OBJECT
 public:
  struct State {
    Scenario scenario;
    std::string text;  // TOML, UTF-8
  };
  using Setting = std::pair<const Parameter*, ParameterValue>;

  // A new document: the defaults, without a file.
  explicit ScenarioDocument(const QString& recovery_folder = default_recovery_folder(), QObject* parent = nullptr);

  const Scenario& scenario() const { return state_->scenario; }
  QString text() const { return QString::fromStdString(state_->text); }
  // The scenario as in the file, or as it was when new.
  const Scenario& saved_scenario() const { return saved_->scenario; }
  // What check_scenario says of it; empty when it can be simulated.
  const Diagnostics& diagnostics() const { return diagnostics_; }
  // The same with the file and the line of each key, as `netpocket check` says it.
  Diagnostics located_diagnostics() const;
  QUndoStack* undo_stack() { return &undo_stack_; }

  // ---- edits. Each returns why it was refused, in one sentence; then nothing has changed. ----
  [[nodiscard]] std::optional<QString> set_value(const Parameter& parameter, const ParameterValue& value);
  // Several at once, as one command with this text.
  [[nodiscard]] std::optional<QString> set_values(const std::vector<Setting>& settings, const QString& text);
  // The whole text; the diagnostics are those of reading it.
  [[nodiscard]] Diagnostics set_text(const QString& text);

  // Edits between the two merge. Calls may nest.
  void begin_interaction();
  void end_interaction();

  // ---- files ----
  const QString& path() const { return path_; }
  // The file's name, or "untitled".
  QString display_name() const;
  bool is_modified() const { return recovered_ || !undo_stack_.isClean(); }

  // On problems the document stays as it was.
  [[nodiscard]] Diagnostics open(const QString& path);
  [[nodiscard]] std::optional<QString> save();
  [[nodiscard]] std::optional<QString> save_as(const QString& path);
  // Takes the file as it is now, or what a scenario without one began as, as an edit that can be undone.
  [[nodiscard]] Diagnostics revert();
  // Starts anew, without a file, from a TOML text such as a preset's.
  [[nodiscard]] Diagnostics start_from(const QString& text);
  // The same from a scenario, such as that of a recording.
  void start_from(const Scenario& scenario);
  // Takes over a file that could not be opened, with the text that a person has put right, as unsaved changes.
  [[nodiscard]] Diagnostics open_mended(const QString& path, const QString& text);

  // ---- recovery ----
  // What crashed programs have left, the newest first.
  std::vector<LostWork> lost_work() const { return find_lost_work(recovery_folder_); }
  // Takes lost work over as unsaved changes of its file.
  [[nodiscard]] Diagnostics recover(const LostWork& work);
  // Writes the recovery file now if there is something to lose. Called by itself every few seconds.
  void autosave();

 signals:
  void changed(const QStringList& keys);  // keys of all parameters that differ from before
  void text_changed();                    // also when only comments changed
  void diagnostics_changed();
  void path_changed(const QString& path);
  void modified_changed(bool modified);
  void saved_changed();  // saved_scenario() is another one
  void replaced();       // by another document; what was typed for the one before is void

 private:
  friend class EditCommand;
  using StatePointer = std::shared_ptr<const State>;

  [[nodiscard]] static Diagnostics read_file(const QString& path, StatePointer& state);
  void push(StatePointer next, const QString& text);
  void apply(const StatePointer& state);
  // The same with the folder of the present file, where meshes are looked for.
  StatePointer with_folder(const StatePointer& state) const;
  void reset(const StatePointer& state, const QString& path, StatePointer saved);
  void set_saved(StatePointer state);
  void look_for_mesh();
  std::string text_with(const State& state, const std::vector<Setting>& settings, const Scenario& target) const;

  StatePointer state_;
  StatePointer saved_;
  Diagnostics diagnostics_;
  QUndoStack undo_stack_;
  QString path_;
  bool recovered_ = false;  // recovered work is unsaved although nothing can be undone
  int interaction_depth_ = 0;
  int interaction_ = 0;  // number of the latest interaction
  QString recovery_folder_;
  RecoveryFile recovery_;
  QTimer autosave_timer_;
  StatePointer autosaved_;
};

}  // namespace netpocket
