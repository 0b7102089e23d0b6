#include "gui/workbench/panels/findings_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTableWidget>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "temporary_document.h"

namespace netpocket {
namespace {

std::vector<Finding> findings() {
  return {{"F1", "y is largest", "rule 1", {{"case1", "34 N", Verdict::yes}}},
          {"F2", "peak early", "rule 2", {{"case1", "not yet", Verdict::no}}},
          {"F3", "faster is harder", "rule 3", {{"case1", "34 N", Verdict::undecided}}}};
}

FindingMark mark(const FindingsPanel& panel, int row) {
  return static_cast<FindingMark>(panel.table()->item(row, 0)->data(Qt::UserRole).toInt());
}

TEST(FindingsPanel, MarksYesNoAndPending) {
  FindingsPanel panel;
  panel.set_findings(findings(), true);
  EXPECT_EQ(mark(panel, 0), FindingMark::yes);
  EXPECT_EQ(mark(panel, 1), FindingMark::pending) << "the run goes on";
  panel.set_findings(findings(), false);
  EXPECT_EQ(mark(panel, 1), FindingMark::no);
  EXPECT_EQ(mark(panel, 2), FindingMark::pending) << "one draw decides nothing";
  EXPECT_TRUE(panel.table()->item(2, 1)->toolTip().contains("undecided"));
}

TEST(FindingsPanel, SaysThatARunDiverged) {
  FindingsPanel panel;
  panel.set_findings({{"F1", "y is largest", "rule 1", {{"case1", "the run diverged at t = 3 s", Verdict::diverged}}}},
                     false);
  EXPECT_EQ(mark(panel, 0), FindingMark::pending) << "neither yes nor no";
  EXPECT_EQ(panel.table()->item(0, 0)->data(Qt::AccessibleTextRole).toString(), "diverged");
  panel.set_capture(Verdict::diverged, "the run diverged at t = 3 s");
  EXPECT_TRUE(panel.capture_label()->text().contains("Diverged"));
  EXPECT_FALSE(panel.capture_label()->text().contains("aptured"));
}

TEST(FindingsPanel, RowsHaveValueAndRule) {
  FindingsPanel panel;
  panel.set_findings(findings(), false);
  ASSERT_EQ(panel.table()->rowCount(), 3);
  EXPECT_EQ(panel.table()->item(0, 3)->text(), "34 N");
  EXPECT_TRUE(panel.table()->item(0, 1)->toolTip().contains("rule 1"));
  EXPECT_TRUE(panel.table()->isColumnHidden(2)) << "one run needs no names";
}

TEST(FindingsPanel, SeveralRunsHaveARowEach) {
  std::vector<Finding> list = findings();
  for (Finding& finding : list) finding.cases.push_back({"case2", "42 N", Verdict::no});
  FindingsPanel panel;
  panel.set_findings(list, false);
  EXPECT_EQ(panel.table()->rowCount(), 6);
  EXPECT_FALSE(panel.table()->isColumnHidden(2));
  EXPECT_EQ(panel.table()->rowSpan(0, 1), 2);
  EXPECT_EQ(mark(panel, 4), FindingMark::pending) << "F3 of two single draws";
  EXPECT_EQ(mark(panel, 3), FindingMark::no);
}

TEST(FindingsPanel, SaysWhetherTheTargetIsCaptured) {
  FindingsPanel panel;
  EXPECT_TRUE(panel.capture_label()->text().contains("not decided"));
  panel.set_capture(Verdict::yes, "inside until t = 20 s");
  EXPECT_TRUE(panel.capture_label()->text().contains("Captured"));
  EXPECT_TRUE(panel.capture_label()->text().contains("20 s"));
  panel.set_capture(Verdict::no, "target outside at t = 3 s");
  EXPECT_TRUE(panel.capture_label()->text().contains("Not captured"));
}

TEST(FindingsPanel, ExportsTextAndJson) {
  FindingsPanel panel;
  panel.set_findings(findings(), false);
  QTemporaryDir folder;
  EXPECT_FALSE(panel.export_findings(folder.filePath("f.txt")));
  EXPECT_TRUE(read_file(folder.filePath("f.txt")).contains("faster is harder"));
  EXPECT_FALSE(panel.export_findings(folder.filePath("f.json")));
  const auto json = nlohmann::json::parse(read_file(folder.filePath("f.json")).toStdString());
  EXPECT_EQ(json["findings"].size(), 3u);
  EXPECT_TRUE(panel.export_findings(folder.filePath("no/such.txt")));
}

}  // namespace
}  // namespace netpocket
