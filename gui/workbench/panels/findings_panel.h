#pragma once
// The findings dock: whether the run so far shows what the paper found, F1 to F11, and whether the target is captured.

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "engine/analysis/summary.h"
#include "gui/workbench/panels/tones.h"

class QLabel;
class QTableWidget;
class QToolButton;

namespace netpocket {

// What is known of a finding for one run.
enum class FindingMark { yes, no, pending };

// Pending: there is no judgement (verdict.h), or it does not hold yet in a run that goes on.
FindingMark finding_mark(const FindingCase& finding_case, bool running);

// The headline of a capture and the colour of its meaning.
struct CaptureWords {
  QString text;
  QString brief;  // where it stands under "target"
  Tone tone;
};
CaptureWords capture_words(Verdict captured);

class FindingsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit FindingsPanel(QWidget* parent = nullptr);

  // `running`: more frames may come, so what does not hold is not decided.
  void set_findings(std::vector<Finding> findings, bool running);
  const std::vector<Finding>& findings() const { return findings_; }

  // The line on top; `detail` is one short sentence, e.g. since when or why not.
  void set_capture(Verdict captured, const QString& detail);

  // As text, or as JSON when the path ends so. Why not, when it fails.
  [[nodiscard]] std::optional<QString> export_findings(const QString& path) const;

  QTableWidget* table() const { return table_; }
  QLabel* capture_label() const { return capture_; }

 signals:
  void exported(const QString& path);
  void export_failed(const QString& reason);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  void fit_rows();
  void add_rows(const Finding& finding);
  void add_case(int row, const Finding& finding, const FindingCase& finding_case);
  void show_capture();
  void show_counts();
  void ask_for_export();

  std::vector<Finding> findings_;
  bool running_ = false;
  Verdict captured_ = Verdict::unknown;
  QString capture_detail_;
  QLabel* capture_;
  QLabel* counts_;
  QLabel* empty_;
  QToolButton* export_;
  QTableWidget* table_;
  std::optional<int> scrolled_;  // to be restored after filling
  QTimer fit_;                   // once the columns have their widths
};

}  // namespace netpocket
