#include "gui/workbench/start/start_page.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/workbench/editor/presets.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/start/card_delegate.h"

namespace netpocket {
namespace {

constexpr QSize kPicture(224, 140);  // logical pixels, as drawn
constexpr double kLeastWidth = 13;   // of a picture, in heights of a line
constexpr int kWaysWidth = 18;       // of the column at the left, in heights of a line
constexpr qsizetype kMostShown = 8;

QLabel* make_heading(const QString& text, double scale) {
  auto* heading = new QLabel(text);
  QFont font = heading->font();
  font.setPointSizeF(scale * font.pointSizeF());
  font.setBold(true);
  heading->setFont(font);
  return heading;
}

QListWidget* make_list(const QString& name, const QSize& picture) {
  auto* list = new QListWidget;
  list->setAccessibleName(name);
  list->setFrameShape(QFrame::NoFrame);
  list->setItemDelegate(new CardDelegate(picture, list));
  list->setMouseTracking(true);
  list->setSelectionMode(QAbstractItemView::NoSelection);  // a choice opens at once
  list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->viewport()->setAutoFillBackground(false);
  return list;
}

// A click chooses, and so does Enter.
template <typename Choose>
void on_choice(QListWidget* list, const Choose& choose) {
  QObject::connect(list, &QListWidget::itemClicked, list, choose);
  QObject::connect(list, &QListWidget::itemActivated, list, [list, choose](QListWidgetItem* item) {
    if (list->isVisible()) choose(item);  // the first click of a double click has chosen already
  });
}

// "~/runs" for a folder in the user's own.
QString folder_words(const QString& path) {
  const QString folder = QFileInfo(path).path(), home = QDir::homePath();
  return folder.startsWith(home) ? "~" + folder.mid(home.size()) : folder;
}

}  // namespace

StartPage::StartPage(QWidget* window)
    : QFrame(window),
      guide_(new QPushButton(tr("&Guided first capture"))),
      recent_(make_list(tr("Recent files"), {})),
      no_recent_(new QLabel(tr("Files that you open are listed here."))),
      scenarios_(make_list(tr("Scenarios that come with the program"), kPicture)) {
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Window);
  setAccessibleName(tr("Start page"));
  auto* title = make_heading(QStringLiteral("Netpocket"), 2.2);
  auto* sentence = new QLabel(tr("Simulates how a pocket of net captures space debris."));
  auto* close = new QPushButton(tr("To the &window"));
  close->setToolTip(tr("Close this page (Esc); the menu Help brings it back"));
  connect(close, &QPushButton::clicked, this, &StartPage::close_page);
  auto* top = new QHBoxLayout;
  top->addWidget(title);
  top->addSpacing(12);
  top->addWidget(sentence, 1, Qt::AlignBottom);
  top->addWidget(close);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(28);
  columns->addWidget(make_ways());
  columns->addWidget(make_scenarios(), 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(36, 24, 28, 20);
  layout->setSpacing(20);
  layout->addLayout(top);
  layout->addLayout(columns, 1);
  // With Tab, first what stands first.
  setTabOrder(close, guide_);
  connect(&pictures_, &ScenarioPictures::drawn, this, [this](int preset, const QImage& picture) {
    if (auto* item = scenarios_->item(preset)) item->setData(CardDelegate::kPictureRole, picture);
  });
  window->installEventFilter(this);
  hide();
}

QWidget* StartPage::make_ways() {
  auto* make = new QPushButton(tr("&New scenario"));
  auto* open = new QPushButton(tr("&Open…"));
  guide_->setToolTip(tr("Six steps from the pocket to a picture of its capture"));
  make->setToolTip(tr("Start from the defaults"));
  open->setToolTip(tr("Open a scenario (.toml) or a recording (.h5)"));
  guide_->setDefault(true);
  connect(guide_, &QPushButton::clicked, this, &StartPage::guide_chosen);
  connect(make, &QPushButton::clicked, this, &StartPage::new_chosen);
  connect(open, &QPushButton::clicked, this, &StartPage::open_chosen);
  on_choice(recent_, [this](QListWidgetItem* item) { emit file_chosen(item->data(Qt::UserRole).toString()); });
  no_recent_->setWordWrap(true);
  no_recent_->setForegroundRole(QPalette::Text);
  auto* ways = new QWidget;
  ways->setFixedWidth(kWaysWidth * fontMetrics().height());
  auto* layout = new QVBoxLayout(ways);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(make_heading(tr("Begin"), 1.2));
  for (QPushButton* button : {guide_, make, open}) {
    button->setMinimumHeight(2 * fontMetrics().height() + 4);
    layout->addWidget(button);
  }
  layout->addSpacing(14);
  layout->addWidget(make_heading(tr("Recent"), 1.2));
  layout->addWidget(no_recent_);
  layout->addWidget(recent_, 1);
  layout->addStretch();
  return ways;
}

QWidget* StartPage::make_scenarios() {
  scenarios_->setViewMode(QListView::IconMode);
  scenarios_->setResizeMode(QListView::Adjust);
  scenarios_->setMovement(QListView::Static);
  scenarios_->setUniformItemSizes(true);
  on_choice(scenarios_, [this](QListWidgetItem* item) { emit scenario_chosen(item->text()); });
  scenarios_->viewport()->installEventFilter(this);
  fill_scenarios();
  auto* part = new QWidget;
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(make_heading(tr("Scenarios that come with the program"), 1.2));
  layout->addWidget(scenarios_, 1);
  return part;
}

void StartPage::fill_scenarios() {
  for (const Preset& preset : presets()) {
    auto* item = new QListWidgetItem(preset.name, scenarios_);
    const QString sentence = sentence_of(preset);
    item->setData(CardDelegate::kSentenceRole, sentence);
    item->setData(Qt::AccessibleDescriptionRole, sentence);
    item->setToolTip("<p>" + sentence.toHtmlEscaped() + "</p>");
  }
  scenarios_->setCurrentRow(0);
}

void StartPage::set_recent(const QStringList& paths) {
  recent_->clear();
  for (const QString& path : paths) {
    if (recent_->count() == kMostShown) break;
    if (!QFileInfo::exists(path)) continue;
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), recent_);
    item->setData(Qt::UserRole, path);
    item->setData(CardDelegate::kSentenceRole, folder_words(path));
    item->setToolTip(path);
  }
  recent_->setCurrentRow(0);
  recent_->setVisible(recent_->count() > 0);
  no_recent_->setVisible(recent_->count() == 0);
}

void StartPage::open_page() {
  if (!drawn_) draw_pictures();
  cover_window();
  show();
  raise();
  guide_->setFocus(Qt::OtherFocusReason);
}

void StartPage::close_page() {
  if (isHidden()) return;
  hide();
  emit closed();
}

// As many in a row as there is room for, and together as wide as the list.
void StartPage::fit_cards() {
  const int space = scenarios_->width() - scenarios_->verticalScrollBar()->sizeHint().width() - 1;
  const int extra = CardDelegate::extra_width();
  const int least = static_cast<int>(kLeastWidth * fontMetrics().height()) + extra;
  const int width = space / std::max(1, space / least) - extra;
  if (width < 1) return;
  auto* cards = static_cast<CardDelegate*>(scenarios_->itemDelegate());
  cards->set_picture_size({width, width * kPicture.height() / kPicture.width()});
  scenarios_->doItemsLayout();
}

void StartPage::draw_pictures() {
  drawn_ = true;
  pictures_.draw(2 * kPicture, is_dark(palette()) ? Background::space : Background::white);
}

void StartPage::cover_window() {
  const auto* window = qobject_cast<QMainWindow*>(parentWidget());
  const int top = window != nullptr && !window->menuBar()->isNativeMenuBar() ? window->menuBar()->height() : 0;
  setGeometry(parentWidget()->rect().adjusted(0, top, 0, 0));
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QFrame::keyPressEvent(event);
  close_page();
}

void StartPage::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && drawn_) draw_pictures();
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  const bool moved = event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest;
  if (watched == parentWidget() && moved && isVisible()) cover_window();
  const bool resized = event->type() == QEvent::Resize && watched == scenarios_->viewport();
  if (resized && scenarios_->width() != fitted_width_) {
    fitted_width_ = scenarios_->width();
    fit_cards();
  }
  return QFrame::eventFilter(watched, event);
}

// What the page covers cannot be seen, so Tab goes round on the page.
bool StartPage::focusNextPrevChild(bool next) {
  QWidget* from = focusWidget() != nullptr ? focusWidget() : this;
  for (QWidget* widget = from;;) {
    widget = next ? widget->nextInFocusChain() : widget->previousInFocusChain();
    if (widget == from) return false;
    const bool takes_keys = widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0;
    if (!takes_keys || !isAncestorOf(widget)) continue;
    widget->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
  }
}

}  // namespace netpocket
