// What a study says about its drafts (engine/study/draft_runs.h).

#include "engine/study/draft_runs.h"

#include <gtest/gtest.h>

#include "engine/scenario/fidelity.h"
#include "engine/study/run_study.h"
#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

const std::string kShort =
    "pocket.elements_per_side = 1\npocket.mesh_rows = 2\npocket.mesh_columns = 2\noutput.end_time = 0.05\n";

TEST(DraftRuns, AStudyInFullSaysNothing) {
  const StudyFolder folder;
  const Study study = folder.read("[set]\n" + kShort + "[vary]\nnet.diameter = [0.004, 0.005]\n").study;
  EXPECT_EQ(draft_runs_text(study), "");
  (void)run_study(study, folder.file("out"), {.jobs = 1});
  EXPECT_EQ(recorded_drafts_text(folder.file("out")), "");
}

TEST(DraftRuns, AStudyOfDraftsSaysSo) {
  const StudyFolder folder;
  const Study study =
      folder.read("[set]\nsolver.fidelity = \"draft\"\n" + kShort + "[vary]\nnet.diameter = [0.004, 0.005]\n").study;
  const std::string text = draft_runs_text(study);
  EXPECT_NE(text.find("all runs"), std::string::npos) << text;
  EXPECT_NE(text.find(draft_notice(Fidelity::draft)), std::string::npos) << text;
  (void)run_study(study, folder.file("out"), {.jobs = 1});
  EXPECT_EQ(recorded_drafts_text(folder.file("out")), text);
}

TEST(DraftRuns, AVariantOfDraftsIsNamed) {
  const StudyFolder folder;
  const Study study = folder
                          .read("[set]\n" + kShort +
                                "[vary]\nnet.diameter = [0.004]\n[[variant]]\nname = \"fine\"\n[[variant]]\n"
                                "name = \"quick\"\nsolver.fidelity = \"draft\"\n")
                          .study;
  const std::string text = draft_runs_text(study);
  EXPECT_NE(text.find("runs with solver.fidelity"), std::string::npos) << text;
  (void)run_study(study, folder.file("out"), {.jobs = 1});
  EXPECT_EQ(recorded_drafts_text(folder.file("out")), text);
}

}  // namespace
}  // namespace netpocket
