#include "engine/study/sensitivity_estimate.h"

#include <fmt/format.h>

#include <limits>

#include "engine/study/study_table.h"

namespace netpocket {
namespace {

constexpr int kResamples = 1000;

std::string interval_text(const Estimate& e) {
  return fmt::format("{:8.3f} ({:.3f} to {:.3f})", e.value, e.interval.lower, e.interval.upper);
}

std::string table_of(const SensitivityEstimate& e, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < e.sobol.size(); ++i) {
    text +=
        fmt::format("  {:<32}{}   {}\n", names[i], interval_text(e.sobol[i].first), interval_text(e.sobol[i].total));
  }
  for (std::size_t i = 0; i < e.effects.size(); ++i) {
    const InputEffect& effect = e.effects[i];
    text += fmt::format("  {:<32}{:>12.4g}{:>12.4g}{:>12.4g}\n", names[i], effect.mean_absolute, effect.mean,
                        effect.deviation);
  }
  return text;
}

}  // namespace

void SensitivityEstimator::add(const StudyRecord& record) {
  const std::size_t index = record["point"].get<std::size_t>() - 1;
  const std::size_t group = index % plan_.group_count(), draw = index / plan_.group_count();
  if (draw >= plan_.draw_count()) return;
  for (std::size_t v = 0; v < record["runs"].size(); ++v) {
    Eigen::VectorXd& outputs = outputs_[{group, v}];
    if (outputs.size() == 0) {
      outputs.setConstant(static_cast<Eigen::Index>(plan_.draw_count()), std::numeric_limits<double>::quiet_NaN());
    }
    outputs[static_cast<Eigen::Index>(draw)] = run_number(record["runs"][v], study_.sensitivity.of);
  }
}

std::vector<SensitivityEstimate> SensitivityEstimator::estimates() const {
  std::vector<SensitivityEstimate> list;
  const int dimensions = coordinate_count(study_.uncertain);
  for (const auto& [key, outputs] : outputs_) {
    SensitivityEstimate e{key.first, study_.variants[key.second].name, 0};
    e.outputs = static_cast<std::size_t>(outputs.array().isFinite().count());
    if (study_.sensitivity.method == SensitivityMethod::sobol) {
      e.sobol = sobol_indices(dimensions, outputs, study_.estimate.confidence, kResamples,
                              static_cast<std::uint64_t>(study_.seed));
    } else {
      e.effects = screening_effects(plan_.design_points(), outputs);
    }
    list.push_back(std::move(e));
  }
  return list;
}

std::vector<std::string> coordinate_names(const Study& study) {
  std::vector<std::string> names;
  for (const UncertainInput& input : study.uncertain) {
    const std::vector<std::string> keys = keys_of(input);
    if (std::holds_alternative<UncertainDirection>(input)) {
      for (const char* part : {"height", "angle", "size"}) names.push_back(keys[0] + " " + part);
      continue;
    }
    const bool is_group = std::holds_alternative<CorrelatedInputs>(input);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      names.push_back(is_group && i > 0 ? keys[i] + " given those before" : keys[i]);
    }
  }
  return names;
}

std::string sensitivity_text(const Study& study, const std::vector<SensitivityEstimate>& estimates) {
  const std::vector<std::string> names = coordinate_names(study);
  const bool is_sobol = study.sensitivity.method == SensitivityMethod::sobol;
  std::string text;
  for (const SensitivityEstimate& e : estimates) {
    const std::string variant = e.variant.empty() ? "" : ", " + e.variant;
    text += fmt::format("{} of {}{} ({} values, {:g} % intervals)\n",
                        is_sobol ? "Sobol indices, first order and total," : "Effects: mean size, mean, deviation,",
                        study.sensitivity.of, variant, e.outputs, 100 * study.estimate.confidence);
    text += table_of(e, names);
  }
  return text;
}

std::string sensitivity_csv(const Study& study, const std::vector<SensitivityEstimate>& estimates) {
  const std::vector<std::string> names = coordinate_names(study);
  const bool is_sobol = study.sensitivity.method == SensitivityMethod::sobol;
  std::string text = is_sobol ? "point,variant,of,input,first,first_lower,first_upper,total,total_lower,total_upper\n"
                              : "point,variant,of,input,mean,mean_absolute,deviation,steps\n";
  for (const SensitivityEstimate& e : estimates) {
    const std::string first = fmt::format("{},\"{}\",{}", e.group + 1, e.variant, study.sensitivity.of);
    for (std::size_t i = 0; i < e.sobol.size(); ++i) {
      const auto& [s, t] = e.sobol[i];
      text += fmt::format("{},{},{},{},{},{},{},{}\n", first, names[i], s.value, s.interval.lower, s.interval.upper,
                          t.value, t.interval.lower, t.interval.upper);
    }
    for (std::size_t i = 0; i < e.effects.size(); ++i) {
      const InputEffect& effect = e.effects[i];
      text += fmt::format("{},{},{},{},{},{}\n", first, names[i], effect.mean, effect.mean_absolute, effect.deviation,
                          effect.steps);
    }
  }
  return text;
}

}  // namespace netpocket
