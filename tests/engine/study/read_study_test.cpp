#include "engine/study/read_study.h"

#include <gtest/gtest.h>

#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

TEST(ReadStudy, ReadsEverything) {
  const StudyFolder folder;
  const StudyResult result = folder.read(R"(
description = "what for"
sampling = "halton"
samples = 5
seed = 7
keep_recordings = true
[set]
pocket.elements_per_side = 1
"solver.safety" = 0.4
[vary]
target.radius = { from = 4.0, to = 4.5 }
"rods.profile[1][0]" = [5.0, 5.3]
contact.friction = { from = 0.1, to = 0.8, scale = "log" }
pocket.mesh_rows = { from = 3, to = 6 }
[[point]]
name = "box"
target.shape = "box"
target.size = [5, 5, 5]
[[point]]
name = "sphere"
[[variant]]
name = "slow"
closing.duration = 10
[ensemble]
runs = 16
perturbation = 1e-7
[remarks]
F5 = "why"
[report]
of = "search"
best = 3
show = ["F5", "F10"]
)");
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  const Study& study = result.study;
  EXPECT_EQ(study.name, "study");
  EXPECT_EQ(study.description, "what for");
  EXPECT_EQ(study.sampling, Sampling::halton);
  EXPECT_EQ(study.samples, 5);
  EXPECT_EQ(study.seed, 7);
  EXPECT_TRUE(study.keep_recordings);
  EXPECT_EQ(study.settings, (std::vector<Setting>{{"pocket.elements_per_side", "1"}, {"solver.safety", "0.4"}}));
  ASSERT_EQ(study.axes.size(), 4u);  // in the order of the file
  EXPECT_EQ(study.axes[0].key, "target.radius");
  EXPECT_EQ(study.axes[0].to, 4.5);
  EXPECT_EQ(study.axes[1].values, (std::vector<std::string>{"5", "5.3"}));
  EXPECT_TRUE(study.axes[2].logarithmic);
  EXPECT_TRUE(study.axes[3].whole);
  ASSERT_EQ(study.places.size(), 2u);
  EXPECT_EQ(study.places[0].settings[1], (Setting{"target.size", "[5, 5, 5]"}));
  EXPECT_EQ(study.places[1].name, "sphere");
  ASSERT_EQ(study.variants.size(), 1u);
  EXPECT_EQ(study.variants[0].settings[0], (Setting{"closing.duration", "10"}));
  EXPECT_EQ(study.ensemble.runs, 16);
  EXPECT_EQ(study.ensemble.perturbation, 1e-7);
  EXPECT_EQ(study.remarks.at("F5"), "why");
  EXPECT_EQ(study.report.of, ReportOf::search);
  EXPECT_EQ(study.report.best, 3);
  EXPECT_EQ(study.report.show, (std::vector<std::string>{"F5", "F10"}));
}

TEST(ReadStudy, SaysWhatIsWrong) {
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"[vary]\ntarget.radios = [4]", "study.toml:3: \"target.radios\" is not a parameter; did you mean"},
      {"[vary]\ntarget.radius = [4, \"five\"]", "study.toml:3: target.radius: expects a number in m"},
      {"[report]\nof = \"all\"", "study.toml:3: report.of: expects \"findings\", \"search\" or \"statements\""},
      {"[report]\nof = \"statements\"", "study.toml:2: report.of: \"statements\" needs a [[statement]]"},
      {"[statement]\ntext = \"a\"", "statement: is a list of tables: write [[statement]]"},
      {"[[statement]]\ntext = \"a\"\nat_most = 1", "study.toml:2: statement.column: names a column of the table"},
      {"[[statement]]\ncolumn = \"a\"\nat_most = 1", "study.toml:2: statement.text: says what is stated"},
      {"[[statement]]\ntext = \"a\"\ncolumn = \"b\"", "study.toml:2: statement: needs 'at_most' or 'at_least'"},
      {"[[statement]]\ntext = \"a\"\ncolumn = \"b\"\nat_most = nan",
       "study.toml:5: statement.at_most: expects a finite number"},
      {"[[statement]]\ntext = \"a\"\ncolumn = \"b\"\nat_most = 1\nagainst = \"c\"",
       "study.toml:6: statement.against: is not the name of a [[variant]]"},
      {"[report]\nshow = [5]", "study.toml:3: report.show: expects a list of findings"},
      {"[vary]\ntarget.radius = []", "target.radius: has no values"},
      {"[vary]\ntarget.radius = 4", "expects a list of values or { from = ..."},
      {"[vary]\ntarget.radius = { from = 4 }", "needs the number 'to'"},
      {"[vary]\ntarget.radius = { from = 5, to = 4, steps = 3 }", "'from' must be below 'to'"},
      {"[vary]\ntarget.radius = { from = 4, to = 5 }", "a grid needs 'steps'"},
      {"[vary]\ntarget.radius = { from = 4, to = 5, steps = 1 }", "expects a whole number from 2"},
      {"[vary]\ntarget.radius = { from = 4, to = 5, step = 3 }", "step: is not a key of a study"},
      {"[vary]\ntarget.spin = { from = 4, to = 5, steps = 3 }", "target.spin: expects a list of three numbers"},
      {"[vary]\ncontact.friction = { from = 0, to = 1, steps = 3, scale = \"log\" }", "needs 'from' above 0"},
      {"[vary]\ntarget.radius = { from = 4, to = 5, steps = 90000 }\ntarget.mass = [1, 2]", "1.8e+05 points are more"},
      {"sampling = \"random\"", "or \"sobol\", not \"random\""},
      {"sampling = \"halton\"", "samples: says how many points"},
      {"colour = 1", "colour: is not a key of a study; these are: name, description"},
      {"[[variant]]\nclosing.duration = 5", "variant.name: expects a name"},
      {"[[variant]]\nname = \"a\"\n[[variant]]\nname = \"a\"", "\"a\" is the name of another one"},
      {"[variant]\nname = \"a\"", "variant: is a list of tables: write [[variant]]"},
      {"[set]\nnet.diameter = 4", "study.toml:3: net.diameter: must be >= 1e-5"},
      {"[set]\ntarget.mass = 100\n\"target.mass\" = 200", "target.mass: is set twice"},
      {"[vary]\ntarget.mass = [1, 2]\n\"target.mass\" = [3]", "target.mass: is varied twice"},
      {"[[variant]]\nname = \"a\\nb\"", "variant.name: expects a name in one line, without '/'"},
      {"[set]\ntarget.mesh_file = \"/tmp/a.stl\"",
       "study.toml:3: target.mesh_file: \"/tmp/a.stl\" is an absolute path; a "
       "study names meshes in the folder of its base or below"},
      {"[vary]\ntarget.mesh_file = [\"a.stl\", \"/tmp/a.stl\"]", "\"/tmp/a.stl\" is an absolute path"},
      {"vary = 3", "vary: is a table: write [vary]"},
      {"[ensemble]\nseeds = 16", "study.toml:3: seeds: is not a key of a study; these are: runs, perturbation"},
      {"[ensemble]\nperturbation = 1e-6", "ensemble.runs: says how many draws to make, e.g. 16"},
      {"[ensemble]\nruns = 1", "study.toml:3: runs: expects a whole number from 2"},
      {"[ensemble]\nruns = 16\nperturbation = 0", "study.toml:4: perturbation: expects a length in m above 0"},
      {"[ensemble]\nruns = 16\nperturbation = \"small\"", "study.toml:4: perturbation: expects a length in m above 0"},
      {"[ensemble]\nruns = 16\nperturbation = 0.02", "study.toml:4: solver.perturbation: must be"},
      {"[vary", "study.toml:2: "},
  };
  for (const auto& c : cases) {
    const StudyFolder folder;
    const StudyResult result = folder.read(c.text);
    EXPECT_FALSE(result.ok()) << c.text;
    EXPECT_NE(result.diagnostics.text().find(c.says), std::string::npos) << c.text << ":\n"
                                                                         << result.diagnostics.text();
  }
}

TEST(ReadStudy, ASentenceStandsOnceForAllValues) {
  const StudyFolder folder;
  const std::string text = folder.read("[vary]\ntarget.radios = [\n 4,\n 5,\n 6]\n").diagnostics.text();
  EXPECT_EQ(text.find("target.radios"), text.rfind("target.radios")) << text;
}

TEST(ReadStudy, ABaseIsARelativePath) {
  const StudyFolder folder;
  folder.write("study.toml", "\nbase = \"/etc/case1.toml\"\n");
  EXPECT_NE(read_study_file(folder.file("study.toml"))
                .diagnostics.text()
                .find("study.toml:2: base: \"/etc/case1.toml\" is an absolute path; a base is named relative to the "
                      "study's file"),
            std::string::npos);
}

TEST(ReadStudy, NeedsABase) {
  const StudyFolder folder;
  folder.write("none.toml", "name = \"x\"");
  EXPECT_NE(read_study_file(folder.file("none.toml")).diagnostics.text().find("names the scenario"), std::string::npos);
  folder.write("lost.toml", "base = \"nowhere.toml\"");
  EXPECT_NE(read_study_file(folder.file("lost.toml")).diagnostics.text().find("nowhere.toml: there is no such file"),
            std::string::npos);
  EXPECT_NE(read_study_file(folder.file("missing.toml")).diagnostics.text().find("cannot be read"), std::string::npos);
  EXPECT_NE(read_study_file(folder.file("")).diagnostics.text().find("is a folder"), std::string::npos);
}

}  // namespace
}  // namespace netpocket
