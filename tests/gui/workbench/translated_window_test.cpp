// The window in another language: every text of it is translated, in Chinese and in a language made up for that.

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTranslator>
#include <QUndoView>

#include "engine/analysis/summary.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/systems/capture_system.h"
#include "gui/workbench/campaign/campaign_actions.h"
#include "gui/workbench/campaign/point_words.h"
#include "gui/workbench/control/control_panel.h"
#include "gui/workbench/dialogs/about_dialog.h"
#include "gui/workbench/dialogs/differences_dialog.h"
#include "gui/workbench/dialogs/part_dialog.h"
#include "gui/workbench/dialogs/preferences_dialog.h"
#include "gui/workbench/dialogs/shortcut_sheet.h"
#include "gui/workbench/editor/parameter_field.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/editor/presets.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/export/export_dialog.h"
#include "gui/workbench/language.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/figure_words.h"
#include "gui/workbench/presentation/headline.h"
#include "gui/workbench/presentation/presentation.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/start/first_capture.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/viewport/viewport.h"
#include "render/figures/study_figures.h"
#include "tests/gui/workbench/shown_texts.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

constexpr QChar kOpen(0x27E6), kClose(0x27E7);

// A made-up language: brackets round all that is translated, and none round what the program puts in.
class BracketTranslator : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int) const override {
    QString text = QString::fromUtf8(source);
    text.replace(QRegularExpression("(%[0-9n])"), kClose + QString("\\1") + kOpen);
    return kOpen + text + kClose;
  }
};

// What is left of a text without what is in brackets, HTML, and what is the same in all languages.
QString untranslated(QString text) {
  static const QRegularExpression kBracketed(QString("%1[^%1%2]*%2").arg(kOpen).arg(kClose));
  static const QRegularExpression kHtml("<code>[^<]*</code>|<[^>]*>|&nbsp;|&#\\d+;|&[a-z]+;");
  while (text.contains(kBracketed)) text.replace(kBracketed, " ");
  return text.replace(kHtml, " ");
}

// Keys, choices and names of files are the same in all languages; so are units, coordinates and names of programs.
bool is_the_same_everywhere(const QString& word) {
  static const QSet<QString> kWords = [] {
    QSet<QString> words = {"Netpocket", "quick", "true", "false",     "true",  "false",  "MiB",   "English", "PDF",
                           "SVG",       "PNG",   "Qt",   "offscreen", "xcb",   "OSMesa", "image", "toml",    "Ctrl",
                           "Shift",     "Alt",   "Esc",  "Del",       "Space", "Home",   "End",   "Return"};
    const auto add_parts = [&words](std::string_view text) {
      const QString whole = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
      for (const QString& part : whole.split(QRegularExpression("[^A-Za-z0-9]+"))) words << part;
    };
    const auto add = [&](std::span<const Parameter> parameters) {
      for (const Parameter& parameter : parameters) {
        add_parts(parameter.unit);
        for (const std::string_view choice : parameter.choices) add_parts(choice);
      }
    };
    for (const char* system : {"pocket", "thrown_net"}) {
      words << system << "target_inside";
      add(parameters(system));
      for (const ParameterList& list : parameter_lists(system)) add(list.rows);
    }
    for (const Preset& preset : presets()) words << preset.name;
    return words;
  }();
  if (word.size() < 2 || kWords.contains(word)) return true;
  static const QRegularExpression kKey("^[a-z_0-9]+([._][A-Za-z_0-9]+)+$");
  return kKey.match(word).hasMatch();
}

// The home folder, and the scenario's name where it does not fit.
bool is_of_the_user(const QString& text) {
  const bool shortened = text.endsWith(QChar(0x2026)) && QString("quick").startsWith(text.chopped(1));
  return shortened || text == QDir::toNativeSeparators(QDir::homePath());
}

bool is_key(const QString& text) {
  return find_parameter(text.toStdString()) != nullptr || find_parameter_list(text.toStdString()) != nullptr;
}

QStringList foreign_words(const QString& text) {
  static const QRegularExpression kWord("[A-Za-z_][A-Za-z_0-9.]*");
  QStringList words;
  for (auto found = kWord.globalMatch(untranslated(text)); found.hasNext();) {
    QString word = found.next().captured();
    while (word.endsWith('.')) word.chop(1);
    if (!is_the_same_everywhere(word)) words << word;
  }
  return words;
}

class TranslatedWindow : public WindowTest {
 protected:
  ~TranslatedWindow() override {
    window_.reset();
    QCoreApplication::removeTranslator(&brackets_);
    speak(kEnglish);
  }

  void speak_brackets() {
    QCoreApplication::installTranslator(&brackets_);
    reopen();
  }

  void speak_chinese() {
    speak("zh_CN");
    reopen();
  }

  static void expect_translated(const QWidget& part, const std::string& what) {
    const QList<ShownText> texts = shown_texts(part);
    EXPECT_FALSE(texts.isEmpty()) << what;
    for (const ShownText& shown : texts) {
      // Of a table of differences the last column has keys, and values may be what users wrote, in quotes.
      const bool written = shown.text.startsWith(QChar(0x201C)) && shown.text.endsWith(QChar(0x201D));
      if (written || is_of_the_user(shown.text) || (what.starts_with("differences") && is_key(shown.text))) continue;
      const QStringList words = foreign_words(shown.text);
      EXPECT_TRUE(words.isEmpty()) << what << ", " << shown.place.toStdString() << ": \"" << shown.text.toStdString()
                                   << "\" has " << words.join(", ").toStdString();
    }
  }

  BracketTranslator brackets_;
};

TEST_F(TranslatedWindow, EveryTextOfTheMainWindowIsTranslated) {
  speak_brackets();
  expect_translated(*window_, "the window");
  window_->begin_first_capture();
  for (int step = 0; step < 6; ++step) {
    expect_translated(window_->first_capture(), "the guide");
    window_->first_capture().skip_button()->click();
  }
  expect_translated(window_->first_capture(), "the guide's end");
}

TEST_F(TranslatedWindow, EveryTextOfARunIsTranslated) {
  speak_brackets();
  ASSERT_TRUE(run_to(1.2));
  expect_translated(*window_, "a run");
}

TEST_F(TranslatedWindow, EveryTextOfAThrownNetAndOfControlIsTranslated) {
  speak_brackets();
  for (const Preset& preset : presets()) {
    if (preset.name != "thrown_net" && preset.name != "noisy_sensors" && preset.name != "jammed_winch") continue;
    ASSERT_TRUE(window_->document().start_from(preset.text).ok());
    ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure != nullptr; }));
    QTest::qWait(300);
    expect_translated(*window_, preset.name.toStdString());
  }
}

TEST_F(TranslatedWindow, EveryTextOfTheDialogsIsTranslated) {
  speak_brackets();
  window_->show_start_page();
  expect_translated(window_->start_page(), "the start page");
  expect_translated(PreferencesDialog({}, 3 << 20, window_.get()), "the preferences");
  expect_translated(AboutDialog({}, window_->viewport().presenter_description(), window_.get()), "about");
  expect_translated(ShortcutSheet(*window_->menuBar(), window_.get()), "the keys");
  ExportDialog exports("/tmp", "quick", {}, window_.get());
  expect_translated(exports, "the export");
  DifferencesDialog differences(window_->document(), window_.get());
  differences.compare_with("thrown_net");
  expect_translated(differences, "differences to another system");
  differences.compare_with("noisy_sensors");
  expect_translated(differences, "differences");
  PartDialog parts(window_->document(), window_.get());
  for (const ScenarioPart part : {ScenarioPart::pocket, ScenarioPart::target, ScenarioPart::strategy}) {
    parts.show_part(part);
    expect_translated(parts, "parts");
  }
}

TEST_F(TranslatedWindow, EveryTextOfThePresenterModeIsTranslated) {
  speak_brackets();
  ASSERT_TRUE(run_to(1.2));
  window_->presentation().set_on(true);
  expect_translated(*window_, "presenter mode");
  const QString headline = window_->findChild<Headline*>()->text();
  EXPECT_GT(headline.count(kOpen), 5) << headline.toStdString();
  EXPECT_TRUE(foreign_words(headline).isEmpty()) << headline.toStdString();
  window_->presentation().set_on(false);
}

TEST_F(TranslatedWindow, EveryTextOfACampaignIsTranslated) {
  speak_brackets();
  ASSERT_FALSE(window_->document().save_as(file("quick.toml")));
  StudyForm* form = window_->campaign().form();
  StudyDraft draft = usual_draft(window_->document().scenario());
  draft.inputs.push_back({"target.spin", Scatter::direction, 0.1});
  draft.samples = 4;
  form->set_draft(draft);
  expect_translated(*form, "the form of a campaign");
  CampaignActions& actions = window_->campaign_actions();
  ASSERT_TRUE(actions.save_study(file("study.toml"))) << window_->campaign().problem().toStdString();
  actions.run_study(file("study.toml"), file("study"));
  const CampaignView& view = *window_->campaign().view();
  QSet<QString> said;
  const auto note = [&] { said << view.state_text() << view.estimate_text() << view.stop_button()->text(); };
  ASSERT_TRUE(wait_until(
      [&] {
        note();
        return actions.campaign()->is_complete() && view.state_text().contains("4");
      },
      120));
  note();
  const StudyResults& results = actions.campaign()->results()->results();
  ASSERT_GT(results.size(), 0U);
  said << point_words(results, 0) << time_words(1) << time_words(1000) << time_words(10000);
  EXPECT_GT(said.size(), 6);
  for (const QString& text : said) {
    EXPECT_TRUE(foreign_words(text).isEmpty()) << text.toStdString();
  }
}

TEST_F(TranslatedWindow, SpeaksChineseInMenusAndForm) {
  speak_chinese();
  EXPECT_EQ(window_->menuBar()->actions().front()->text(), QString::fromUtf8("文件(&F)"));
  EXPECT_EQ(window_->findChild<QDockWidget*>("plots")->windowTitle(), QString::fromUtf8("曲线"));
  const ParameterRow* row = window_->editor().form()->row("contact.restitution");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->findChild<QLabel*>()->text(), QString::fromUtf8("恢复系数"));
  EXPECT_TRUE(row->field()->toolTip().contains(QString::fromUtf8("允许范围：&gt;= 0 且 &lt;= 1")))
      << row->field()->toolTip().toStdString();
  // What a name means may depend on its table.
  EXPECT_EQ(label(*find_parameter("target.size")), QString::fromUtf8("尺寸"));
  EXPECT_EQ(label(*find_parameter("towing.size")), QString::fromUtf8("大小"));
  // One finds a parameter in the language of the window and by its key.
  EXPECT_EQ(window_->editor().form()->filter(QString::fromUtf8("恢复系数"), false), 1);
  EXPECT_GE(window_->editor().form()->filter("restitution", false), 1);
}

TEST_F(TranslatedWindow, ChineseWordsDoNotReachFilesOrSettings) {
  speak_chinese();
  ASSERT_FALSE(window_->document().set_value(*find_parameter("contact.restitution"), 0.25));
  ASSERT_FALSE(window_->document().save_as(file("one.toml")));
  QFile saved(file("one.toml"));
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  const QByteArray text = saved.readAll();
  EXPECT_TRUE(text.contains("restitution = 0.25"));
  window_->settings().sync();
  for (const QString& key : window_->settings().allKeys()) {
    for (const QChar letter : key) EXPECT_LT(letter.unicode(), 128) << key.toStdString();
  }
}

TEST_F(TranslatedWindow, ProblemsOfAScenarioAreChineseInForm) {
  speak_chinese();
  ASSERT_FALSE(window_->document().set_value(*find_parameter("rods.wall_lower"), 0.06));
  EXPECT_EQ(window_->editor().form()->row("rods.wall_lower")->problem(),
            QString::fromUtf8("0.06 m 的壁厚超出外半径 0.05 m。"));
}

// In a menu and in a dialog each letter leads to one thing.
TEST_F(TranslatedWindow, MnemonicsAreUnique) {
  static const QRegularExpression kMnemonic("&([A-Za-z])");
  const auto letters_of = [](const QStringList& texts, const std::string& what) {
    QHash<QString, QString> owners;
    for (const QString& text : texts) {
      const QString letter = kMnemonic.match(text).captured(1).toLower();
      if (letter.isEmpty()) continue;
      EXPECT_FALSE(owners.contains(letter))
          << what << ": " << text.toStdString() << " and " << owners[letter].toStdString();
      owners[letter] = text;
    }
  };
  for (const QString& code : {QString(kEnglish), QString("zh_CN")}) {
    speak(code);
    reopen();
    const auto texts_of = [](const QList<QAction*>& actions) {
      QStringList texts;
      for (const QAction* action : actions) texts << action->text();
      return texts;
    };
    letters_of(texts_of(window_->menuBar()->actions()), "menu bar");
    for (const auto* menu : window_->menuBar()->findChildren<QMenu*>()) {
      letters_of(texts_of(menu->actions()), menu->title().toStdString());
    }
    const PreferencesDialog preferences({}, 0, window_.get());
    const ExportDialog exports("/tmp", "quick", {}, window_.get());
    for (const QWidget* dialog : {static_cast<const QWidget*>(&preferences), static_cast<const QWidget*>(&exports)}) {
      QStringList texts;
      for (const auto* label : dialog->findChildren<QLabel*>()) texts << label->text();
      for (const auto* button : dialog->findChildren<QPushButton*>()) texts << button->text();
      letters_of(texts, dialog->windowTitle().toStdString());
    }
  }
}

// Names of parts, loops and phases of every scenario, and what findings say, have Chinese words.
TEST(ChineseWords, CoverWhatTheEngineNames) {
  speak("zh_CN");
  const auto expect_words = [](const std::string& text) {
    EXPECT_NE(engine_words(text).toStdString(), text);
    EXPECT_FALSE(engine_words(text).contains(QRegularExpression("[a-z]{4,}"))) << engine_words(text).toStdString();
  };
  for (const Preset& preset : presets()) {
    const Scenario scenario = read_scenario_text(preset.text.toStdString(), {}).scenario;
    if (!check_scenario(scenario).ok()) continue;
    const CaptureSystem system = build_capture_system(scenario);
    for (const std::string& thread : system.structure.threads) expect_words(thread);
    for (const auto& body : system.structure.bodies) {
      if (!body.name.empty()) expect_words(body.name);
    }
    for (const auto& group : system.structure.element_groups) {
      expect_words(group.name);
      expect_words(group.member);
    }
    for (const ControlLoopInfo& loop : system.structure.loops) {
      expect_words(loop.acts_on);
      expect_words(loop.quantity);
      EXPECT_NE(engine_words(loop.name).toStdString(), loop.name);
    }
    for (const Phase& phase : capture_phases(scenario)) expect_words(phase.name);
  }
  for (const Finding& finding : evaluate_findings({}))
    EXPECT_NE(engine_words(finding.text).toStdString(), finding.text);
  speak(kEnglish);
}

// But for the names of columns.
TEST(ChineseWords, CoverFiguresOfCampaigns) {
  speak("zh_CN");
  StudyResults results;
  results.inputs = {{"in_a", "m", {}}, {"in_b", "", {}}};
  results.measures = {{"smallest_gap", "m", {}}};
  for (int i = 0; i < 120; ++i) {
    results.points.push_back(i + 1);
    results.captured.push_back(i % 3 == 0);
    results.inputs[0].values.push_back(i % 11);
    results.inputs[1].values.push_back(i % 7);
    results.measures[0].values.push_back(i % 5);
  }
  const auto expect_words = [](const std::string& text, const std::string& figure) {
    QString rest = QString::fromStdString(text).remove('\\');  // of plain text among styled one
    for (const char* name : {"in_a", "in_b", "smallest_gap", "Wilson"}) rest.remove(name);
    EXPECT_FALSE(rest.contains(QRegularExpression("[A-Za-z]{2,}"))) << figure << ": " << text;
  };
  for (const char* name : {"capture_map", "convergence", "influence", "distributions", "parallel_coordinates"}) {
    const Figure figure = in_window_language(make_study_figure(name, results));
    ASSERT_FALSE(figure.panels.empty()) << name;
    for (const Panel& panel : figure.panels) {
      for (const std::string& text : {panel.title, panel.x.title, panel.y.title}) expect_words(text, name);
      for (const Curve& curve : panel.curves) expect_words(curve.label, name);
    }
  }
  speak(kEnglish);
}

TEST(ChineseWords, FillThePlacesOfSentences) {
  speak("zh_CN");
  EXPECT_EQ(engine_words(std::string_view("axial waves in panel 3 upper row 2, and bends of cords")),
            QString::fromUtf8("网面 3 上部第 2 行的轴向波，以及绳的弯折"));
  EXPECT_EQ(engine_words(std::string_view("cannot write \"/a/%2 b.toml\": No space left on device")),
            QString::fromUtf8("无法写入“/a/%2 b.toml”：磁盘空间不足"));
  EXPECT_EQ(engine_words(std::string_view("target.mass needs a spread above 0.")),
            QString::fromUtf8("target.mass 需要大于 0 的分散程度。"));
  EXPECT_EQ(engine_words(std::string_view("row 1 names rod 9; the rods are 1 to 8")),
            QString::fromUtf8("第 1 行指定杆 9；充气杆为 1 至 8"));
  EXPECT_EQ(engine_words(std::string_view("something new")), "something new");
  speak(kEnglish);
  EXPECT_EQ(engine_words(std::string_view("axial waves in panel 3 upper row 2")), "axial waves in panel 3 upper row 2");
}

TEST(Languages, AreEnglishAndTheTranslations) {
  ASSERT_GE(languages().size(), 2U);
  EXPECT_EQ(languages().front().code, kEnglish);
  EXPECT_EQ(languages()[1].code, "zh_CN");
  EXPECT_EQ(languages()[1].name, QString::fromUtf8("简体中文"));
}

TEST(Languages, AreChosenByWhatTheSystemWants) {
  EXPECT_EQ(language_for({"zh-Hans-CN", "zh-CN", "zh"}), "zh_CN");
  EXPECT_EQ(language_for({"zh-SG"}), "zh_CN");
  EXPECT_EQ(language_for({"zh-Hant-TW"}), kEnglish) << "traditional letters";
  EXPECT_EQ(language_for({"en-GB", "zh-CN"}), kEnglish) << "the first that is there";
  EXPECT_EQ(language_for({"de-DE", "zh-CN"}), "zh_CN");
  EXPECT_EQ(language_for({"de-DE"}), kEnglish);
  EXPECT_EQ(language_for({}), kEnglish);
}

class PreferredLanguage : public testing::Test {
 protected:
  ~PreferredLanguage() override { speak(kEnglish); }

  void prefer(const QString& code) { write_preferences({.language = code}, settings_); }

  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("s.ini"), QSettings::IniFormat};
};

TEST_F(PreferredLanguage, EnglishNeedsNoWord) {
  prefer(kEnglish);
  EXPECT_EQ(speak_as_preferred(settings_), QString());
  prefer(kSystemLanguage);
  EXPECT_EQ(speak_as_preferred(settings_), QString());
}

TEST_F(PreferredLanguage, AnUnknownOneIsToldEachTime) {
  prefer("tlh");
  for (int i = 0; i < 2; ++i) {
    const QString told = speak_as_preferred(settings_);
    EXPECT_TRUE(told.contains("tlh") && told.contains("zh_CN")) << told.toStdString();
  }
}

// These tests have DejaVu fonts only.
TEST_F(PreferredLanguage, WithoutAFontTheWindowSpeaksEnglishAndSaysSoOnce) {
  prefer("zh_CN");
  const QString told = speak_as_preferred(settings_);
  EXPECT_TRUE(told.contains("zh_CN") && told.contains("fonts-noto-cjk")) << told.toStdString();
  EXPECT_EQ(QCoreApplication::translate("netpocket::MainWindow", "&File"), "&File");
  EXPECT_EQ(speak_as_preferred(settings_), QString()) << "told already";
}

}  // namespace
}  // namespace netpocket
