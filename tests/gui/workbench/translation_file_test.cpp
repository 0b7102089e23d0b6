// The translations: files that are complete, keep what the program puts into the texts, and follow the sources.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/gui/workbench/generated_texts.h"

namespace netpocket {
namespace {

const QString kFolder = QStringLiteral(NETPOCKET_SOURCE_DIR "/gui/workbench/translations");

struct Message {
  QString context;
  QString source;
  QString comment;           // tells equal sources apart
  QStringList translations;  // several where they depend on a number
  QString kind;              // "unfinished", "vanished" or "obsolete"; empty: good

  QString key() const { return context + " | " + source + " | " + comment; }
};

std::vector<Message> read_messages(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  std::vector<Message> messages;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = xml.name();
    if (name == u"name") context = xml.readElementText();
    if (name == u"message") messages.push_back({context, {}, {}, {}, {}});
    if (name == u"source") messages.back().source = xml.readElementText();
    if (name == u"comment") messages.back().comment = xml.readElementText();
    if (name == u"translation") {
      messages.back().kind = xml.attributes().value("type").toString();
      const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
      messages.back().translations << text;
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

QStringList files() { return QDir(kFolder).entryList({"*.ts"}, QDir::Files); }

QStringList all_of(const char* pattern, const QString& text) {
  QStringList found;
  for (auto matches = QRegularExpression(pattern).globalMatch(text); matches.hasNext();) {
    found << matches.next().captured();
  }
  found.sort();
  return found;
}

// "&x", not "&&" or "& ".
QStringList mnemonics(const QString& text) { return all_of("&[A-Za-z]", text); }

QString ending(QString text) {
  text.replace(QChar(0xFF1A), ':').replace(QChar(0x3002), '.');  // as wide as a Chinese letter
  for (const char* end : {":", "…"}) {
    if (text.endsWith(QString::fromUtf8(end))) return QString::fromUtf8(end);
  }
  return {};
}

TEST(Translations, ThereIsOneOfChinese) { EXPECT_TRUE(files().contains("netpocket_zh_CN.ts")); }

TEST(Translations, EveryTextIsTranslated) {
  for (const QString& file : files()) {
    const auto messages = read_messages(kFolder + "/" + file);
    EXPECT_GT(messages.size(), 1000U);
    for (const Message& message : messages) {
      EXPECT_TRUE(message.kind.isEmpty()) << message.key().toStdString() << " is " << message.kind.toStdString();
      for (const QString& text : message.translations) EXPECT_FALSE(text.isEmpty()) << message.key().toStdString();
    }
  }
}

// What the program puts in, what one presses, and how it ends.
TEST(Translations, TextsKeepPlacesMnemonicsAndEndings) {
  for (const QString& file : files()) {
    for (const Message& message : read_messages(kFolder + "/" + file)) {
      const std::string key = message.key().toStdString();
      for (const QString& text : message.translations) {
        EXPECT_EQ(all_of("%[0-9n]", message.source), all_of("%[0-9n]", text)) << key;
        EXPECT_EQ(mnemonics(message.source).size(), mnemonics(text).size()) << key;
        // Signs that mean something: HTML, a changed window, filters of files.
        EXPECT_EQ(all_of("</?[a-z]+>|\\[\\*\\]|;;|\\*\\.[a-z0-9]+", message.source),
                  all_of("</?[a-z]+>|\\[\\*\\]|;;|\\*\\.[a-z0-9]+", text))
            << key;
        // Parts of sentences end as their language wants.
        if (message.context == "engine") continue;
        EXPECT_EQ(ending(message.source), ending(text)) << key;
      }
    }
  }
}

TEST(Translations, TextsOfTablesAreCurrent) {
  for (const auto& [name, text] : generated_texts()) {
    const std::string path = kFolder.toStdString() + "/" + name;
    if (std::getenv("NETPOCKET_RENEW")) std::ofstream(path) << text;
    std::ifstream file(path);
    const std::string committed(std::istreambuf_iterator<char>(file), {});
    EXPECT_TRUE(committed == text)
        << path
        << " is not what the tables say; renew it with NETPOCKET_RENEW=1 and this test, then ./dev translations";
  }
}

// lupdate finds in the sources what the files hold, no more and no less.
TEST(Translations, FilesAreUpToDateWithTheSources) {
  for (const QString& file : files()) {
    QTemporaryDir folder;
    const QString copy = folder.filePath(file);
    ASSERT_TRUE(QFile::copy(kFolder + "/" + file, copy));
    QProcess lupdate;
    lupdate.setWorkingDirectory(NETPOCKET_SOURCE_DIR);
    lupdate.start(NETPOCKET_LUPDATE,
                  {"-silent", "-I", ".", "-locations", "none", "-recursive", "gui/workbench", "-ts", copy});
    ASSERT_TRUE(lupdate.waitForFinished(120000)) << lupdate.errorString().toStdString();
    ASSERT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
    QSet<QString> before;
    for (const Message& message : read_messages(kFolder + "/" + file)) before << message.key();
    for (const Message& message : read_messages(copy)) {
      EXPECT_TRUE(before.contains(message.key())) << "./dev translations adds: " << message.key().toStdString();
      EXPECT_NE(message.kind, "vanished") << "./dev translations drops: " << message.key().toStdString();
    }
  }
}

// The first table of the glossary: English and Chinese terms.
std::vector<std::pair<QString, QString>> glossary() {
  QFile file(kFolder + "/GLOSSARY_zh_CN.md");
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  static const QRegularExpression kRow("^\\| ([A-Za-z' ]+) \\| ([^A-Za-z|]+) \\|$",
                                       QRegularExpression::MultilineOption);
  std::vector<std::pair<QString, QString>> terms;
  const QString first_table = QString::fromUtf8(file.readAll()).section("Further terms", 0, 0);
  for (auto rows = kRow.globalMatch(first_table); rows.hasNext();) {
    const auto row = rows.next();
    terms.emplace_back(row.captured(1), row.captured(2));
  }
  return terms;
}

// A choice of a parameter, such as "thrusters", stays as it is in files.
TEST(Translations, ChineseKeepsToItsGlossary) {
  const auto terms = glossary();
  ASSERT_GE(terms.size(), 15U);
  const auto messages = read_messages(kFolder + "/netpocket_zh_CN.ts");
  for (const auto& [english, chinese] : terms) {
    const QRegularExpression term("(?<![\\w\"\\[._-])" + QRegularExpression::escape(english) + "s?(?![\\w\"=/]|\\.\\w)",
                                  QRegularExpression::CaseInsensitiveOption);
    int found = 0;
    for (const Message& message : messages) {
      const auto match = term.match(message.source);
      if (!match.hasMatch()) continue;
      ++found;
      const QString& text = message.translations.front();
      EXPECT_TRUE(text.contains(chinese) || text.contains(match.captured()))
          << chinese.toStdString() << " is not in \"" << text.toStdString() << "\", for \""
          << message.source.toStdString() << "\"";
    }
    EXPECT_GT(found, 0) << english.toStdString();
  }
}

}  // namespace
}  // namespace netpocket
