#include "gui/workbench/campaign/scatter_row.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "engine/study/setting.h"
#include "gui/workbench/editor/number_edit.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/panels/icons.h"

namespace netpocket {
namespace {

constexpr Limits kSpreads{0, 1e15, true};

QString scatter_words(Scatter scatter) {
  switch (scatter) {
    case Scatter::uniform:
      return ScatterRow::tr("Evenly, up to ±");
    case Scatter::normal:
      return ScatterRow::tr("Normal, deviation");
    case Scatter::factor:
      return ScatterRow::tr("Factor, log-deviation");
    case Scatter::direction:
      break;
  }
  return ScatterRow::tr("Any direction, up to");
}

QString scatter_help(Scatter scatter) {
  switch (scatter) {
    case Scatter::uniform:
      return ScatterRow::tr("All values around the scenario's are equally likely, up to this far");
    case Scatter::normal:
      return ScatterRow::tr("Normal distribution about the scenario's value, with this standard deviation");
    case Scatter::factor:
      return ScatterRow::tr(
          "The scenario's value times a log-normal number about 1; the standard deviation of its logarithm");
    case Scatter::direction:
      break;
  }
  return ScatterRow::tr("A vector in any direction, of any length up to this");
}

const Parameter* parameter_of_key(const Scenario& scenario, const std::string& key) {
  return find_parameter(key.substr(0, key.find('[')), scenario);
}

}  // namespace

QString scatter_label(const Scenario& scenario, const std::string& key) {
  const Parameter* parameter = parameter_of_key(scenario, key);
  if (parameter == nullptr) return QString::fromStdString(key);
  const auto bracket = key.find('[');
  if (bracket == key.npos || bracket + 1 >= key.size()) return full_label(*parameter);
  return QString("%1 %2").arg(full_label(*parameter), QChar('x' + (key[bracket + 1] - '0')));
}

ScatterRow::ScatterRow(const DraftInput& input, const Scenario& scenario, QWidget* parent)
    : QWidget(parent),
      key_(input.key),
      name_(new QLabel),
      unit_(new QLabel),
      scatter_(new QComboBox),
      spread_(new NumberEdit(kSpreads, false)),
      remove_(new QToolButton) {
  const QString name = scatter_label(scenario, key_);
  for (const Scatter scatter : possible_scatters(scenario, key_)) {
    scatter_->addItem(scatter_words(scatter), static_cast<int>(scatter));
    scatter_->setItemData(scatter_->count() - 1, scatter_help(scatter), Qt::ToolTipRole);
  }
  scatter_->setCurrentIndex(std::max(0, scatter_->findData(static_cast<int>(input.scatter))));
  scatter_->setAccessibleName(tr("How %1 scatters").arg(name));
  scatter_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  scatter_->setMinimumContentsLength(12);
  spread_->set_value(input.spread);
  spread_->setAccessibleName(tr("By how much %1 scatters").arg(name));
  connect(spread_, &NumberEdit::finished, this, [this] {
    if (const auto value = spread_->typed_value(); value && kSpreads.contain(*value)) {
      spread_->set_value(*value);
    } else {
      spread_->set_value(spread_->value());
    }
  });
  remove_->setAutoRaise(true);
  remove_->setToolTip(tr("Not uncertain: remove this input"));
  remove_->setAccessibleName(tr("Remove %1").arg(name));
  show_glyph();
  connect(remove_, &QToolButton::clicked, this, &ScatterRow::remove_requested);
  connect(scatter_, &QComboBox::currentIndexChanged, this, &ScatterRow::show_unit);
  unit_->setMinimumWidth(fontMetrics().horizontalAdvance("rad/s"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(12, 2, 6, 4);
  layout->setVerticalSpacing(2);
  layout->setColumnStretch(0, 3);
  layout->setColumnStretch(1, 2);
  layout->addWidget(name_, 0, 0, 1, 3);
  layout->addWidget(remove_, 0, 3);
  layout->addWidget(scatter_, 1, 0);
  layout->addWidget(spread_, 1, 1);
  layout->addWidget(unit_, 1, 2, 1, 2);
  show_scenario(scenario);
}

DraftInput ScatterRow::input() const {
  const double spread = spread_->has_pending_text() ? spread_->typed_value().value_or(0) : spread_->value();
  return {key_, static_cast<Scatter>(scatter_->currentData().toInt()), spread};
}

void ScatterRow::show_scenario(const Scenario& scenario) {
  const Parameter* parameter = parameter_of_key(scenario, key_);
  const QString name = scatter_label(scenario, key_);
  unit_words_ = parameter != nullptr ? unit_words(parameter->unit) : QString();
  const auto centre = number_of(scenario, key_);
  QString text = centre ? tr("%1: %2 %3").arg(name, number_words(*centre), unit_words_).trimmed() : name;
  if (parameter == nullptr) text += tr(" – not in this scenario");
  name_->setText(text);
  name_->setToolTip(parameter != nullptr ? tool_tip(*parameter) : QString());
  show_unit();
}

void ScatterRow::show_unit() {
  const bool is_factor = scatter_->currentData().toInt() == static_cast<int>(Scatter::factor);
  unit_->setText(is_factor ? QString() : unit_words_);
  scatter_->setToolTip(scatter_->currentData(Qt::ToolTipRole).toString());
}

void ScatterRow::show_glyph() { remove_->setIcon(glyph_icon(Glyph::remove, Tone::muted, palette())); }

void ScatterRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_glyph();
}

}  // namespace netpocket
