#pragma once
// A text editor with line numbers, colours for TOML and marked lines.

#include <QPlainTextEdit>
#include <map>

namespace netpocket {

class LineNumbers;
class TomlHighlighter;

class TomlEditView : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit TomlEditView(QWidget* parent = nullptr);

  // Replaces the text but for what both have in common, so that cursor and scroll position stay. Without signals; what
  // was typed before cannot be undone here any more.
  void set_text(const QString& text);
  // What was typed is settled: undo is the document's again.
  void settle();

  // Marks lines (from 1) with what is wrong in them.
  void mark_lines(const std::map<int, QString>& problems);
  const std::map<int, QString>& marked_lines() const { return problems_; }

 signals:
  void undo_requested();
  void redo_requested();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  friend class LineNumbers;
  int number_width() const;
  void paint_numbers(QPaintEvent* event);
  void place_numbers();
  void show_marks();

  LineNumbers* numbers_;
  TomlHighlighter* highlighter_;
  std::map<int, QString> problems_;
};

}  // namespace netpocket
