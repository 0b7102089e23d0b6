#include "gui/workbench/editor/text_page.h"

#include <QEvent>
#include <QLabel>
#include <QTextBlock>
#include <QVBoxLayout>

#include "gui/workbench/editor/toml_edit_view.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

constexpr int kPause = 400;  // ms

}  // namespace

TextPage::TextPage(ScenarioDocument* document, QWidget* parent)
    : QWidget(parent), document_(document), view_(new TomlEditView(this)), status_(new QLabel(this)) {
  status_->setWordWrap(true);
  status_->setContentsMargins(10, 5, 10, 5);
  status_->setAutoFillBackground(true);
  status_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  status_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(view_, 1);
  layout->addWidget(status_);
  setFocusProxy(view_);

  pause_.setSingleShot(true);
  pause_.setInterval(kPause);
  connect(&pause_, &QTimer::timeout, this, &TextPage::commit);
  connect(view_, &QPlainTextEdit::textChanged, &pause_, qOverload<>(&QTimer::start));
  connect(view_, &TomlEditView::undo_requested, document_->undo_stack(), &QUndoStack::undo);
  connect(view_, &TomlEditView::redo_requested, document_->undo_stack(), &QUndoStack::redo);
  connect(document_, &ScenarioDocument::text_changed, this, &TextPage::show_document);
  connect(document_, &ScenarioDocument::replaced, this, &TextPage::show_document);
  show_document();
}

void TextPage::show_document() {
  if (committing_) return;
  pause_.stop();
  mended_path_.clear();
  view_->set_text(document_->text().remove('\r'));
  set_problems({});
}

void TextPage::mend(const QString& path, const QString& text) {
  mended_path_ = path;
  mended_has_dos_lines_ = text.contains("\r\n");
  view_->set_text(QString(text).remove('\r'));
  commit();
}

bool TextPage::has_dos_lines() const {
  return mended_path_.isEmpty() ? document_->text().contains("\r\n") : mended_has_dos_lines_;
}

bool TextPage::commit() {
  pause_.stop();
  QString text = view_->toPlainText();
  if (has_dos_lines()) text.replace("\n", "\r\n");  // as the file had it
  committing_ = true;
  Diagnostics problems =
      mended_path_.isEmpty() ? document_->set_text(text) : document_->open_mended(mended_path_, text);
  committing_ = false;
  if (problems.ok()) {
    mended_path_.clear();
    view_->settle();
  }
  set_problems(std::move(problems));
  return problems_.ok();
}

void TextPage::discard() { show_document(); }

void TextPage::set_problems(Diagnostics problems) {
  problems_ = std::move(problems);
  std::map<int, QString> lines;
  QStringList texts;
  for (const Diagnostic& diagnostic : problems_.list()) {
    texts << diagnostic_words(diagnostic);
    if (diagnostic.line > 0) lines[diagnostic.line] = engine_words(diagnostic.message);
  }
  view_->mark_lines(lines);
  colour_status();
  status_->setText(texts.mid(0, 4).join('\n'));
  status_->setVisible(!texts.isEmpty());
  emit problem_changed();
}

void TextPage::colour_status() {
  QPalette own;
  own.setColor(QPalette::Window, ground_colour(Tone::bad, palette()));
  own.setColor(QPalette::WindowText, tone_colour(Tone::bad, palette()));
  status_->setPalette(own);
}

void TextPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour_status();
}

void TextPage::go_to_problem() {
  if (problems_.ok()) return;
  const int line = std::max(problems_.list().front().line, 1);
  QTextCursor cursor(view_->document()->findBlockByNumber(line - 1));
  view_->setTextCursor(cursor);
  view_->centerCursor();
  view_->setFocus();
}

void TextPage::set_read_only(bool read_only) { view_->setReadOnly(read_only); }

}  // namespace netpocket
