#include "gui/workbench/viewport/pick_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace netpocket {

PickPanel::PickPanel(QWidget* parent)
    : QFrame(parent), title_(new QLabel), detail_(new QLabel), rows_(new QFormLayout) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setAccessibleName(tr("Selection"));
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  detail_->setWordWrap(true);
  detail_->setForegroundRole(QPalette::PlaceholderText);

  auto* close = new QToolButton;
  close->setText(QString::fromUtf8("×"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Clear the selection (Esc)"));
  close->setAccessibleName(tr("Clear the selection"));
  connect(close, &QToolButton::clicked, this, &PickPanel::closed);
  auto* plot = new QPushButton(tr("Plot over time"));
  plot->setToolTip(tr("Draw this over all frames of the run"));
  connect(plot, &QPushButton::clicked, this, &PickPanel::plot_requested);

  auto* heading = new QHBoxLayout;
  heading->addWidget(title_, 1);
  heading->addWidget(close);
  rows_->setHorizontalSpacing(12);
  rows_->setVerticalSpacing(2);
  rows_->setLabelAlignment(Qt::AlignLeft);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 6, 10);
  layout->setSpacing(4);
  layout->addLayout(heading);
  layout->addWidget(detail_);
  layout->addLayout(rows_);
  layout->addWidget(plot);
  hide();
}

void PickPanel::set_description(const PickDescription& description) {
  title_->setText(description.title);
  detail_->setText(description.detail);
  const int count = static_cast<int>(description.rows.size());
  while (rows_->rowCount() > count) rows_->removeRow(rows_->rowCount() - 1);
  while (rows_->rowCount() < count) {
    auto* label = new QLabel;
    label->setForegroundRole(QPalette::PlaceholderText);
    auto* value = new QLabel;
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    rows_->addRow(label, value);
    // At once, so that the panel's size counts them.
    label->show();
    value->show();
  }
  for (int i = 0; i < count; ++i) {
    const auto text = [&](QFormLayout::ItemRole role, const QString& t) {
      static_cast<QLabel*>(rows_->itemAt(i, role)->widget())->setText(t);
    };
    text(QFormLayout::LabelRole, description.rows[static_cast<std::size_t>(i)].label);
    text(QFormLayout::FieldRole, description.rows[static_cast<std::size_t>(i)].value);
  }
  // Wide enough not to change size with every frame.
  setMinimumWidth(fontMetrics().averageCharWidth() * 44);
  layout()->activate();
  adjustSize();
}

}  // namespace netpocket
