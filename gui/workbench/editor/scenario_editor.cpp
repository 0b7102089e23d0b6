#include "gui/workbench/editor/scenario_editor.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QShortcut>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {

ScenarioEditor::ScenarioEditor(ScenarioDocument* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      form_(new ParameterForm(document, this)),
      text_(new TextPage(document, this)),
      search_(new QLineEdit(this)),
      changed_only_(new QToolButton(this)),
      nothing_found_(new QLabel(this)),
      tabs_(new QTabWidget(this)),
      restart_bar_(new MessageBar(Tone::warning, this)),
      recovery_bar_(new MessageBar(Tone::accent, this)),
      text_bar_(new MessageBar(Tone::bad, this)) {
  make_bars();
  tabs_->setDocumentMode(true);
  tabs_->addTab(make_form_page(), tr("Form"));
  tabs_->addTab(text_, tr("Text"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(recovery_bar_);
  layout->addWidget(restart_bar_);
  layout->addWidget(tabs_, 1);

  connect(tabs_, &QTabWidget::currentChanged, this, [this] { text_->commit(); });
  connect(text_, &TextPage::problem_changed, this, &ScenarioEditor::show_text_problem);
  connect(form_, &ParameterForm::tried, this, &ScenarioEditor::preview);
  connect(document_, &ScenarioDocument::changed, this, &ScenarioEditor::follow_edit);
}

QWidget* ScenarioEditor::make_search_bar() {
  auto* bar = new QWidget(this);
  search_->setPlaceholderText(tr("Search parameters"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search parameters"));
  search_->setToolTip(tr("Part of a name, key, unit, help or source"));
  changed_only_->setText(tr("Changed"));
  changed_only_->setCheckable(true);
  changed_only_->setToolTip(tr("Show only values that differ from the file"));
  connect(search_, &QLineEdit::textChanged, this, &ScenarioEditor::filter);
  connect(search_, &QLineEdit::returnPressed, form_, &ParameterForm::focus_first);
  connect(changed_only_, &QToolButton::toggled, this, &ScenarioEditor::filter);
  auto* clear = new QShortcut(Qt::Key_Escape, search_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(clear, &QShortcut::activated, search_, &QLineEdit::clear);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 8, 4);
  layout->addWidget(search_, 1);
  layout->addWidget(changed_only_);
  return bar;
}

QWidget* ScenarioEditor::make_form_page() {
  auto* page = new QWidget(this);
  nothing_found_->setAlignment(Qt::AlignCenter);
  nothing_found_->setWordWrap(true);
  nothing_found_->setMargin(24);
  nothing_found_->setForegroundRole(QPalette::PlaceholderText);
  nothing_found_->hide();
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(text_bar_);
  layout->addWidget(make_search_bar());
  layout->addWidget(nothing_found_, 1);
  layout->addWidget(form_, 1);
  return page;
}

void ScenarioEditor::make_bars() {
  connect(restart_bar_->add_button(tr("Restart")), &QPushButton::clicked, this, &ScenarioEditor::restart_requested);
  connect(recovery_bar_->add_button(tr("Recover")), &QPushButton::clicked, this, [this] { recover(true); });
  connect(recovery_bar_->add_button(tr("Discard")), &QPushButton::clicked, this, [this] { recover(false); });
  connect(text_bar_->add_button(tr("Go there")), &QPushButton::clicked, this, [this] {
    tabs_->setCurrentWidget(text_);
    text_->go_to_problem();
  });
  connect(text_bar_->add_button(tr("Discard")), &QPushButton::clicked, text_, &TextPage::discard);
}

void ScenarioEditor::filter() {
  const int shown = form_->filter(search_->text(), changed_only_->isChecked());
  form_->setVisible(shown > 0);
  nothing_found_->setVisible(shown == 0);
  nothing_found_->setText(search_->text().trimmed().isEmpty()
                              ? tr("Nothing differs from the file.")
                              : tr("No parameter matches “%1”.").arg(search_->text().trimmed()));
}

void ScenarioEditor::follow_edit(const QStringList& keys) {
  if (changed_only_->isChecked()) filter();
  show_restart();
  if (!running_) return;
  QStringList strategy;
  for (const QString& key : keys) {
    const Parameter* parameter = find_parameter(key.toStdString(), document_->scenario());
    if (parameter != nullptr && edit_effect(*parameter, document_->scenario().system) == EditEffect::at_once) {
      strategy << key;
    }
  }
  if (!strategy.isEmpty()) emit strategy_edited(strategy);
}

void ScenarioEditor::set_running(const Scenario* running) {
  running_ = running != nullptr;
  form_->set_running(running);
  show_restart();
}

QStringList ScenarioEditor::keys_that_need_restart() const { return form_->keys_that_need_restart(); }

void ScenarioEditor::show_restart() {
  const QStringList keys = keys_that_need_restart();
  restart_bar_->show_text(keys.isEmpty()     ? QString()
                          : keys.size() == 1 ? tr("1 change acts after a restart of the run.")
                                             : tr("%1 changes act after a restart of the run.").arg(keys.size()));
  if (keys == restart_keys_) return;
  restart_keys_ = keys;
  emit restart_needed(keys);
}

// As long as the text has something the form cannot show, the form stands still so that neither is lost.
void ScenarioEditor::show_text_problem() {
  const bool problem = text_->has_problem();
  form_->setEnabled(!problem);
  const int line = problem ? text_->problems().list().front().line : 0;
  const QString file = QFileInfo(text_->mended_path()).fileName();
  text_bar_->show_text(!problem          ? QString()
                       : !file.isEmpty() ? tr("%1 has an error: the form shows it once its text is mended.").arg(file)
                       : line > 0        ? tr("The text has an error in line %1.").arg(line)
                                         : tr("The text has an error."));
  tabs_->setTabText(tabs_->indexOf(text_), problem ? tr("Text (error)") : tr("Text"));
}

void ScenarioEditor::set_read_only(bool read_only) {
  form_->set_read_only(read_only);
  text_->set_read_only(read_only);
}

void ScenarioEditor::reveal(const QString& key) {
  search_->clear();
  changed_only_->setChecked(false);
  tabs_->setCurrentIndex(0);
  form_->reveal(key);
}

void ScenarioEditor::focus_search() {
  tabs_->setCurrentIndex(0);
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

bool ScenarioEditor::commit() {
  if (QWidget* focused = focusWidget()) focused->clearFocus();  // ends what is being typed in a field
  if (text_->commit()) return true;
  tabs_->setCurrentWidget(text_);
  text_->go_to_problem();
  return false;
}

void ScenarioEditor::mend(const QString& path, const QString& text) {
  text_->mend(path, text);
  if (!text_->has_problem()) return;
  tabs_->setCurrentWidget(text_);
  text_->go_to_problem();
}

void ScenarioEditor::offer_recovery() {
  const std::vector<LostWork> found = document_->lost_work();
  lost_work_ = found.empty() ? std::nullopt : std::optional(found.front());
  if (!lost_work_) return recovery_bar_->show_text({});
  const QString name = lost_work_->path.isEmpty() ? tr("an untitled scenario") : QFileInfo(lost_work_->path).fileName();
  recovery_bar_->show_text(tr("Unsaved changes of %1 from %2 were found.")
                               .arg(name, QLocale().toString(lost_work_->saved_at, QLocale::ShortFormat)));
}

void ScenarioEditor::recover(bool wanted) {
  if (!lost_work_) return;
  if (!wanted) {
    forget(*lost_work_);
  } else if (const Diagnostics problems = document_->recover(*lost_work_); !problems.ok()) {
    recovery_bar_->show_text(tr("Cannot be recovered: %1").arg(diagnostics_words(problems)));
    return;
  }
  offer_recovery();
}

}  // namespace netpocket
