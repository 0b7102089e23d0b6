// What runs are called next to each other.
#include "engine/analysis/run_labels.h"

#include <gtest/gtest.h>

#include "engine/analysis/summary.h"
#include "engine/recording/recording.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

using Labels = std::vector<std::string>;

class RunLabels : public testing::Test {
 protected:
  void record(const std::string& file, const std::string& name, const std::string& settings) {
    RunOrigin origin = synthetic_origin();
    origin.scenario_name = name;
    origin.scenario_text = "# words = more\nname = \"" + name + "\"\n" + settings;
    const Structure structure = synthetic_structure(4);
    {
      Recorder recorder(folder_.file(file), origin, structure, true);
      recorder.write(synthetic_frame(structure, 0));
      recorder.finish({RunReason::finished, 0, ""}, {});
    }
    recordings_.push_back(std::make_unique<Recording>(folder_.file(file)));
  }

  std::vector<const Recording*> runs() const {
    std::vector<const Recording*> pointers;
    for (const auto& recording : recordings_) pointers.push_back(recording.get());
    return pointers;
  }

  const TemporaryFolder folder_;
  std::vector<std::unique_ptr<Recording>> recordings_;
};

TEST_F(RunLabels, AreNamesWhereTheseDiffer) {
  record("a.h5", "case1", "[target]\nradius = 4.2\n");
  record("b.h5", "case2", "[target]\nradius = 4.4\n");
  EXPECT_EQ(run_labels(runs()), (Labels{"case1", "case2"}));
}

TEST_F(RunLabels, SayWhatDiffers) {
  record("a.h5", "case1", "[target]\nradius = 4.2  # [m] of a sphere = ball\n[towing]\nmode = \"a#b\"\n");
  record("b.h5", "case1", "[target]\nradius = 4.4  # [m] of a sphere = ball\n[towing]\nmode = \"a#c\"\n");
  record("c.h5", "other", "[target]\nradius = 4.4\n");
  EXPECT_EQ(run_labels(runs()), (Labels{"case1, target.radius = 4.2, towing.mode = \"a#b\"",
                                        "case1, target.radius = 4.4, towing.mode = \"a#c\"", "other"}));
}

TEST_F(RunLabels, NameFilesWhereNoSettingOrTooManyDiffer) {
  record("a.h5", "same", "[target]\nradius = 4.2\n");
  record("b.h5", "same", "[target]\nradius = 4.2\n");
  record("c.h5", "table",
         "[closing]\ntable = [[0, 5.8], [1, 5.2], [2, 4.8], [3, 4.2], [4, 3.6], [5, 3.1], [6, 2.8]]\n");
  record("d.h5", "table",
         "[closing]\ntable = [[0, 5.8], [1, 5.1], [2, 4.8], [3, 4.2], [4, 3.6], [5, 3.1], [6, 2.8]]\n");
  EXPECT_EQ(run_labels(runs()), (Labels{"same, a.h5", "same, b.h5", "table, c.h5", "table, d.h5"}));
}

TEST_F(RunLabels, NamePathsWhereFilesShareTheirName) {
  std::filesystem::create_directory(folder_.file("x"));
  record("run.h5", "same", "");
  record("x/run.h5", "same", "");
  EXPECT_EQ(run_labels(runs()), (Labels{"same, " + folder_.file("run.h5"), "same, " + folder_.file("x/run.h5")}));
}

TEST_F(RunLabels, OfOneRunGivenTwiceAreItsName) {
  record("a.h5", "case1", "");
  EXPECT_EQ(run_labels({runs()[0], runs()[0]}), (Labels{"case1", "case1"}));
}

TEST_F(RunLabels, StandInFindings) {
  record("a.h5", "case1", "[target]\nradius = 4.2\n");
  record("b.h5", "case1", "[target]\nradius = 4.4\n");
  const auto findings = evaluate_findings(runs());
  ASSERT_EQ(findings.front().cases.size(), 2u);
  EXPECT_EQ(findings.front().cases[0].name, "case1, target.radius = 4.2");
  EXPECT_EQ(findings.front().cases[1].name, "case1, target.radius = 4.4");
}

}  // namespace
}  // namespace netpocket
