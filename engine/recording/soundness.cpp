#include "engine/recording/soundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {

namespace {

constexpr const char* kNotRecorded = "not recorded";

// Frame at which a channel is largest; nothing when it is never positive.
std::optional<std::size_t> largest(const std::vector<double>& values) {
  std::optional<std::size_t> frame;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > (frame ? values[*frame] : 0)) frame = i;
  }
  return frame;
}

// Null for a value that is not an index: the file may hold any number.
template <typename Item>
const Item* item_at(const std::vector<Item>& items, double index) {
  const bool is_index = index >= 0 && index < static_cast<double>(items.size());
  return is_index ? &items[static_cast<std::size_t>(index)] : nullptr;
}

std::string cord_name(const Structure& structure, double index) {
  const StructureElement& element = *item_at(structure.elements, index);
  return fmt::format("{} (element {})", structure.threads[static_cast<std::size_t>(element.thread)], index);
}

// Rounds to two digits: 23456 becomes "23000".
std::string rounded_text(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
  return fmt::format("{:g}", digit * std::round(value / digit));
}

std::string stiffness_text(const RunData& run, double stiffness) {
  if (stiffness >= 1) return "its spring is as stiff as the materials";
  const auto& steps = run.channel(Channel::contact_step);
  return fmt::format("its spring is {} times softer than the materials, the stiffest that steps of {:.3g} µs resolve",
                     rounded_text(1 / stiffness), 1e6 * steps.back());
}

std::string depth_text(const RunData& run, const DeepestContact& deepest, const char* thickness, const char* where) {
  return fmt::format("{:.2g} of {} at most ({:.2g} mm), at t = {:.4g} s: {} {} {}; {}", deepest.part, thickness,
                     1e3 * deepest.depth, deepest.time, deepest.cord, where, deepest.partner,
                     stiffness_text(run, deepest.stiffness));
}

constexpr std::array<std::pair<Channel, std::string_view>, 7> kSafeguards = {
    {{Channel::shortened_steps, "steps shortened"},
     {Channel::limited_hinges, "hinge dampers limited"},
     {Channel::loose_hinges, "hinges let go"},
     {Channel::stopped_blows, "blows on bodies stopped"},
     {Channel::unresolved_contacts, "contacts too stiff for the step"},
     {Channel::stopped_cords, "cords kept from passing"},
     {Channel::parted_overlaps, "overlaps relaxed"}}};

}  // namespace

std::optional<DeepestContact> deepest_penetration(const RunData& run) {
  const auto frame = largest(run.channel(Channel::penetration_part));
  if (!frame) return std::nullopt;
  const auto value = [&](Channel c) { return run.channel(c)[*frame]; };
  const Structure& structure = run.structure();
  const double index = value(Channel::penetration_element);
  const StructureElement* element = item_at(structure.elements, index);
  const StructureBody* body = item_at(structure.bodies, value(Channel::penetration_body));
  if (element == nullptr || body == nullptr) return std::nullopt;
  const double part = value(Channel::penetration_part);
  return DeepestContact{
      run.times()[*frame],         part * element->radius, part, value(Channel::penetration_stiffness),
      cord_name(structure, index), "the " + body->name};
}

std::optional<DeepestContact> deepest_overlap(const RunData& run) {
  const auto frame = largest(run.channel(Channel::overlap_part));
  if (!frame) return std::nullopt;
  const auto value = [&](Channel c) { return run.channel(c)[*frame]; };
  const Structure& structure = run.structure();
  const double first = value(Channel::overlap_element), second = value(Channel::overlap_other);
  const StructureElement* one = item_at(structure.elements, first);
  const StructureElement* other = item_at(structure.elements, second);
  if (one == nullptr || other == nullptr) return std::nullopt;
  const double part = value(Channel::overlap_part);
  return DeepestContact{
      run.times()[*frame],         part * (one->radius + other->radius), part, value(Channel::overlap_stiffness),
      cord_name(structure, first), cord_name(structure, second)};
}

std::string penetration_text(const RunData& run) {
  if (const auto deepest = deepest_penetration(run)) {
    return depth_text(run, *deepest, "the cord's radius", "in");
  }
  const auto frame = largest(run.channel(Channel::penetration_max));
  if (!frame) return "none";
  const auto& depths = run.channel(Channel::penetration_max);
  return fmt::format("{:.2g} mm at most, at t = {:.4g} s; where was {}", 1e3 * depths[*frame], run.times()[*frame],
                     kNotRecorded);
}

std::string overlap_text(const RunData& run) {
  if (!run.has_channel(Channel::overlap_part)) return kNotRecorded;
  const auto deepest = deepest_overlap(run);
  return deepest ? depth_text(run, *deepest, "the two radii", "and") : "none";
}

std::vector<SafeguardCount> safeguard_counts(const RunData& run) {
  std::vector<SafeguardCount> counts;
  if (run.frame_count() == 0) return counts;
  for (const auto& [channel, words] : kSafeguards) {
    if (!run.has_channel(channel)) return {};
    counts.push_back({channel_info(channel).name, words, run.channel(channel).back()});
  }
  return counts;
}

namespace {

// A count of 1e5 tells nobody whether much was held back. Of hinges, which fold in many sound runs, the mean tells it.
std::string count_text(const SafeguardCount& count, std::int64_t steps) {
  const std::string text = fmt::format("{} {:.0f}", count.words, count.value);
  if (count.name != channel_info(Channel::limited_hinges).name || steps <= 0) return text;
  return text + fmt::format(" ({:.2g} a step on the mean, usual while rods fold: they are damped less)",
                            count.value / static_cast<double>(steps));
}

}  // namespace

std::string safeguards_text(const RunData& run) {
  const auto counts = safeguard_counts(run);
  if (counts.empty()) return run.frame_count() == 0 ? "none acted" : kNotRecorded;
  std::string text;
  for (const SafeguardCount& count : counts) {
    if (count.value == 0) continue;
    text += (text.empty() ? "" : ", ") + count_text(count, run.statistics().steps);
  }
  return text.empty() ? "none acted" : text + " (each place in each step counts)";
}

}  // namespace netpocket
