#include "gui/workbench/editor/group_box.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/workbench/panels/tones.h"

namespace netpocket {

GroupBox::GroupBox(const QString& title, const QString& tool_tip, QWidget* parent)
    : QWidget(parent),
      heading_(new QToolButton(this)),
      counts_(new QLabel(this)),
      body_(new QWidget(this)),
      body_layout_(new QVBoxLayout(body_)) {
  heading_->setText(title);
  heading_->setToolTip(tool_tip);
  heading_->setCheckable(true);
  heading_->setChecked(true);
  heading_->setAutoRaise(true);
  heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  heading_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  heading_->setFocusPolicy(Qt::TabFocus);
  QFont bold = heading_->font();
  bold.setBold(true);
  heading_->setFont(bold);
  counts_->setTextFormat(Qt::RichText);
  counts_->setAttribute(Qt::WA_TransparentForMouseEvents);

  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(2, 4, 4, 0);
  bar->addWidget(heading_);
  auto* inside = new QHBoxLayout(heading_);
  inside->setContentsMargins(0, 0, 8, 0);
  inside->addStretch();
  inside->addWidget(counts_);
  body_layout_->setContentsMargins(0, 2, 0, 6);
  body_layout_->setSpacing(2);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(body_);
  connect(heading_, &QToolButton::clicked, this, [this] {
    forced_ = false;
    show_state();
    emit toggled();
  });
  show_state();
}

void GroupBox::add(QWidget* widget) { body_layout_->addWidget(widget); }

bool GroupBox::is_expanded() const { return heading_->isChecked(); }

void GroupBox::set_expanded(bool expanded) {
  heading_->setChecked(expanded);
  show_state();
}

void GroupBox::force_open(bool open) {
  forced_ = open;
  show_state();
}

void GroupBox::show_state() {
  const bool open = is_expanded() || forced_;
  heading_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  body_->setVisible(open);
}

void GroupBox::set_counts(int changed, int problems) {
  changed_ = changed;
  problems_ = problems;
  show_counts();
}

void GroupBox::show_counts() {
  const auto badge = [this](Tone tone, const QString& words) {
    return QString("<span style='color:%1'>%2</span>").arg(tone_colour(tone, palette()).name(), words);
  };
  QStringList badges;
  if (problems_ > 0) badges << badge(Tone::bad, problems_ == 1 ? tr("1 problem") : tr("%1 problems").arg(problems_));
  if (changed_ > 0) badges << badge(Tone::accent, tr("%1 changed").arg(changed_));
  counts_->setText(badges.join(" &nbsp; "));
}

void GroupBox::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_counts();
  QWidget::changeEvent(event);
}

}  // namespace netpocket
