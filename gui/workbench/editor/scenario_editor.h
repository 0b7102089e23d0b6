#pragma once
// The scenario dock: form and text of a document, search, and what edits mean to the run in progress. Errors stand
// where they are made, never in a box of their own.

#include <QWidget>
#include <optional>

#include "gui/workbench/editor/scenario_document.h"

class QLabel;
class QLineEdit;
class QTabWidget;
class QToolButton;

namespace netpocket {

class MessageBar;
class ParameterForm;
class TextPage;

class ScenarioEditor : public QWidget {
  Q_OBJECT
 public:
  // The document must outlive the editor.
  explicit ScenarioEditor(ScenarioDocument* document, QWidget* parent = nullptr);

  // What the run that goes on has of its scenario by now; null: no run goes on. While one does, strategy edits are
  // announced by strategy_edited() and other changes are marked as needing a restart.
  void set_running(const Scenario* running);
  bool is_run_active() const { return running_; }
  // Changed since the run started and not taken up by it.
  QStringList keys_that_need_restart() const;

  void set_read_only(bool read_only);

  // Puts the cursor into a parameter's field, for instance from a message of the engine.
  void reveal(const QString& key);
  void focus_search();
  // Reads text that was typed a moment ago, e.g. before saving or running. False: it has an error, which is now shown.
  bool commit();

  // Shows the text of a file that could not be opened, at its first error: TextPage::mend.
  void mend(const QString& path, const QString& text);

  // Offers unsaved work that crashed programs have left, in a bar on top.
  void offer_recovery();

  ParameterForm* form() const { return form_; }
  TextPage* text_page() const { return text_; }
  QLineEdit* search() const { return search_; }
  QToolButton* changed_only() const { return changed_only_; }
  QTabWidget* tabs() const { return tabs_; }
  MessageBar* restart_bar() const { return restart_bar_; }
  MessageBar* recovery_bar() const { return recovery_bar_; }
  MessageBar* text_bar() const { return text_bar_; }

 signals:
  // The scenario with what is being typed, for previews; equals the document's when nothing is.
  void preview(const netpocket::Scenario& scenario);
  // A run is active and these strategy parameters have new values in the document.
  void strategy_edited(const QStringList& keys);
  // keys_that_need_restart() has changed.
  void restart_needed(const QStringList& keys);
  // The user asks for a restart with the changed scenario.
  void restart_requested();

 private:
  QWidget* make_search_bar();
  QWidget* make_form_page();
  void make_bars();
  void filter();
  void follow_edit(const QStringList& keys);
  void show_restart();
  void show_text_problem();
  void recover(bool wanted);

  ScenarioDocument* document_;
  ParameterForm* form_;
  TextPage* text_;
  QLineEdit* search_;
  QToolButton* changed_only_;
  QLabel* nothing_found_;
  QTabWidget* tabs_;
  MessageBar* restart_bar_;
  MessageBar* recovery_bar_;
  MessageBar* text_bar_;
  bool running_ = false;
  std::optional<LostWork> lost_work_;
  QStringList restart_keys_;
};

}  // namespace netpocket
