#include "gui/workbench/editor/scenario_document.h"

#include <QFile>
#include <QFileInfo>

#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"
#include "gui/workbench/editor/edit_command.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/editor/toml_edit.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

constexpr int kAutosaveInterval = 3000;  // ms
constexpr int kUndoLimit = 1000;

bool same_values(const Scenario& a, const Scenario& b) { return differing_keys(a, b).isEmpty(); }

// A text does not have to name its scenario, nor can it say where its files are: then both stay what they were.
ScenarioResult read(const std::string& text, const std::string& file, const std::string& name, const FileScope& files) {
  ScenarioResult result = read_scenario_text(text, file);
  if (result.ok() && !states(text, *find_parameter("name"))) result.scenario.name = name;
  result.scenario.files = files;
  return result;
}

// The text of a file, as if it were saved.
ScenarioResult read_for(const QString& path, const std::string& text) {
  const std::string file = path.toStdString();
  return read(text, file, QFileInfo(path).completeBaseName().toStdString(), {.folder = folder_of(file)});
}

}  // namespace

ScenarioDocument::ScenarioDocument(const QString& recovery_folder, QObject* parent)
    : QObject(parent), recovery_folder_(recovery_folder), recovery_(recovery_folder) {
  undo_stack_.setUndoLimit(kUndoLimit);
  connect(&undo_stack_, &QUndoStack::cleanChanged, this, [this] { emit modified_changed(is_modified()); });
  autosave_timer_.setInterval(kAutosaveInterval);
  connect(&autosave_timer_, &QTimer::timeout, this, &ScenarioDocument::autosave);
  autosave_timer_.start();
  start_from(Scenario{});
}

// ---- edits ----

std::optional<QString> ScenarioDocument::set_value(const Parameter& parameter, const ParameterValue& value) {
  return set_values({{&parameter, value}},
                    tr("set %1 to %2").arg(full_label(parameter), value_words(parameter, value)));
}

std::optional<QString> ScenarioDocument::set_values(const std::vector<Setting>& settings, const QString& text) {
  State next = *state_;
  for (const auto& [parameter, value] : settings) {
    if (const auto problem = limit_problem(*parameter, value)) return engine_words(*problem);
    parameter->set(next.scenario, value);
  }
  if (same_values(next.scenario, state_->scenario)) return std::nullopt;
  next.text = text_with(*state_, settings, next.scenario);
  push(std::make_shared<const State>(std::move(next)), text);
  return std::nullopt;
}

// Changes the text in place; where that fails to say the target, writes the scenario anew.
std::string ScenarioDocument::text_with(const State& state, const std::vector<Setting>& settings,
                                        const Scenario& target) const {
  std::optional<std::string> text = state.text;
  for (const auto& [parameter, value] : settings) {
    if (text && parameter->get(state.scenario) != value) text = with_value(*text, *parameter, value);
  }
  if (text) {
    const ScenarioResult result = read(*text, {}, target.name, target.files);
    if (result.ok() && same_values(result.scenario, target)) return *text;
  }
  return write_scenario_text(target);
}

Diagnostics ScenarioDocument::set_text(const QString& text) {
  std::string bytes = text.toStdString();
  ScenarioResult result = read(bytes, {}, state_->scenario.name, state_->scenario.files);
  if (!result.ok()) return result.diagnostics;
  if (bytes == state_->text) return {};
  const QStringList keys = differing_keys(state_->scenario, result.scenario);
  const Parameter* only =
      keys.size() == 1 ? find_parameter(keys.front().toStdString(), result.scenario.system) : nullptr;
  const QString name = only ? tr("set %1 to %2").arg(full_label(*only), value_words(*only, only->get(result.scenario)))
                       : keys.isEmpty() ? tr("edit the text")
                                        : tr("edit the text (%n values)", nullptr, keys.size());
  push(std::make_shared<const State>(State{std::move(result.scenario), std::move(bytes)}), name);
  return {};
}

void ScenarioDocument::begin_interaction() {
  if (interaction_depth_++ == 0) ++interaction_;
}

void ScenarioDocument::end_interaction() { --interaction_depth_; }

void ScenarioDocument::push(StatePointer next, const QString& text) {
  const int interaction = interaction_depth_ > 0 ? interaction_ : 0;
  undo_stack_.push(new EditCommand(*this, state_, std::move(next), interaction, text));
}

// States in the undo history may be from before the document had its present file.
ScenarioDocument::StatePointer ScenarioDocument::with_folder(const StatePointer& state) const {
  const std::string folder = path_.isEmpty() ? std::string() : folder_of(path_.toStdString());
  if (state->scenario.files.folder == folder) return state;
  State moved = *state;
  moved.scenario.files.folder = folder;
  // A file of its own says what it is about; a scenario that a recording holds has none.
  if (!folder.empty()) moved.scenario.files.kept_mesh = {};
  return std::make_shared<const State>(std::move(moved));
}

void ScenarioDocument::apply(const StatePointer& state) {
  const StatePointer before = std::exchange(state_, with_folder(state));
  const QStringList keys = before ? differing_keys(before->scenario, state_->scenario) : QStringList();
  if (!before || !keys.isEmpty()) {
    diagnostics_ = check_scenario(state_->scenario);
    emit changed(keys);
    emit diagnostics_changed();
  }
  if (!before || before->text != state_->text) emit text_changed();
}

Diagnostics ScenarioDocument::located_diagnostics() const {
  const std::string file = path_.toStdString();
  return read_scenario_text(state_->text, file).with_lines(diagnostics_, file);
}

// ---- files ----

QString ScenarioDocument::display_name() const {
  return path_.isEmpty() ? tr("untitled") : QFileInfo(path_).fileName();
}

void ScenarioDocument::reset(const StatePointer& state, const QString& path, StatePointer saved) {
  const bool was_modified = is_modified();
  undo_stack_.clear();
  recovered_ = state != saved;
  recovery_.remove();
  autosaved_ = nullptr;
  set_saved(std::move(saved));
  const bool moved = path != path_;
  path_ = path;
  const bool same = state_ && same_values(state_->scenario, state->scenario);
  apply(state);
  if (same) look_for_mesh();
  if (moved) emit path_changed(path_);
  if (was_modified != is_modified()) emit modified_changed(is_modified());
  emit replaced();
}

void ScenarioDocument::set_saved(StatePointer state) {
  saved_ = std::move(state);
  emit saved_changed();
}

Diagnostics ScenarioDocument::read_file(const QString& path, StatePointer& state) {
  ScenarioResult result = read_scenario_file(path.toStdString());
  if (!result.ok()) return result.diagnostics;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    Diagnostics problems;
    problems.add({.file = path.toStdString(), .message = "cannot be read: " + file.errorString().toStdString()});
    return problems;
  }
  state = std::make_shared<const State>(State{std::move(result.scenario), file.readAll().toStdString()});
  return {};
}

Diagnostics ScenarioDocument::open(const QString& path) {
  StatePointer state;
  if (const Diagnostics problems = read_file(path, state); !problems.ok()) return problems;
  reset(state, path, state);
  return {};
}

Diagnostics ScenarioDocument::revert() {
  StatePointer state = saved_;
  if (!path_.isEmpty()) {
    if (const Diagnostics problems = read_file(path_, state); !problems.ok()) return problems;
  } else if (state->text.empty()) {  // recovered, without a file
    state = std::make_shared<const State>(State{state->scenario, write_scenario_text(state->scenario)});
  }
  recovered_ = false;
  recovery_.remove();
  if (state->text != state_->text) push(state, tr("revert to the saved version"));
  set_saved(state);
  if (undo_stack_.isClean()) emit modified_changed(false);
  undo_stack_.setClean();
  return {};
}

std::optional<QString> ScenarioDocument::save() {
  if (path_.isEmpty()) return tr("The scenario has no file yet.");
  return save_as(path_);
}

std::optional<QString> ScenarioDocument::save_as(const QString& path) {
  try {
    OutputList().add("scenario", path.toStdString(), FileKind::scenario);
    write_whole_file(path.toStdString(), FileKind::scenario, state_->text);
  } catch (const FileError& error) {
    return QString::fromStdString(error.what());
  }
  const bool was_modified = is_modified();
  recovered_ = false;
  recovery_.remove();
  set_saved(state_);
  if (path != path_) {
    path_ = path;
    emit path_changed(path_);
    look_for_mesh();
  }
  if (undo_stack_.isClean() && was_modified) emit modified_changed(false);
  undo_stack_.setClean();
  return std::nullopt;
}

// The mesh may be found in another folder, or by now, or no longer.
void ScenarioDocument::look_for_mesh() {
  if (state_->scenario.target.shape != TargetShape::mesh) return;
  state_ = with_folder(state_);
  diagnostics_ = check_scenario(state_->scenario);
  emit changed({"target.mesh_file"});
  emit diagnostics_changed();
}

Diagnostics ScenarioDocument::start_from(const QString& text) {
  std::string bytes = text.toStdString();
  ScenarioResult result = read_scenario_text(bytes, {});
  if (!result.ok()) return result.diagnostics;
  const auto state = std::make_shared<const State>(State{std::move(result.scenario), std::move(bytes)});
  reset(state, {}, state);
  return {};
}

void ScenarioDocument::start_from(const Scenario& scenario) {
  const auto state = std::make_shared<const State>(State{scenario, write_scenario_text(scenario)});
  reset(state, {}, state);
}

Diagnostics ScenarioDocument::open_mended(const QString& path, const QString& text) {
  std::string bytes = text.toStdString();
  ScenarioResult result = read_for(path, bytes);
  if (!result.ok()) return result.diagnostics;
  const auto state = std::make_shared<const State>(State{std::move(result.scenario), std::move(bytes)});
  // The file's own values are not known.
  reset(state, path, std::make_shared<const State>(State{state->scenario, {}}));
  return {};
}

// ---- recovery ----

Diagnostics ScenarioDocument::recover(const LostWork& work) {
  std::string bytes = work.text.toStdString();
  ScenarioResult result = read_for(work.path, bytes);
  if (!result.ok()) return result.diagnostics;
  const auto state = std::make_shared<const State>(State{std::move(result.scenario), std::move(bytes)});
  const ScenarioResult file = read_scenario_file(work.path.toStdString());
  const auto saved = std::make_shared<const State>(State{file.ok() ? file.scenario : Scenario{}, {}});
  reset(state, work.path, saved);
  forget(work);
  autosave();
  return {};
}

void ScenarioDocument::autosave() {
  if (!is_modified()) {
    recovery_.remove();
    autosaved_ = nullptr;
  } else if (autosaved_ != state_ && recovery_.write(path_, text())) {
    autosaved_ = state_;
  }
}

}  // namespace netpocket
