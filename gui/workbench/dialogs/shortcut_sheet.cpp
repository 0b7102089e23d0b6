#include "gui/workbench/dialogs/shortcut_sheet.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <vector>

#include "gui/workbench/panels/focus_frame.h"
#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

constexpr int kKeysWidth = 110;  // pixels

struct Line {
  QString keys;
  QString what;
};
struct Section {
  QString title;
  std::vector<Line> lines;
};

// Without the letter to press: "File" for "&File", and for "文件(&F)" in languages that put it behind.
QString plain(QString text) {
  static const QRegularExpression kBehind(R"(\(&\w\))");
  return text.remove(kBehind).remove('&');
}

void collect(const QMenu& menu, std::vector<Line>& lines) {
  for (const QAction* action : menu.actions()) {
    if (action->menu()) {
      collect(*action->menu(), lines);
    } else if (!action->shortcut().isEmpty()) {
      lines.push_back({action->shortcut().toString(QKeySequence::NativeText), plain(action->text())});
    }
  }
}

std::vector<Section> sections(const QMenuBar& menus) {
  std::vector<Section> sections;
  for (const QAction* action : menus.actions()) {
    Section section{plain(action->text()), {}};
    if (action->menu()) collect(*action->menu(), section.lines);
    if (!section.lines.empty()) sections.push_back(section);
  }
  sections.push_back({ShortcutSheet::tr("Viewport"),
                      {{ShortcutSheet::tr("Left drag, arrows"), ShortcutSheet::tr("Orbit")},
                       {ShortcutSheet::tr("Shift or middle drag"), ShortcutSheet::tr("Pan (Shift with arrows)")},
                       {ShortcutSheet::tr("Ctrl drag"), ShortcutSheet::tr("Roll")},
                       {ShortcutSheet::tr("Wheel, right drag, + −"), ShortcutSheet::tr("Zoom")},
                       {ShortcutSheet::tr("Click"), ShortcutSheet::tr("Pick a cord, node or body")},
                       {ShortcutSheet::tr("Double click"), ShortcutSheet::tr("Look at what is there")},
                       {ShortcutSheet::tr("Drag while moving bodies"), ShortcutSheet::tr("Move target or spacecraft")},
                       {ShortcutSheet::tr("Esc"), ShortcutSheet::tr("Clear the selection")}}});
  sections.push_back({ShortcutSheet::tr("Timeline"),
                      {{ShortcutSheet::tr("Left, right"), ShortcutSheet::tr("One frame back, on")},
                       {ShortcutSheet::tr("Page Up, Page Down"), ShortcutSheet::tr("One second back, on")},
                       {ShortcutSheet::tr("Home, End"), ShortcutSheet::tr("Start, end")}}});
  sections.push_back({ShortcutSheet::tr("Plots"),
                      {{ShortcutSheet::tr("Click"), ShortcutSheet::tr("Go to this time")},
                       {ShortcutSheet::tr("Wheel, + −"), ShortcutSheet::tr("Zoom in time")},
                       {ShortcutSheet::tr("Drag, left, right"), ShortcutSheet::tr("Pan in time")},
                       {ShortcutSheet::tr("Double click, Home"), ShortcutSheet::tr("All times")}}});
  sections.push_back({ShortcutSheet::tr("Runs"),
                      {{ShortcutSheet::tr("Up, down"), ShortcutSheet::tr("Show this run")},
                       {ShortcutSheet::tr("Space"), ShortcutSheet::tr("Draw it over the shown run in the plots")},
                       {ShortcutSheet::tr("F2, Del"), ShortcutSheet::tr("Rename, remove")}}});
  return sections;
}

QWidget* make_section(const Section& section) {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 12);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(1);
  grid->setColumnMinimumWidth(0, kKeysWidth);
  auto* title = new QLabel(section.title);
  QFont font = title->font();
  font.setBold(true);
  title->setFont(font);
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 1;
  for (const Line& line : section.lines) {
    auto* keys = new QLabel(line.keys);
    QPalette colours = keys->palette();
    colours.setColor(QPalette::WindowText, tone_colour(Tone::accent, colours));
    keys->setPalette(colours);
    grid->addWidget(keys, row, 0);
    grid->addWidget(new QLabel(line.what), row++, 1);
  }
  grid->setColumnStretch(1, 1);
  return box;
}

}  // namespace

ShortcutSheet::ShortcutSheet(const QMenuBar& menus, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Keyboard and mouse"));
  auto* page = new QWidget;
  auto* columns = new QHBoxLayout(page);
  columns->setSpacing(32);
  const auto all = sections(menus);
  // Columns of about equal length.
  std::size_t lines = 0;
  for (const Section& section : all) lines += section.lines.size() + 2;
  constexpr std::size_t kColumns = 3;
  QVBoxLayout* column = nullptr;
  std::size_t used = 0, count = 0;
  for (const Section& section : all) {
    // A section goes where most of it fits.
    const std::size_t middle = used + section.lines.size() / 2;
    if (column == nullptr || (middle * kColumns >= count * lines && count < kColumns)) {
      column = new QVBoxLayout;
      columns->addLayout(column);
      ++count;
    }
    column->addWidget(make_section(section));
    used += section.lines.size() + 2;
  }
  for (auto* layout : page->findChildren<QVBoxLayout*>()) layout->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setAccessibleName(tr("All keys"));
  new FocusFrame(scroll);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(scroll);
  layout->addWidget(buttons);
  // Never cut at the side; as high as the screen has room for.
  const QSize wanted = page->sizeHint() + QSize(scroll->verticalScrollBar()->sizeHint().width() + 40, 70);
  resize(wanted.boundedTo(screen()->availableSize() * 0.95));
}

}  // namespace netpocket
