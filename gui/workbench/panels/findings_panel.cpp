#include "gui/workbench/panels/findings_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/analysis/report.h"
#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "gui/workbench/panels/ask_for_file.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/icons.h"

namespace netpocket {
namespace {

constexpr int kRowPadding = 8;  // pixels

enum Column { kMark, kStatement, kRun, kValue, kColumns };

Glyph glyph(FindingMark mark) {
  if (mark == FindingMark::pending) return Glyph::pending;
  return mark == FindingMark::yes ? Glyph::yes : Glyph::no;
}

Tone tone(FindingMark mark) {
  if (mark == FindingMark::pending) return Tone::muted;
  return mark == FindingMark::yes ? Tone::good : Tone::bad;
}

// Lines may break at a bar: "|F_x|" stays in one piece with a word joiner after its first bar.
QString with_magnitudes_whole(QString words) { return words.replace("|F", QString("|") + QChar(0x2060) + "F"); }

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

}  // namespace

FindingMark finding_mark(const FindingCase& finding_case, bool running) {
  if (finding_case.verdict == Verdict::yes) return FindingMark::yes;
  return finding_case.verdict == Verdict::no && !running ? FindingMark::no : FindingMark::pending;
}

CaptureWords capture_words(Verdict captured) {
  switch (captured) {
    case Verdict::yes:
      return {FindingsPanel::tr("Captured"), FindingsPanel::tr("Captured"), Tone::good};
    case Verdict::no:
      return {FindingsPanel::tr("Not captured"), FindingsPanel::tr("Not captured"), Tone::bad};
    case Verdict::diverged:
      return {FindingsPanel::tr("Diverged"), FindingsPanel::tr("Diverged"), Tone::bad};
    default:
      return {FindingsPanel::tr("Capture not decided yet"), FindingsPanel::tr("Undecided"), Tone::muted};
  }
}

FindingsPanel::FindingsPanel(QWidget* parent)
    : QWidget(parent),
      capture_(new QLabel(this)),
      counts_(new QLabel(this)),
      empty_(new QLabel(tr("Findings F1 to F11 appear here once a run has recorded frames."), this)),
      export_(new QToolButton(this)),
      table_(new QTableWidget(this)) {
  capture_->setContentsMargins(10, 7, 10, 7);
  capture_->setWordWrap(true);
  capture_->setAutoFillBackground(true);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setMargin(24);
  empty_->setForegroundRole(QPalette::PlaceholderText);
  export_->setText(tr("Export…"));
  export_->setToolTip(tr("Save the findings as text or JSON"));
  connect(export_, &QToolButton::clicked, this, &FindingsPanel::ask_for_export);

  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels({QString(), tr("Finding"), tr("Run"), tr("Found")});
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(kMark, QHeaderView::Fixed);
  table_->horizontalHeader()->setSectionResizeMode(kStatement, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(kRun, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kValue, QHeaderView::Stretch);
  table_->setColumnWidth(kMark, 30);
  table_->setTabKeyNavigation(false);  // Tab goes on to what comes next
  table_->setWordWrap(true);
  table_->setShowGrid(false);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  fit_.setSingleShot(true);
  fit_.setInterval(0);
  connect(&fit_, &QTimer::timeout, this, &FindingsPanel::fit_rows);
  connect(table_->horizontalHeader(), &QHeaderView::sectionResized, &fit_, qOverload<>(&QTimer::start));
  table_->setAccessibleName(tr("Findings"));

  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(10, 4, 6, 4);
  bar->addWidget(counts_, 1);
  bar->addWidget(export_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(capture_);
  layout->addLayout(bar);
  layout->addWidget(empty_, 1);
  layout->addWidget(table_, 1);
  set_capture(Verdict::unknown, {});
  fill();
}

void FindingsPanel::set_findings(std::vector<Finding> findings, bool running) {
  findings_ = std::move(findings);
  running_ = running;
  fill();
}

void FindingsPanel::set_capture(Verdict captured, const QString& detail) {
  captured_ = captured;
  capture_detail_ = detail;
  show_capture();
}

void FindingsPanel::show_capture() {
  const auto [headline, brief, tone] = capture_words(captured_);
  const QString detail = capture_detail_.isEmpty() ? QString() : ": " + engine_words(capture_detail_).toHtmlEscaped();
  capture_->setText("<b>" + headline + "</b>" + detail);
  QPalette colours = palette();
  colours.setColor(QPalette::Window, ground_colour(tone, palette()));
  colours.setColor(QPalette::WindowText,
                   tone == Tone::muted ? palette().color(QPalette::WindowText) : tone_colour(tone, palette()));
  capture_->setPalette(colours);
}

void FindingsPanel::fill() {
  scrolled_ = table_->verticalScrollBar()->value();
  table_->setRowCount(0);
  const bool several = !findings_.empty() && findings_.front().cases.size() > 1;
  table_->setColumnHidden(kRun, !several);
  for (const Finding& finding : findings_) add_rows(finding);
  fit_.start();
  table_->setVisible(!findings_.empty());
  empty_->setVisible(findings_.empty());
  export_->setVisible(!findings_.empty());
  counts_->setVisible(!findings_.empty());
  show_counts();
}

void FindingsPanel::add_rows(const Finding& finding) {
  const int first = table_->rowCount();
  for (const FindingCase& finding_case : finding.cases) {
    table_->insertRow(table_->rowCount());
    add_case(table_->rowCount() - 1, finding, finding_case);
  }
  const int count = table_->rowCount() - first;
  if (count > 1) table_->setSpan(first, kStatement, count, 1);
}

void FindingsPanel::add_case(int row, const Finding& finding, const FindingCase& finding_case) {
  const FindingMark mark = finding_mark(finding_case, running_);
  const bool open = running_ && mark == FindingMark::pending;
  const QString word = open ? tr("not decided yet") : engine_words(std::string_view(to_string(finding_case.verdict)));
  const QString rule =
      tr("<p><b>%1: %2</b></p><p>Rule: %3</p>").arg(text(finding.id), word, engine_words(finding.rule).toHtmlEscaped());
  const bool first = &finding_case == &finding.cases.front();
  const QStringList texts = {QString(), first ? text(finding.id) + "  " + engine_words(finding.text) : QString(),
                             text(finding_case.name), with_magnitudes_whole(engine_words(finding_case.value))};
  // Every other finding stands on another ground.
  const bool odd = (&finding - findings_.data()) % 2 == 1;
  const QBrush ground = odd ? palette().alternateBase() : palette().base();
  for (int column = 0; column < kColumns; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setToolTip(rule);
    item->setTextAlignment(Qt::AlignVCenter | Qt::AlignLeft);
    item->setBackground(ground);
    table_->setItem(row, column, item);
  }
  table_->item(row, kMark)->setIcon(glyph_icon(glyph(mark), tone(mark), palette()));
  table_->item(row, kMark)->setData(Qt::AccessibleTextRole, word);
  table_->item(row, kMark)->setData(Qt::UserRole, static_cast<int>(mark));
}

void FindingsPanel::show_counts() {
  int holding = 0;
  for (const Finding& finding : findings_) {
    holding += std::all_of(finding.cases.begin(), finding.cases.end(), [](const auto& c) { return c.holds(); }) ? 1 : 0;
  }
  const int all = static_cast<int>(findings_.size());
  counts_->setText(all == 0   ? QString()
                   : running_ ? tr("%1 of %2 hold so far").arg(holding).arg(all)
                              : tr("%1 of %2 hold").arg(holding).arg(all));
}

void FindingsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    show_capture();
    fill();
  }
  QWidget::changeEvent(event);
}

void FindingsPanel::fit_rows() {
  table_->resizeRowsToContents();
  for (int row = 0; row < table_->rowCount(); ++row) table_->setRowHeight(row, table_->rowHeight(row) + kRowPadding);
  if (scrolled_) table_->verticalScrollBar()->setValue(*scrolled_);
  scrolled_.reset();
}

std::optional<QString> FindingsPanel::export_findings(const QString& path) const {
  const bool json = path.endsWith(".json", Qt::CaseInsensitive);
  const std::string bytes = json ? findings_json(findings_).dump(2) + "\n" : findings_text(findings_);
  const FileKind kind = json ? FileKind::json : FileKind::findings;
  try {
    OutputList().add("findings", path.toStdString(), kind);
    write_whole_file(path.toStdString(), kind, bytes);
  } catch (const FileError& error) {
    return QString::fromStdString(error.what());
  }
  return std::nullopt;
}

void FindingsPanel::ask_for_export() {
  const FileQuestion question = {tr("Export findings"), "findings.txt", tr("Text (*.txt);;JSON (*.json)"), "txt"};
  ask_for_file(this, question, [this](const QString& path) {
    const auto problem = export_findings(path);
    if (problem) {
      emit export_failed(*problem);
    } else {
      emit exported(path);
    }
  });
}

}  // namespace netpocket
