// info, findings, export, plot and render on a short recording of case 1.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

using nlohmann::json;

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void expect_ok(const std::vector<std::string>& arguments) {
  const auto result = run_program(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.error;
}

// Width and height as a PNG's header states them; 0 when it is no PNG.
std::pair<int, int> png_size(const std::string& path) {
  const std::string bytes = content(path);
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST(Info, JsonHasThePromisedKeys) {
  const TestFolder folder;
  // Bowed cords straighten at first: what that sets free is not put in, and a tenth of a second puts in next to
  // nothing.
  const auto result = run_program({"info", short_recording(folder, {"--set", "pocket.bow=0"}), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const json info = json::parse(result.out);
  EXPECT_EQ(info.at("scenario"), "case1");
  EXPECT_EQ(info.at("reason"), "finished");
  // To a step, about 1e-4 s.
  EXPECT_NEAR(info.at("simulated_seconds").get<double>(), 0.1, 1e-4);
  for (const char* key : {"wall_seconds", "cpu_seconds", "elements", "steps"}) EXPECT_GT(info.at(key), 0) << key;
  EXPECT_TRUE(info.at("captured").is_null()) << "a tenth of a second does not tell";
  EXPECT_EQ(info.at("capture"), "not known");
  EXPECT_TRUE(info.at("first_contact_time").is_null());
  for (const char* key : {"x", "y", "z"}) {
    EXPECT_EQ(info.at("peak_force").at(key), 0) << key;
    EXPECT_EQ(info.at("impulse").at(key), 0) << key;
  }
  EXPECT_TRUE(info.at("peak_force").contains("time_y"));
  // The audit's bound of a whole run.
  EXPECT_LT(info.at("energy_error"), 0.01);
}

TEST(Info, TextNamesTheScenario) {
  const TestFolder folder;
  const auto result = run_program({"info", short_recording(folder)});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("scenario       case1\n")) << result.out;
}

// The same metrics in all three forms.
TEST(Metrics, AreTextOrCsvOrJson) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  const auto text = run_program({"metrics", recording});
  ASSERT_EQ(text.exit_code, 0) << text.error;
  const auto csv = run_program({"metrics", recording, "--csv"}),
             written = run_program({"metrics", recording, "--json"});
  const json metrics = json::parse(written.out).at("metrics");
  EXPECT_TRUE(csv.out.starts_with("name,value,unit,meaning\n")) << csv.out;
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.out.begin(), csv.out.end(), '\n')), metrics.size() + 1);
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.out.begin(), text.out.end(), '\n')), metrics.size());
  for (const auto& [name, metric] : metrics.items()) {
    EXPECT_NE(csv.out.find("\n" + name + ","), csv.out.npos) << name;
    EXPECT_NE(text.out.find(name + " "), text.out.npos) << name;
  }
  // Eight tips on a circle of 7.56 m (scenario.h): 1/2 n r^2 sin(2 pi/n).
  EXPECT_NEAR(metrics.at("mouth_area_start").at("value").get<double>(), 4 * 7.56 * 7.56 * std::sqrt(0.5), 1e-3);
  EXPECT_TRUE(metrics.at("first_contact_time").at("value").is_null());
  EXPECT_GT(metrics.at("utilisation_peak").at("value"), 0) << "strengths come from the scenario";
}

TEST(Metrics, TakeOneFormAtATime) {
  const auto result = run_program({"metrics", "a.h5", "--csv", "--json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.error.find("--csv"), result.error.npos) << result.error;
}

TEST(Findings, JsonHasElevenForEachRun) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  const auto result = run_program({"findings", recording, recording, "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const json findings = json::parse(result.out).at("findings");
  ASSERT_EQ(findings.size(), 11u);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(findings[i].at("id"), fmt::format("F{}", i + 1));
    EXPECT_FALSE(findings[i].at("text").get<std::string>().empty());
    ASSERT_EQ(findings[i].at("cases").size(), 2u);
    EXPECT_EQ(findings[i].at("cases")[0].at("name"), "case1");
    // A tenth of a second tells that F1 does not hold, and nothing of the others.
    EXPECT_EQ(findings[i].at("cases")[0].at("verdict"), i == 0 ? "no" : "not known");
    EXPECT_EQ(findings[i].at("cases")[0].at("holds"), i == 0 ? json(false) : json());
  }
}

TEST(Findings, RunsOfOneNameSayWhatDiffers) {
  const TestFolder folder;
  std::vector<std::string> arguments = {"findings"};
  for (const std::string radius : {"4.1", "4.2"}) {
    arguments.push_back(folder.file(radius + ".h5"));
    expect_ok({"run", scenario_file("case1.toml"), "-o", arguments.back(), "--until", "0.02", "--quiet", "--set",
               "target.radius=" + radius});
  }
  const auto result = run_program(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("case1, target.radius = 4.1"), result.out.npos) << result.out;
  EXPECT_NE(result.out.find("case1, target.radius = 4.2"), result.out.npos) << result.out;
}

// Whatever is told of a draft says that it is one, and its bias.
TEST(Drafts, AreNamedInAllThatIsToldOfThem) {
  const TestFolder folder;
  const std::string run = short_recording(folder, {"--set", "solver.fidelity=draft"});
  const std::string notice = "bias over 512 scattered captures, 95 %: probability of capture";
  for (const auto& command : {std::vector<std::string>{"info", run},
                              {"metrics", run},
                              {"metrics", run, "--json"},
                              {"findings", run},
                              {"findings", run, "--json"}}) {
    const auto result = run_program(command);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    EXPECT_NE(result.out.find("draft"), std::string::npos) << command[0] << result.out;
    EXPECT_NE(result.out.find(notice), std::string::npos) << command[0] << result.out;
  }
  const auto table = run_program({"metrics", run, "--csv"});
  EXPECT_EQ(table.out.find("draft"), std::string::npos) << "a table has rows only";
  EXPECT_NE(table.error.find("is a draft: coarse mesh"), std::string::npos) << table.error;
  expect_ok({"plot", run, "-o", folder.file("figures"), "--figure", "energy", "--format", "svg"});
  EXPECT_NE(content(folder.file("figures") + "/energy.svg").find("Draft: coarse mesh"), std::string::npos);
}

TEST(Export, OlderFilesAreMentioned) {
  const TestFolder folder;
  const std::string longer = short_recording(folder), shorter = folder.file("shorter.h5");
  expect_ok({"run", scenario_file("case1.toml"), "-o", shorter, "--until", "0.06", "--quiet"});
  expect_ok({"export", longer, "--vtp", folder.file("vtp"), "--quiet"});
  const auto again = run_program({"export", shorter, "--vtp", folder.file("vtp"), "--quiet"});
  EXPECT_EQ(again.exit_code, 0);
  for (const char* part : {"lines", "bodies"}) {
    EXPECT_NE(again.error.find(fmt::format("also holds 2 older files, {0}_0004.vtp to {0}_0005.vtp", part)),
              std::string::npos)
        << again.error;
  }
}

TEST(Export, CsvHasARowForEachFrame) {
  const TestFolder folder;
  expect_ok({"export", short_recording(folder), "--csv", folder.file("new/folder")});
  const std::string csv = content(folder.file("new/folder/channels.csv"));
  EXPECT_TRUE(csv.starts_with("time,closing_length,closing_speed,")) << csv.substr(0, 100);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);  // names, and frames at 0, 0.02, ... 0.1 s
}

// The files hold what the commands print.
TEST(Export, JsonHoldsSummaryMetricsAndScenario) {
  const TestFolder folder;
  const std::string recording = short_recording(folder), place = folder.file("json");
  expect_ok({"export", recording, "--json", place});
  for (const std::string command : {"info", "metrics"}) {
    const auto printed = run_program({command, recording, "--json"});
    const std::string name = command == "info" ? "summary" : command;
    EXPECT_EQ(json::parse(content(place + "/" + name + ".json")), json::parse(printed.out)) << command;
  }
  const json scenario = json::parse(content(place + "/scenario.json"));
  json checked = json::parse(run_program({"check", scenario_file("case1.toml"), "--json"}).out);
  EXPECT_EQ(scenario.at("name"), "case1");
  EXPECT_EQ(scenario.at("net"), checked.at("net"));
  EXPECT_EQ(scenario.at("target"), checked.at("target"));
  EXPECT_EQ(scenario.size(), checked.size());
}

TEST(Export, VtpSeriesHasATimeForEachFrame) {
  const TestFolder folder;
  expect_ok({"export", short_recording(folder), "--vtp", folder.file("vtp"), "--quiet"});
  const std::string series = content(folder.file("vtp/netpocket.pvd"));
  EXPECT_NE(series.find("lines_0005.vtp"), series.npos) << series;
  EXPECT_EQ(series.find("lines_0006.vtp"), series.npos) << series;
  EXPECT_TRUE(std::filesystem::exists(folder.file("vtp/lines_0005.vtp")));
}

TEST(Plot, WritesTheFigureAskedFor) {
  const TestFolder folder;
  expect_ok({"plot", short_recording(folder), "-o", folder.file("figures"), "--figure", "figure03_closing", "--format",
             "svg"});
  EXPECT_NE(content(folder.file("figures/figure03_closing.svg")).find("<svg"), std::string::npos);
}

TEST(Plot, WritesTheNumbersBesideTheFigure) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  expect_ok({"plot", recording, "-o", folder.file("figures"), "--figure", "tension", "--csv", "--dpi", "40"});
  expect_ok({"export", recording, "--csv", folder.file("channels")});
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const std::string table = content(folder.file("figures/tension.csv"));
  EXPECT_TRUE(
      table.starts_with("panel,title,curve,x_axis,x,y_axis,y\n1,Largest tension in a net cord,"
                        "case1: rope_tension_max,Time t (s),0,Tension (N),"))
      << table.substr(0, 200);
  // Two curves and their peaks; a header line each.
  EXPECT_EQ(lines(table) - 1, 2 * (lines(content(folder.file("channels/channels.csv"))) - 1) + 2);
  EXPECT_NE(table.find("case1: largest closing_tension"), table.npos);
  // A table of the user's is not overwritten by something else.
  std::ofstream(folder.file("figures/tension.csv")) << "%PDF-1.5";
  const auto refused =
      run_program({"plot", recording, "-o", folder.file("figures"), "--figure", "tension", "--csv", "--dpi", "40"});
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.error.find("--csv"), refused.error.npos) << refused.error;
}

TEST(Render, PicturesSheetAndVideoWithoutADisplay) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  expect_ok({"render", recording, "-o", folder.file("frames"), "--times", "0,0.04,0.1", "--size", "320x180", "--sheet",
             folder.file("sheet.png"), "--panel-size", "160x120", "--video", folder.file("video.mp4"), "--quiet"});
  for (const char* name : {"frames/0000.png", "frames/0001.png", "frames/0002.png"}) {
    EXPECT_EQ(png_size(folder.file(name)), std::pair(320, 180)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("frames/0003.png")));
  EXPECT_GT(png_size(folder.file("sheet.png")).first, 3 * 160);
  EXPECT_EQ(content(folder.file("video.mp4")).substr(4, 4), "ftyp");
}

TEST(Render, EveryNthFrameFromEveryCamera) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  for (const std::string camera : {"iso", "side", "front", "mouth", "follow"}) {
    expect_ok({"render", recording, "-o", folder.file(camera), "--every", "5", "--size", "160x90", "--camera", camera,
               "--color-by", "speed", "--background", "space", "--backend", "osmesa", "--quiet"});
    EXPECT_EQ(png_size(folder.file(camera + "/0001.png")), std::pair(160, 90));
    EXPECT_FALSE(std::filesystem::exists(folder.file(camera + "/0002.png")));
  }
}

}  // namespace
}  // namespace netpocket
