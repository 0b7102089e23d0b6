#include "gui/workbench/editor/parameter_row.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "gui/workbench/editor/parameter_field.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/panels/icons.h"

namespace netpocket {
namespace {

constexpr int kIconSize = 16;
constexpr int kButtonSize = 22;
constexpr int kSpacing = 5;
constexpr int kNarrowField = 64;
constexpr int kRoomForThree = 500;  // pixels that a row needs for three numbers beside its label

const Scenario& default_scenario() {
  static const Scenario scenario = [] {
    Scenario with_items;  // lists have all items that there can be
    for (const ParameterList& list : parameter_lists()) list.resize(with_items, kMostItems);
    return with_items;
  }();
  return scenario;
}

// Whether the scenario has the parameter's item and is of its system.
bool is_in(const Parameter& parameter, const Scenario& scenario) {
  return find_parameter(parameter.key, scenario) != nullptr;
}

// A label in bold is wider.
int bold_width(const QFontMetrics& metrics, const QString& words) {
  return static_cast<int>(1.12 * metrics.horizontalAdvance(words)) + 4;
}

}  // namespace

ParameterRow::ParameterRow(const Parameter& parameter, QWidget* parent, std::string_view system)
    : QWidget(parent),
      parameter_(parameter),
      field_(ParameterField::create(parameter, this)),
      layout_(new QGridLayout(this)),
      label_(new QLabel(label(parameter), this)),
      unit_(new QLabel(this)),
      effect_(new QLabel(this)),
      reset_(new QToolButton(this)),
      problem_(new QLabel(this)),
      value_(parameter.get(default_scenario())),
      saved_(value_),
      system_(system) {
  const QString tip = tool_tip(parameter);
  label_->setToolTip(tip);
  field_->setToolTip(tip);
  label_->setBuddy(field_);
  label_->setFixedWidth(label_width(fontMetrics()));
  unit_->setFixedWidth(unit_width(fontMetrics()));
  effect_->setFixedSize(kIconSize, kIconSize);
  reset_->setAutoRaise(true);
  reset_->setFixedSize(kButtonSize, kButtonSize);
  reset_->setIconSize({kIconSize, kIconSize});
  reset_->setFocusPolicy(Qt::TabFocus);
  problem_->setWordWrap(true);
  problem_->hide();

  lay_out();

  QStringList searched = {label(parameter),
                          from_utf8(parameter.key),
                          from_utf8(parameter.help),
                          from_utf8(parameter.source),
                          unit_words(parameter.unit),
                          table_title(parameter, system),
                          help(parameter)};
  for (const std::string_view choice : parameter.choices) searched << from_utf8(choice);
  search_text_ = searched.join('\n').toLower();

  connect(field_, &ParameterField::edited, this, &ParameterRow::edited);
  connect(field_, &ParameterField::tried, this, &ParameterRow::tried);
  connect(field_, &ParameterField::refused, this, [this](const QString& reason) {
    typed_problem_ = reason;
    show_problem();
  });
  connect(reset_, &QToolButton::clicked, this,
          [this] { emit edited(changed_ ? saved_ : parameter_.get(default_scenario()), false); });
}

void ParameterRow::lay_out() {
  const Qt::Alignment beside = parameter_.type == ParameterType::pairs ? Qt::AlignTop : Qt::AlignVCenter;
  layout_->setContentsMargins(12, 1, 6, 1);
  layout_->setHorizontalSpacing(kSpacing);
  layout_->setVerticalSpacing(2);
  layout_->addWidget(label_, 0, 0, beside);
  layout_->addWidget(effect_, 0, 3, beside);
  layout_->addWidget(reset_, 0, 4, beside);
  layout_->addWidget(problem_, 2, 1, 1, 4);
  layout_->setColumnStretch(1, 1);
  layout_->setColumnMinimumWidth(2, unit_width(fontMetrics()));
  place_field();
}

// Vectors and tables go below their label where there is no room beside it.
void ParameterRow::place_field() {
  const bool wide = parameter_.type == ParameterType::vector || parameter_.type == ParameterType::pairs;
  const bool below = wide && width() < kRoomForThree;
  if (below == field_below_) return;
  field_below_ = below;
  layout_->removeWidget(field_);
  layout_->removeWidget(unit_);
  if (below) {
    layout_->addWidget(field_, 1, 0, 1, 2);
    layout_->addWidget(unit_, 0, 1, Qt::AlignLeft | Qt::AlignVCenter);
  } else {
    // Words take the place of the unit they do not have.
    const bool words = parameter_.type == ParameterType::text || parameter_.type == ParameterType::choice;
    layout_->addWidget(field_, 0, 1, 1, words ? 2 : 1);
    layout_->addWidget(unit_, 0, 2, Qt::AlignVCenter);
  }
}

// That of a row with one number, whatever stands beside the label now, so that a form can become narrow again.
QSize ParameterRow::minimumSizeHint() const {
  const int columns = label_->width() + kNarrowField + unit_width(fontMetrics()) + kIconSize + kButtonSize;
  const QMargins margins = layout_->contentsMargins();
  return {columns + 4 * kSpacing + margins.left() + margins.right(), layout_->minimumSize().height()};
}

void ParameterRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_field();
}

// The rows that it is to align with.
std::span<const Parameter> ParameterRow::siblings() const {
  const ParameterList* list = list_of(parameter_, system_);
  return list != nullptr ? parameters_of(*list, parameter_.item) : parameters(system_);
}

int ParameterRow::label_width(const QFontMetrics& metrics) const {
  int widest = 0;
  for (const Parameter& parameter : siblings()) widest = std::max(widest, bold_width(metrics, label(parameter)));
  return widest;
}

int ParameterRow::unit_width(const QFontMetrics& metrics) const {
  int widest = 0;
  for (const Parameter& parameter : siblings()) {
    widest = std::max(widest, metrics.horizontalAdvance(unit_of(parameter, default_scenario())));
  }
  return widest + 2;
}

void ParameterRow::show_scenario(const Scenario& scenario, const Scenario& saved) {
  const ParameterValue value = parameter_.get(scenario);
  // What is being typed stays, unless the value itself has changed.
  if (value != value_ || !field_->has_pending_text()) {
    field_->show_value(value);
    typed_problem_.clear();
  }
  value_ = value;
  // What is saved may have fewer items, such as controllers: a new one starts from the defaults.
  saved_ = is_in(parameter_, saved) ? parameter_.get(saved) : parameter_.get(default_scenario());
  unused_ = why_unused(parameter_, scenario);
  unit_->setText(unit_of(parameter_, scenario));
  field_->setEnabled(!unused_);
  label_->setEnabled(!unused_);
  unit_->setEnabled(!unused_);
  const QString note = unused_ ? "<p><i>" + *unused_ + "</i></p>" : QString();
  field_->setToolTip(note + tool_tip(parameter_));
  label_->setToolTip(note + tool_tip(parameter_));
  changed_ = value_ != saved_;
  show_label();
  show_reset();
  show_effect();
  show_problem();
}

void ParameterRow::show_label() {
  QFont font = this->font();
  font.setBold(changed_);
  label_->setFont(font);
}

void ParameterRow::show_reset() {
  const ParameterValue standard = parameter_.get(default_scenario());
  const bool differs = changed_ || value_ != standard;
  const QString target = value_words(parameter_, changed_ ? saved_ : standard);
  reset_->setIcon(differs ? glyph_icon(Glyph::reset, changed_ ? Tone::accent : Tone::muted, palette()) : QIcon());
  reset_->setToolTip(!differs   ? QString()
                     : changed_ ? tr("Back to the saved value, %1").arg(target)
                                : tr("Back to the default, %1").arg(target));
  reset_->setAccessibleName(differs ? tr("Reset %1").arg(label(parameter_)) : QString());
  reset_->setEnabled(differs && !read_only_);
}

void ParameterRow::show_effect() {
  const EditEffect effect = edit_effect(parameter_, system_);
  needs_restart_ = running_ && effect == EditEffect::restart && *running_ != value_;
  effect_->clear();
  effect_->setToolTip({});
  if (!running_ || unused_ || effect == EditEffect::none) return;
  const bool at_once = effect == EditEffect::at_once;
  const Tone tone = at_once ? Tone::good : needs_restart_ ? Tone::warning : Tone::muted;
  effect_->setPixmap(glyph_icon(at_once ? Glyph::at_once : Glyph::restart, tone, palette())
                         .pixmap(QSize(kIconSize, kIconSize), devicePixelRatioF()));
  effect_->setToolTip(at_once ? tr("Acts on the run at once")
                      : needs_restart_
                          ? tr("Changed: acts after a restart. The run has %1.").arg(value_words(parameter_, *running_))
                          : tr("Acts after a restart"));
}

QString ParameterRow::problem() const {
  if (!typed_problem_.isEmpty()) return typed_problem_;
  return unused_ ? QString() : document_problem_;
}

void ParameterRow::show_problem() {
  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, tone_colour(Tone::bad, palette()));
  problem_->setPalette(colours);
  problem_->setText(problem());
  problem_->setVisible(!problem().isEmpty());
}

void ParameterRow::set_problem(const QString& problem) {
  document_problem_ = problem;
  show_problem();
}

void ParameterRow::set_running(const Scenario* running) {
  // A run of another scenario may have fewer controllers, or be of another system.
  auto value =
      running != nullptr && is_in(parameter_, *running) ? std::optional(parameter_.get(*running)) : std::nullopt;
  if (value == running_) return;
  running_ = std::move(value);
  show_effect();
}

void ParameterRow::set_read_only(bool read_only) {
  read_only_ = read_only;
  field_->set_read_only(read_only);
  show_reset();
}

bool ParameterRow::matches(const QStringList& words) const {
  return std::all_of(words.begin(), words.end(), [this](const QString& word) { return search_text_.contains(word); });
}

void ParameterRow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    show_reset();
    show_effect();
    show_problem();
  }
  QWidget::changeEvent(event);
}

}  // namespace netpocket
