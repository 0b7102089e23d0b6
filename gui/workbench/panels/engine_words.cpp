#include "gui/workbench/panels/engine_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <vector>

#include "gui/workbench/panels/engine_sentences.h"

namespace netpocket {
namespace {

QString in_language(const char* sentence) { return QCoreApplication::translate("engine", sentence); }

// A sentence of the engine with places for what it is about.
struct Sentence {
  const char* text;
  QRegularExpression shape;  // captures what stands in the places
};

std::vector<Sentence> read_sentences() {
  std::vector<Sentence> sentences;
  for (const char* text : kEngineSentences) {
    QString shape = QRegularExpression::escape(QString::fromUtf8(text));
    if (!shape.contains("\\%1")) continue;  // found as it stands
    shape.replace(QRegularExpression(R"(\\%\d)"), "(.+?)");
    sentences.push_back({text, QRegularExpression(QRegularExpression::anchoredPattern(shape),
                                                  QRegularExpression::DotMatchesEverythingOption)});
  }
  return sentences;
}

// Like QString::arg(), but a part may itself hold a "%1".
QString filled(const QString& sentence, const QStringList& parts) {
  QString result;
  for (qsizetype i = 0; i < sentence.size(); ++i) {
    const int digit = sentence[i] == '%' && i + 1 < sentence.size() ? sentence[i + 1].digitValue() : 0;
    if (digit < 1 || digit > parts.size()) {
      result += sentence[i];
      continue;
    }
    result += parts[digit - 1];
    ++i;
  }
  return result;
}

}  // namespace

QString engine_words(const QString& text) {
  static const std::vector<Sentence> sentences = read_sentences();
  const QByteArray utf8 = text.toUtf8();
  if (const QString exact = in_language(utf8.constData()); exact != text) return exact;
  const bool english = in_language(sentences.front().text) == QString::fromUtf8(sentences.front().text);
  if (english) return text;
  for (const Sentence& sentence : sentences) {
    const QRegularExpressionMatch match = sentence.shape.match(text);
    if (!match.hasMatch()) continue;
    QStringList parts;
    for (const QString& part : match.capturedTexts().mid(1)) parts << engine_words(part);
    return filled(in_language(sentence.text), parts);
  }
  return text;
}

QString engine_words(std::string_view utf8) {
  return engine_words(QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())));
}

QString diagnostic_words(const Diagnostic& problem) {
  Diagnostic place = problem;
  place.message.clear();
  const QString where = QString::fromStdString(place.text()), what = engine_words(problem.message);
  return where.isEmpty() || what.isEmpty() ? where + what : where + ": " + what;
}

QString diagnostics_words(const Diagnostics& problems) {
  QStringList lines;
  for (const Diagnostic& problem : problems.list()) lines << diagnostic_words(problem);
  return lines.join('\n');
}

}  // namespace netpocket
