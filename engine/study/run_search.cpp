#include "engine/study/run_search.h"

#include <algorithm>

#include "engine/base/whole_file.h"
#include "engine/scenario/write_scenario.h"
#include "engine/study/point_runner.h"
#include "engine/study/study_manifest.h"
#include "engine/study/study_table.h"

namespace netpocket {
namespace {

void search(const Study& study, const RunPoints& run, StudyOutcome& outcome) {
  if (study.optimisation.candidates > 0) {
    outcome.optimisation = optimise(study, run);
  } else {
    outcome.rare_failure = find_rare_failure(study, run);
  }
}

void write_result(const Study& study, const std::string& folder, const StudyOutcome& outcome) {
  if (outcome.optimisation) {
    write_whole_file(folder + "/study_optimisation.csv", FileKind::csv, optimisation_csv(study, *outcome.optimisation));
    write_whole_file(folder + "/best.toml", FileKind::scenario,
                     write_scenario_text(best_scenario(study, *outcome.optimisation)));
  }
  if (outcome.rare_failure) {
    write_whole_file(folder + "/study_rare.csv", FileKind::csv, rare_failure_csv(study, *outcome.rare_failure));
  }
}

void count_outcomes(const std::vector<RecordPlace>& places, StudyOutcome& outcome) {
  RecordReader reader;
  for (const RecordPlace& place : places) {
    outcome.diverged += place.outcome == "diverged" ? 1 : 0;
    outcome.limited += place.outcome == "limited" ? 1 : 0;
    if (place.outcome != "refused") continue;
    if (++outcome.refused == 1) outcome.first_refusal = reader.read(place)["refused"].get<std::string>();
  }
}

}  // namespace

StudyOutcome run_search(const Study& study, const std::string& folder, const StudyOptions& options,
                        const StudyCallback& progress, const std::stop_token& stop) {
  const bool optimises = study.optimisation.candidates > 0;
  const std::size_t planned = optimises ? planned_points(study) : planned_rare_points(study);
  const std::string program = options.version + options.commit;
  write_study_manifest(study, planned, folder, program);
  PointRunner runner(study, folder, options, planned, progress, stop);
  StudyOutcome outcome;
  try {
    search(
        study, [&](const std::vector<StudyPoint>& points) { return runner.run(points); }, outcome);
  } catch (const SearchStopped&) {
    outcome.stopped = true;
  }
  const std::vector<RecordPlace> places = runner.places();
  outcome.points_done = places.size();
  outcome.points = outcome.stopped ? std::max(planned, places.size()) : places.size();
  outcome.runs_made = runner.runs_made();
  outcome.wall_seconds = runner.wall_seconds();
  count_outcomes(places, outcome);
  write_study_tables(study, folder, places);
  outcome.has_tables = true;
  if (outcome.stopped) return outcome;
  write_result(study, folder, outcome);
  write_study_manifest(study, places.size(), folder, program);
  return outcome;
}

}  // namespace netpocket
