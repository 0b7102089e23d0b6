#include "gui/workbench/runs_panel.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

enum Column { kName, kTime, kState, kColumnCount };
constexpr int kIdRole = Qt::UserRole;
constexpr int kRowPadding = 8;  // pixels

RunId id_of(const QTreeWidgetItem& item) { return item.data(kName, kIdRole).toInt(); }

QString state_name(const Run& run) {
  if (run.status.reason == RunReason::diverged) return RunsPanel::tr("diverged");
  if (run.status.reason == RunReason::limited) return RunsPanel::tr("at its limit of steps");
  switch (run.state) {
    case RunState::preparing:
      return RunsPanel::tr("preparing");
    case RunState::running:
      return RunsPanel::tr("running");
    case RunState::paused:
      return RunsPanel::tr("paused");
    case RunState::ended:
      return RunsPanel::tr("finished");
    case RunState::recorded:
      break;
  }
  return RunsPanel::tr("recorded");
}

}  // namespace

RunsPanel::RunsPanel(CaptureSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      list_(new QTreeWidget),
      empty_(new QLabel(tr("Runs and opened recordings are listed here."))) {
  list_->setHeaderLabels({tr("Run"), tr("Until"), tr("State")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(kTime, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(kState, QHeaderView::ResizeToContents);
  list_->header()->setStretchLastSection(false);
  list_->setAccessibleName(tr("Runs"));
  list_->setToolTip(
      tr("Select: show this run. Tick: draw it over the shown run in the plots. F2: rename. Del: remove"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list_);
  layout->addWidget(empty_);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setMargin(24);
  empty_->setForegroundRole(QPalette::PlaceholderText);
  show_list();

  auto* remove_action = new QAction(tr("Remove"), list_);
  remove_action->setShortcut(Qt::Key_Delete);
  remove_action->setShortcutContext(Qt::WidgetShortcut);
  list_->addAction(remove_action);
  connect(remove_action, &QAction::triggered, this, [this] {
    if (const auto* item = list_->currentItem()) emit remove_requested(id_of(*item));
  });
  connect(list_, &QTreeWidget::customContextMenuRequested, this, &RunsPanel::show_menu);
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item && (!session_.current() || session_.current()->id != id_of(*item))) session_.show_run(id_of(*item));
  });
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (column != kName) return;
    session_.runs().rename(id_of(*item), item->text(kName));
    emit compared_changed();
  });
  connect(&session_.runs(), &RunLibrary::run_added, this, &RunsPanel::add);
  connect(&session_.runs(), &RunLibrary::run_removed, this, &RunsPanel::remove);
  connect(&session_.runs(), &RunLibrary::run_changed, this, &RunsPanel::refresh);
  connect(&session_.runs(), &RunLibrary::frames_added, this, &RunsPanel::refresh);
  connect(&session_, &CaptureSession::current_changed, this, &RunsPanel::mark_current);
}

QTreeWidgetItem* RunsPanel::item_of(RunId id) const {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    if (id_of(*list_->topLevelItem(i)) == id) return list_->topLevelItem(i);
  }
  return nullptr;
}

void RunsPanel::add(RunId id) {
  const QSignalBlocker quiet(list_);
  auto* item = new QTreeWidgetItem(list_);
  item->setData(kName, kIdRole, id);
  item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
  item->setCheckState(kName, Qt::Unchecked);
  item->setSizeHint(kName, QSize(0, fontMetrics().height() + kRowPadding));
  item->setTextAlignment(kTime, Qt::AlignRight | Qt::AlignVCenter);
  refresh(id);
  show_list();
}

void RunsPanel::show_list() {
  list_->setVisible(list_->topLevelItemCount() > 0);
  empty_->setVisible(list_->topLevelItemCount() == 0);
}

void RunsPanel::remove(RunId id) {
  const QSignalBlocker quiet(list_);
  delete item_of(id);
  show_list();
  emit compared_changed();
}

void RunsPanel::refresh(RunId id) {
  const Run* run = session_.runs().find(id);
  auto* item = item_of(id);
  if (run == nullptr || item == nullptr) return;
  const QSignalBlocker quiet(list_);
  item->setText(kName, run->name);
  item->setText(kTime, tr("%1 s").arg(run->end_time(), 0, 'f', 2));
  item->setText(kState, state_name(*run));
  const bool diverged = run->status.reason == RunReason::diverged;
  item->setForeground(kState, diverged ? tone_colour(Tone::bad, palette()) : QBrush());
}

void RunsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (const RunId id : session_.runs().ids()) refresh(id);
}

void RunsPanel::mark_current() {
  const QSignalBlocker quiet(list_);
  const Run* run = session_.current();
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    auto* item = list_->topLevelItem(i);
    QFont font = list_->font();
    font.setBold(run != nullptr && id_of(*item) == run->id);
    item->setFont(kName, font);
    if (font.bold()) list_->setCurrentItem(item);
  }
  emit compared_changed();
}

std::vector<RunId> RunsPanel::compared() const {
  std::vector<RunId> ids;
  const Run* shown = session_.current();
  if (shown) ids.push_back(shown->id);
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    const auto* item = list_->topLevelItem(i);
    if (item->checkState(kName) == Qt::Checked && (!shown || id_of(*item) != shown->id)) ids.push_back(id_of(*item));
  }
  return ids;
}

void RunsPanel::compare_with(RunId id) {
  if (auto* item = item_of(id)) item->setCheckState(kName, Qt::Checked);
}

void RunsPanel::show_menu(const QPoint& position) {
  auto* item = list_->itemAt(position);
  if (item == nullptr) return;
  QMenu menu;
  menu.addAction(tr("Rename"), this, [this, item] { list_->editItem(item, kName); });
  menu.addAction(tr("Remove"), this, [this, item] { emit remove_requested(id_of(*item)); });
  menu.exec(list_->viewport()->mapToGlobal(position));
}

}  // namespace netpocket
