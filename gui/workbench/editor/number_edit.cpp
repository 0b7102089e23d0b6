#include "gui/workbench/editor/number_edit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {
namespace {

constexpr double kStepAtZero = 0.1;          // in units of the parameter, or
constexpr double kStepAtZeroOfRange = 0.01;  // of the largest value, whichever is less
constexpr int kWidthInDigits = 8;

// Ten to the place of the second digit.
double second_digit(double value) { return std::pow(10, std::floor(std::log10(std::abs(value))) - 1); }

// Rounds what binary fractions add: 0.30000000000000004 becomes 0.3.
double clean(double value) { return QString::number(value, 'g', 12).toDouble(); }

}  // namespace

NumberEdit::NumberEdit(const Limits& limits, bool whole, QWidget* parent)
    : QAbstractSpinBox(parent), limits_(limits), whole_(whole) {
  setFocusPolicy(Qt::StrongFocus);
  setAccelerated(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  lineEdit()->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  connect(lineEdit(), &QLineEdit::textEdited, this, &NumberEdit::typed);
  connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
    if (has_pending_text()) emit finished();
  });
  set_value(0);
}

void NumberEdit::set_value(double value) {
  value_ = value;
  lineEdit()->setText(number_words(value));
  lineEdit()->setCursorPosition(0);
}

std::optional<double> NumberEdit::typed_value() const {
  bool valid = false;
  const double value = text().trimmed().replace(',', '.').replace(QChar(0x2212), '-').toDouble(&valid);
  if (!valid || (whole_ && value != std::floor(value))) return std::nullopt;
  return value;
}

bool NumberEdit::has_pending_text() const { return text() != number_words(value_); }

double NumberEdit::step_towards(int direction) const {
  if (whole_) return 1;
  if (value_ == 0) return std::min(kStepAtZero, kStepAtZeroOfRange * limits_.maximum);
  const double step = second_digit(value_);
  // Down from 1.0 goes to 0.99, as up from 0.99 goes to 1.0.
  const bool shrinks = (direction < 0) == (value_ > 0);
  return shrinks ? second_digit(std::abs(value_) * (1 - 1e-9)) : step;
}

void NumberEdit::stepBy(int steps) {
  if (const auto typed = typed_value(); typed && limits_.contain(*typed)) value_ = *typed;
  const double step = step_towards(steps);
  const double target = clean(std::round(value_ / step + steps) * step);
  const double lowest = limits_.minimum_excluded ? std::min(value_, limits_.minimum + step) : limits_.minimum;
  const double next = std::clamp(target, lowest, limits_.maximum);
  set_value(next);
  lineEdit()->selectAll();
  emit stepped(next);
}

QAbstractSpinBox::StepEnabled NumberEdit::stepEnabled() const {
  StepEnabled enabled = StepNone;
  if (isReadOnly()) return enabled;
  if (value_ < limits_.maximum) enabled |= StepUpEnabled;
  if (value_ > limits_.minimum) enabled |= StepDownEnabled;
  return enabled;
}

// Anything may be typed; the form says what is wrong with it.
QValidator::State NumberEdit::validate(QString&, int&) const { return QValidator::Acceptable; }

// The line edit inside would keep undo and redo to itself. It may while something is being typed; else they are the
// document's.
bool NumberEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !has_pending_text()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QAbstractSpinBox::event(event);
}

void NumberEdit::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && has_pending_text()) {
    set_value(value_);
    lineEdit()->selectAll();
    emit typed();
    return;
  }
  QAbstractSpinBox::keyPressEvent(event);
}

// The wheel scrolls the form unless the field has been chosen.
void NumberEdit::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QAbstractSpinBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

QSize NumberEdit::sizeHint() const {
  QSize size = QAbstractSpinBox::minimumSizeHint();
  size.setWidth(fontMetrics().horizontalAdvance('0') * kWidthInDigits + 36);
  return size;
}

QSize NumberEdit::minimumSizeHint() const {
  QSize size = sizeHint();
  size.setWidth(fontMetrics().horizontalAdvance('0') * (kWidthInDigits - 3) + 24);
  return size;
}

}  // namespace netpocket
