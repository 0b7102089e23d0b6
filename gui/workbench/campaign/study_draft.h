#pragma once
// A campaign as the form has it: what is uncertain about a scenario and by how much. It becomes the text of a study
// that the command line reads. Pure functions: any thread may call them.

#include <optional>
#include <string>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// How an input scatters about the scenario's value.
enum class Scatter {
  uniform,    // evenly, by at most `spread` to either side
  normal,     // with the standard deviation `spread`
  factor,     // times a log-normal number about 1, whose logarithm has the standard deviation `spread`
  direction,  // of vectors: any direction, length evenly from 0 to `spread`
};

struct DraftInput {
  std::string key;  // as in a Setting: "target.mass", "target.position[0]"
  Scatter scatter = Scatter::uniform;
  double spread = 0;  // unit of the parameter; of a factor 1

  bool operator==(const DraftInput&) const = default;
};

struct StudyDraft {
  std::string base;  // the scenario's file, relative to the study's
  std::vector<DraftInput> inputs;
  std::string sampling = "sobol";
  int samples = 400;
  int seed = 1;
  std::vector<std::string> estimate;  // columns whose quantiles are estimated
  std::optional<double> half_width;   // of the interval at which it ends early
};

// The study as TOML. Centres are the scenario's values.
std::string study_text(const StudyDraft& draft, const Scenario& scenario);

// What keeps the draft from being a study, in one sentence; nothing when it is one.
std::optional<std::string> draft_problem(const StudyDraft& draft, const Scenario& scenario);

// Keys of a scenario that can scatter: numbers, numbers of vectors, and vectors as wholes.
std::vector<std::string> scatter_keys(const Scenario& scenario);
// Ways in which one can.
std::vector<Scatter> possible_scatters(const Scenario& scenario, const std::string& key);

// A first guess: a tenth of the value.
double usual_spread(const Scenario& scenario, const std::string& key);

// A usual choice for a scenario: offset, mass and friction as far as it has them.
StudyDraft usual_draft(const Scenario& scenario);

}  // namespace netpocket
