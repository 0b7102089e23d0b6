#include "gui/workbench/editor/toml_edit_view.h"

#include <QApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>

#include "gui/workbench/editor/line_numbers.h"
#include "gui/workbench/editor/toml_highlighter.h"
#include "gui/workbench/panels/tones.h"
#include "render/fonts/font_file.h"

namespace netpocket {

TomlEditView::TomlEditView(QWidget* parent)
    : QPlainTextEdit(parent), numbers_(new LineNumbers(this)), highlighter_(new TomlHighlighter(document())) {
  QFont columns = QApplication::font();
  columns.setFamily(kMonoFontFamily);
  setFont(columns);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabStopDistance(2 * fontMetrics().horizontalAdvance(' '));
  setTabChangesFocus(true);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Scenario as TOML"));
  highlighter_->set_palette(palette());
  connect(this, &QPlainTextEdit::blockCountChanged, this, &TomlEditView::place_numbers);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& area, int dy) {
    if (dy != 0) {
      numbers_->scroll(0, dy);
    } else {
      numbers_->update(0, area.y(), numbers_->width(), area.height());
    }
  });
  place_numbers();
}

void TomlEditView::set_text(const QString& text) {
  const QString old = toPlainText();
  if (old == text) return;
  const auto shorter = std::min(old.size(), text.size());
  qsizetype head = 0;
  while (head < shorter && old[head] == text[head]) ++head;
  qsizetype tail = 0;
  while (tail < shorter - head && old[old.size() - 1 - tail] == text[text.size() - 1 - tail]) ++tail;
  const QSignalBlocker blocker(this);
  QTextCursor cursor(document());
  cursor.setPosition(static_cast<int>(head));
  cursor.setPosition(static_cast<int>(old.size() - tail), QTextCursor::KeepAnchor);
  cursor.insertText(text.mid(head, text.size() - head - tail));
  settle();
  place_numbers();
}

void TomlEditView::settle() { document()->clearUndoRedoStacks(); }

void TomlEditView::mark_lines(const std::map<int, QString>& problems) {
  problems_ = problems;
  show_marks();
}

void TomlEditView::show_marks() {
  QList<QTextEdit::ExtraSelection> selections;
  for (const auto& [line, problem] : problems_) {
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (!block.isValid()) continue;
    QTextEdit::ExtraSelection selection;
    selection.cursor = QTextCursor(block);
    selection.format.setBackground(ground_colour(Tone::bad, palette()));
    selection.format.setProperty(QTextFormat::FullWidthSelection, true);
    selections.push_back(selection);
  }
  setExtraSelections(selections);
  numbers_->update();
}

bool TomlEditView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QPoint point = viewport()->mapFromGlobal(help->globalPos());
    const auto found = problems_.find(cursorForPosition(point).blockNumber() + 1);
    QToolTip::showText(help->globalPos(), found == problems_.end() ? QString() : found->second, this);
    return true;
  }
  return QPlainTextEdit::event(event);
}

// Undo of what is being typed is this widget's; before that, the document's.
void TomlEditView::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo) && !document()->isUndoAvailable()) return emit undo_requested();
  if (event->matches(QKeySequence::Redo) && !document()->isRedoAvailable()) return emit redo_requested();
  QPlainTextEdit::keyPressEvent(event);
}

void TomlEditView::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  place_numbers();
}

void TomlEditView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    highlighter_->set_palette(palette());
    show_marks();
  }
  QPlainTextEdit::changeEvent(event);
}

// ---- line numbers ----

int TomlEditView::number_width() const {
  const int digits = std::max<int>(3, QString::number(blockCount()).size());
  return fontMetrics().horizontalAdvance('9') * digits + 16;
}

void TomlEditView::place_numbers() {
  setViewportMargins(number_width(), 0, 0, 0);
  const QRect area = contentsRect();
  numbers_->setGeometry(area.left(), area.top(), number_width(), area.height());
  numbers_->update();
}

void TomlEditView::paint_numbers(QPaintEvent* event) {
  QPainter painter(numbers_);
  painter.fillRect(event->rect(), palette().color(QPalette::Window));
  painter.setFont(font());
  QTextBlock block = firstVisibleBlock();
  double top = blockBoundingGeometry(block).translated(contentOffset()).top();
  while (block.isValid() && top <= event->rect().bottom()) {
    const double height = blockBoundingRect(block).height();
    const bool marked = problems_.contains(block.blockNumber() + 1);
    painter.setPen(tone_colour(marked ? Tone::bad : Tone::muted, palette()));
    painter.drawText(QRectF(0, top, numbers_->width() - 8, height), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(block.blockNumber() + 1));
    top += height;
    block = block.next();
  }
}

}  // namespace netpocket
