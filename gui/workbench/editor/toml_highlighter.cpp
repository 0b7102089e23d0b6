#include "gui/workbench/editor/toml_highlighter.h"

#include <QRegularExpression>

#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

const QRegularExpression& value_pattern() {
  static const QRegularExpression pattern(
      R"((?<comment>#.*$)|(?<text>"(?:[^"\\]|\\.)*"?|'[^']*'?)|(?<number>\b(?:true|false|inf|nan)\b|[+-]?\d[\d_]*(?:\.\d+)?(?:[eE][+-]?\d+)?))");
  return pattern;
}

}  // namespace

TomlHighlighter::TomlHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {
  table_.setFontWeight(QFont::Bold);
  comment_.setFontItalic(true);
}

void TomlHighlighter::set_palette(const QPalette& palette) {
  table_.setForeground(tone_colour(Tone::accent, palette));
  key_.setForeground(palette.color(QPalette::Text));
  number_.setForeground(tone_colour(Tone::warning, palette));
  text_.setForeground(tone_colour(Tone::good, palette));
  comment_.setForeground(tone_colour(Tone::muted, palette));
  rehighlight();
}

void TomlHighlighter::highlightBlock(const QString& line) {
  static const QRegularExpression table_pattern(R"(^\s*\[[^\]=]*\])");
  static const QRegularExpression key_pattern(R"(^\s*[\w."'-]+\s*(?==))");
  int from = 0;
  if (const auto table = table_pattern.match(line); table.hasMatch()) {
    setFormat(0, table.capturedLength(), table_);
    from = table.capturedEnd();
  } else if (const auto key = key_pattern.match(line); key.hasMatch()) {
    setFormat(0, key.capturedLength(), key_);
    from = key.capturedEnd();
  }
  highlight_value(line, from);
}

void TomlHighlighter::highlight_value(const QString& line, int from) {
  for (auto match = value_pattern().globalMatch(line, from); match.hasNext();) {
    const auto found = match.next();
    const QTextCharFormat& format = found.hasCaptured("comment") ? comment_
                                    : found.hasCaptured("text")  ? text_
                                                                 : number_;
    setFormat(found.capturedStart(), found.capturedLength(), format);
  }
}

}  // namespace netpocket
