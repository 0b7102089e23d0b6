#pragma once

#include <QPalette>
#include <QSyntaxHighlighter>

namespace netpocket {

// Colours for TOML: tables, keys, numbers, texts, comments.
class TomlHighlighter : public QSyntaxHighlighter {
  Q_OBJECT
 public:
  explicit TomlHighlighter(QTextDocument* document);

  void set_palette(const QPalette& palette);

 protected:
  void highlightBlock(const QString& line) override;

 private:
  void highlight_value(const QString& line, int from);

  QTextCharFormat table_;
  QTextCharFormat key_;
  QTextCharFormat number_;
  QTextCharFormat text_;
  QTextCharFormat comment_;
};

}  // namespace netpocket
