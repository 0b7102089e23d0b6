#pragma once
// What is uncertain in a study: inputs with distributions instead of values. A point of a design on the unit cube
// (sampling/design.h) gives each input its values. Pure functions: any thread may call them.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/sampling/distribution.h"
#include "engine/sampling/joint_distribution.h"
#include "engine/study/setting.h"

namespace netpocket {

// A parameter, or one number of it, with a distribution of its own.
struct UncertainNumber {
  std::string key;  // as in a Setting
  Distribution distribution;
  bool is_relative = false;  // the value is the drawn number times the nominal one; all numbers of a list alike
  std::vector<std::string> choices = {};  // in TOML syntax; the distribution draws one by its index. Empty: numbers
  int steps = 0;                          // of a grid: number of values, the middles of equally likely parts
};

// A vector whose direction is evenly distributed over the sphere.
struct UncertainDirection {
  std::string key;
  Distribution size;  // unit of the parameter
};

// Numbers with a joint normal distribution.
struct CorrelatedInputs {
  std::vector<std::string> keys;
  CorrelatedNormals normals;
};

using UncertainInput = std::variant<UncertainNumber, UncertainDirection, CorrelatedInputs>;

// Number of coordinates of a design that an input takes.
int coordinate_count(const UncertainInput& input);
int coordinate_count(const std::vector<UncertainInput>& inputs);

// Keys that an input sets.
std::vector<std::string> keys_of(const UncertainInput& input);

// The values of an input for its coordinates, each in (0, 1). Numbers have twelve digits, which suffice for any
// parameter, so that a value is the same in a table and in a run. `nominal`: scenario with all other settings; it
// matters for relative inputs only.
std::vector<Setting> drawn_settings(const UncertainInput& input, std::span<const double> fractions,
                                    const Scenario& nominal);

}  // namespace netpocket
