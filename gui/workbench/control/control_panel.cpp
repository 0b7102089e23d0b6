#include "gui/workbench/control/control_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/workbench/control/disturbance_form.h"
#include "gui/workbench/control/gain_form.h"
#include "gui/workbench/control/load_bar.h"
#include "gui/workbench/control/loop_values.h"
#include "gui/workbench/editor/group_box.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

enum Column { kLoop, kState, kError, kLoad, kColumns };

constexpr int kRowPadding = 8;   // pixels
constexpr int kVisibleRows = 4;  // at least

QString text_of(const std::string& utf8) { return QString::fromStdString(utf8); }

QString error_text(const LoopReading& reading) {
  if (reading.error.empty()) return QStringLiteral("–");
  const double error = reading.error.size() == 1 ? reading.error.front() : size_of(reading.error);
  return short_number(error) + QChar(0x202f) + reading.unit;
}

Tone state_tone(const std::optional<LoopState>& state) {
  if (!state) return Tone::muted;
  if (*state == LoopState::active) return Tone::good;
  return *state == LoopState::jammed ? Tone::bad : Tone::muted;
}

// Scrolls its content up and down, never sideways.
class DetailsColumn : public QScrollArea {
 public:
  explicit DetailsColumn(QWidget* content) {
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);  // its fields take the keys
  }
  QSize minimumSizeHint() const override {
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(), 80};
  }
};

}  // namespace

ControlPanel::ControlPanel(ScenarioDocument& document, QWidget* parent)
    : QWidget(parent),
      list_(new QTreeWidget),
      empty_(new QLabel(tr("This system has no controllers and no winches. List them in the scenario's text as "
                           "[[controller]] and [winch]; what is there is shown here."))),
      values_(new LoopValues),
      gains_(new GainForm(document)),
      disturbances_(new DisturbanceForm),
      compare_(new QPushButton(tr("Compare without controllers"))) {
  list_->setHeaderLabels({tr("Loop"), tr("State"), tr("Error"), tr("Load")});
  list_->headerItem()->setToolTip(kLoad, tr("Part of the actuators' limit that is asked for; the mark is the limit"));
  list_->headerItem()->setToolTip(kError, tr("By how much what is controlled is off; of vectors the size"));
  list_->headerItem()->setTextAlignment(kError, Qt::AlignRight | Qt::AlignVCenter);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setAccessibleName(tr("Control loops"));
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(kLoop, QHeaderView::Stretch);
  for (const int column : {kState, kError, kLoad}) {
    list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
  list_->setMinimumHeight((kVisibleRows + 1) * (fontMetrics().height() + kRowPadding));
  connect(list_, &QTreeWidget::currentItemChanged, this, &ControlPanel::show_chosen);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setMargin(24);
  empty_->setForegroundRole(QPalette::PlaceholderText);
  auto* split = new QSplitter(Qt::Vertical);
  split->setChildrenCollapsible(false);
  split->addWidget(list_);
  split->addWidget(make_details());
  split->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(empty_);
  layout->addWidget(split, 1);
  rebuild();
}

QWidget* ControlPanel::make_details() {
  auto* content = new QWidget;
  values_box_ = new GroupBox(tr("Values"), tr("What the chosen loop does at the shown time"), content);
  values_box_->add(values_);
  gains_box_ =
      new GroupBox(tr("Gains and set points"), tr("Of the chosen loop; changes act on a run at once"), content);
  gains_box_->add(gains_);
  auto* disturbance = new GroupBox(tr("Disturbance"), tr("Pushes or turns a body of the run for a while"), content);
  disturbance->add(disturbances_);
  for (GroupBox* box : {values_box_, gains_box_, disturbance}) box->set_expanded(true);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 8);
  layout->setSpacing(0);
  layout->addWidget(values_box_);
  layout->addWidget(gains_box_);
  layout->addWidget(disturbance);
  auto* button = new QHBoxLayout;
  button->setContentsMargins(12, 8, 6, 0);
  button->addWidget(compare_);
  layout->addLayout(button);
  layout->addStretch();
  return new DetailsColumn(content);
}

void ControlPanel::show_frame(const std::shared_ptr<const Structure>& structure,
                              const std::shared_ptr<const Snapshot>& frame) {
  frame_ = frame;
  const std::vector<ControlLoopInfo> loops = structure ? structure->loops : std::vector<ControlLoopInfo>();
  if (loops != loops_) {
    const bool appeared = loops_.empty();
    loops_ = loops;
    rebuild();
    if (appeared) emit loops_appeared();
  }
  refresh();
}

void ControlPanel::set_running(const Scenario* running) { gains_->set_running(running); }

void ControlPanel::rebuild() {
  const QString before = list_->currentItem() != nullptr ? list_->currentItem()->text(kLoop) : QString();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const ControlLoopInfo& loop : loops_) {
      auto* item = new QTreeWidgetItem(list_, {engine_words(loop.name)});
      item->setToolTip(kLoop,
                       tr("%1: controls the %2 of the %3")
                           .arg(engine_words(loop.name), engine_words(loop.quantity), engine_words(loop.acts_on)));
      item->setSizeHint(kLoop, QSize(0, fontMetrics().height() + kRowPadding));
      item->setTextAlignment(kError, Qt::AlignRight | Qt::AlignVCenter);
      list_->setItemWidget(item, kLoad, new LoadBar);
      if (list_->currentItem() == nullptr || item->text(kLoop) == before) list_->setCurrentItem(item);
    }
  }
  list_->setVisible(!loops_.empty());
  empty_->setVisible(loops_.empty());
  values_box_->setVisible(!loops_.empty());
  gains_box_->setVisible(!loops_.empty());
  compare_->setVisible(!loops_.empty());
  refresh();
  show_chosen();
}

void ControlPanel::refresh() {
  const std::vector<double> none;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    const ControlLoopInfo& loop = loops_[static_cast<std::size_t>(i)];
    const ChannelList& channels = frame_ ? *frame_->channel_list : *known_channels();
    const LoopReading reading = read_loop(loop, channels, frame_ ? frame_->channels : none);
    QTreeWidgetItem* item = list_->topLevelItem(i);
    item->setText(kState, reading.state ? state_words(*reading.state) : QStringLiteral("–"));
    item->setForeground(kState, tone_colour(state_tone(reading.state), palette()));
    item->setText(kError, error_text(reading));
    auto* bar = static_cast<LoadBar*>(list_->itemWidget(item, kLoad));
    bar->show_load(reading.load, !loop.load.empty(), reading.is_saturated());
    item->setData(kLoad, Qt::AccessibleTextRole, bar->text());
    if (list_->currentItem() == item) values_->show_loop(loop, reading);
  }
}

const ControlLoopInfo* ControlPanel::chosen() const {
  const int index = list_->indexOfTopLevelItem(list_->currentItem());
  return index < 0 || index >= static_cast<int>(loops_.size()) ? nullptr : &loops_[static_cast<std::size_t>(index)];
}

void ControlPanel::show_chosen() {
  const ControlLoopInfo* loop = chosen();
  gains_->show_table(loop != nullptr ? text_of(loop->table) : QString());
  emit loop_chosen(loop != nullptr ? text_of(loop->name) : QString());
  refresh();
}

QString ControlPanel::text(int loop, int column) const {
  QTreeWidgetItem* item = list_->topLevelItem(loop);
  if (column == kLoad) return static_cast<LoadBar*>(list_->itemWidget(item, kLoad))->text();
  return item->text(column);
}

void ControlPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();
}

}  // namespace netpocket
