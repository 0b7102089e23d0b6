#include "engine/scenario/system_parameters.h"

#include <algorithm>
#include <charconv>
#include <deque>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "engine/base/edit_distance.h"
#include "engine/scenario/check_pocket.h"
#include "engine/scenario/pocket_tether.h"
#include "engine/scenario/sector_scatter.h"
#include "engine/scenario/shared_parameters.h"
#include "engine/scenario/strategy.h"
#include "engine/scenario/thrown_net_parameters.h"

namespace netpocket {
namespace {

constexpr std::string_view kGroupsOfAll[] = {"", "orbit", "solver", "output"};

// The parameters of all items that a list can have.
class ItemTable {
 public:
  explicit ItemTable(const ParameterList& list) : items_(kMostItems) {
    for (std::size_t item = 0; item < kMostItems; ++item) {
      for (Parameter row : list.rows) {
        row.key =
            keys_.emplace_back(std::string(list.name) + "." + std::to_string(item) + "." + std::string(row.name()));
        row.item = item;
        items_[item].push_back(row);
      }
    }
  }
  std::span<const Parameter> item(std::size_t index) const { return items_.at(index); }

 private:
  std::deque<std::string> keys_;  // keeps the places of its entries
  std::vector<std::vector<Parameter>> items_;
};

const ItemTable& item_table(const ParameterList& list) {
  static const std::vector<std::unique_ptr<ItemTable>> kTables = [] {
    std::vector<std::unique_ptr<ItemTable>> tables;
    for (const ParameterList& each : shared_lists()) tables.push_back(std::make_unique<ItemTable>(each));
    return tables;
  }();
  const auto found = std::ranges::find(shared_lists(), list.name, &ParameterList::name);
  return *kTables.at(static_cast<std::size_t>(found - shared_lists().begin()));
}

// The parameters, groups and lists of one kind.
struct Table {
  const SystemParameters* kind;
  std::vector<Parameter> parameters;
  std::vector<ParameterGroup> groups;
  std::vector<ParameterList> lists;
};

class Registry {
 public:
  Registry() {
    add(pocket_parameters());
    add(thrown_net_system_parameters());
  }

  void add(const SystemParameters& kind) {
    if (find(kind.name) != nullptr) {
      throw std::invalid_argument("two kinds of capture systems are called " + std::string(kind.name));
    }
    tables_.push_back(std::make_unique<Table>(table_of(kind)));
    names_.push_back(kind.name);
    for (const auto& table : tables_) {
      std::ranges::find(table->parameters, "system", &Parameter::key)->choices = names_;
    }
  }

  const Table* find(std::string_view name) const {
    const auto found = std::ranges::find(tables_, name, [](const auto& table) { return table->kind->name; });
    return found == tables_.end() ? nullptr : found->get();
  }
  const Table& table(std::string_view name) const {
    const Table* found = find(name);
    return found != nullptr ? *found : *tables_.front();
  }
  std::span<const std::string_view> names() const { return names_; }

 private:
  static Table table_of(const SystemParameters& kind) {
    Table table{&kind, {}, {}, {}};
    for (const ParameterGroup& group : shared_groups()) {
      const bool is_used =
          std::ranges::count(kGroupsOfAll, group.name) + std::ranges::count(kind.shared_groups, group.name) > 0;
      if (!is_used) continue;
      table.groups.push_back(group);
      for (const Parameter& parameter : shared_parameters()) {
        if (parameter.group() == group.name) table.parameters.push_back(parameter);
      }
    }
    if (table.groups.size() != std::size(kGroupsOfAll) + kind.shared_groups.size()) {
      throw std::invalid_argument("a table of the capture system " + std::string(kind.name) + " does not exist");
    }
    for (const ParameterList& list : shared_lists()) {
      if (std::ranges::count(kind.shared_lists, list.name) > 0) table.lists.push_back(list);
    }
    table.groups.insert(table.groups.end(), kind.groups.begin(), kind.groups.end());
    table.parameters.insert(table.parameters.end(), kind.parameters.begin(), kind.parameters.end());
    return table;
  }

  std::vector<std::unique_ptr<Table>> tables_;  // the first one is the pocket's
  std::vector<std::string_view> names_;
};

Registry& registry() {
  static Registry registry;
  return registry;
}

ParameterValue read_own(const Scenario& scenario, const Parameter& parameter) {
  const auto found = scenario.own.find(parameter.key);
  return found == scenario.own.end() ? parameter.initial() : found->second;
}

void write_own(Scenario& scenario, const Parameter& parameter, const ParameterValue& value) {
  if (value.index() != static_cast<std::size_t>(parameter.type)) throw std::bad_variant_access();
  scenario.own.insert_or_assign(std::string(parameter.key), value);
}

// Candidate with the lowest score, if that is low enough for a typing error.
template <typename Candidates, typename NameOf, typename Score>
std::optional<std::string_view> nearest(const Candidates& candidates, NameOf name_of, std::string_view unknown,
                                        Score score) {
  if (unknown.empty() || unknown.size() > kLongestComparedName) return std::nullopt;
  std::string_view best;
  auto lowest = std::pair(largest_slip(unknown) + 1, std::size_t{0});
  for (const auto& candidate : candidates) {
    const std::string_view name = name_of(candidate);
    if (const auto now = score(name); now < lowest) {
      lowest = now;
      best = name;
    }
  }
  return best.empty() ? std::nullopt : std::optional(best);
}

// The item that a key such as "controller.0.rate" belongs to.
std::optional<std::size_t> item_of(std::string_view key, const ParameterList& list) {
  if (!key.starts_with(list.name) || key.size() <= list.name.size() || key[list.name.size()] != '.')
    return std::nullopt;
  const char* begin = key.data() + list.name.size() + 1;
  std::size_t item = 0;
  const auto [end, error] = std::from_chars(begin, key.data() + key.size(), item);
  const bool is_item = error == std::errc() && end != key.data() + key.size() && *end == '.' && item < kMostItems;
  return is_item ? std::optional(item) : std::nullopt;
}

std::string_view last_part(std::string_view key) { return key.substr(key.rfind('.') + 1); }

}  // namespace

Parameter own_parameter(std::string_view key, ParameterValue (*initial)(), Limits limits, std::string_view unit,
                        std::string_view help, std::string_view source, std::span<const std::string_view> choices) {
  return {.key = key,
          .type = ParameterType{static_cast<int>(initial().index())},
          .limits = limits,
          .unit = unit,
          .help = help,
          .source = source,
          .choices = choices,
          .read = read_own,
          .write = write_own,
          .initial = initial};
}

namespace {

std::vector<Parameter> own_parameters_of_pocket() {
  std::vector<Parameter> all = scatter_parameters();
  for (const Parameter& parameter : pocket_tether_parameters()) all.push_back(parameter);
  return all;
}

}  // namespace

const SystemParameters& pocket_parameters() {
  static const SystemParameters kPocket = {
      .name = kPocketSystem,
      .title = "Netted pocket",
      .help = "Inflatable rods hold a net open; ropes between their tips close its mouth round the target.",
      .shared_groups = {"pocket", "net", "rope", "rods", "spacecraft", "target", "contact", "closing", "towing",
                        "winch", "deflation", "actuators"},
      .shared_lists = {"controller", "sensor", "actuators.thruster", "actuators.wheel", "disturbance"},
      .groups = {scatter_group(), pocket_tether_group()},
      .parameters = own_parameters_of_pocket(),
      .check = check_pocket,
      .acts_at_once = acts_at_once_in_pocket};
  return kPocket;
}

void register_system_parameters(const SystemParameters& parameters) { registry().add(parameters); }

const SystemParameters* find_system(std::string_view name) {
  const Table* table = registry().find(name);
  return table != nullptr ? table->kind : nullptr;
}

std::span<const std::string_view> system_names() { return registry().names(); }

std::span<const Parameter> parameters(std::string_view system) { return registry().table(system).parameters; }

std::span<const ParameterGroup> parameter_groups(std::string_view system) { return registry().table(system).groups; }

std::span<const Parameter> parameters_of(const ParameterGroup& group, std::string_view system) {
  const std::vector<Parameter>& all = registry().table(system).parameters;
  const auto belongs = [&](const Parameter& p) { return p.group() == group.name; };
  const auto first = std::find_if(all.begin(), all.end(), belongs);
  return {first, std::find_if_not(first, all.end(), belongs)};
}

std::span<const ParameterList> parameter_lists(std::string_view system) { return registry().table(system).lists; }

std::span<const Parameter> parameters_of(const ParameterList& list, std::size_t item) {
  return item_table(list).item(item);
}

std::vector<const Parameter*> parameters_of(const Scenario& scenario) {
  std::vector<const Parameter*> all;
  for (const Parameter& parameter : parameters(scenario.system)) all.push_back(&parameter);
  for (const ParameterList& list : parameter_lists(scenario.system)) {
    for (std::size_t item = 0; item < list.size(scenario); ++item) {
      for (const Parameter& parameter : parameters_of(list, item)) all.push_back(&parameter);
    }
  }
  return all;
}

bool is_retired_parameter(std::string_view key) {
  // Until version 0.1 cords had contact at a few sample points only; now their whole length has.
  return key == "contact.samples_per_element";
}

const Parameter* find_parameter(std::string_view key, std::string_view system) {
  const std::vector<Parameter>& all = registry().table(system).parameters;
  const auto found = std::ranges::find(all, key, &Parameter::key);
  return found == all.end() ? nullptr : &*found;
}

const ParameterList* find_parameter_list(std::string_view name, std::string_view system) {
  const std::vector<ParameterList>& all = registry().table(system).lists;
  const auto found = std::ranges::find(all, name, &ParameterList::name);
  return found == all.end() ? nullptr : &*found;
}

const Parameter* find_parameter(std::string_view key, const Scenario& scenario) {
  if (const Parameter* parameter = find_parameter(key, scenario.system)) return parameter;
  for (const ParameterList& list : parameter_lists(scenario.system)) {
    const auto item = item_of(key, list);
    if (!item || *item >= list.size(scenario)) continue;
    const auto rows = parameters_of(list, *item);
    const auto found = std::ranges::find(rows, key, &Parameter::key);
    if (found != rows.end()) return &*found;
  }
  return nullptr;
}

const ParameterGroup* find_parameter_group(std::string_view name, std::string_view system) {
  const std::vector<ParameterGroup>& all = registry().table(system).groups;
  const auto found = std::ranges::find(all, name, &ParameterGroup::name);
  return found == all.end() ? nullptr : &*found;
}

std::optional<std::string_view> nearest_parameter_key(std::string_view unknown, std::string_view system) {
  // The right name in the wrong table is a likely error too. The nearer table breaks ties.
  constexpr std::size_t kWrongTable = 2;
  const auto score = [&](std::string_view key) {
    const std::size_t whole = edit_distance(unknown, key);
    return std::pair(std::min(whole, edit_distance(last_part(unknown), last_part(key)) + kWrongTable), whole);
  };
  const auto key_of = [](const Parameter& p) { return p.key; };
  for (const ParameterList& list : parameter_lists(system)) {
    if (const auto item = item_of(unknown, list)) return nearest(parameters_of(list, *item), key_of, unknown, score);
  }
  return nearest(parameters(system), key_of, unknown, score);
}

std::optional<std::string_view> nearest_group_name(std::string_view unknown, std::string_view system) {
  const auto score = [&](std::string_view name) { return std::pair(edit_distance(unknown, name), std::size_t{0}); };
  std::vector<std::string_view> names;
  for (const ParameterGroup& group : parameter_groups(system).subspan(1)) names.push_back(group.name);
  for (const ParameterList& list : parameter_lists(system)) names.push_back(list.name);
  return nearest(
      names, [](std::string_view name) { return name; }, unknown, score);
}

std::optional<std::string_view> nearest_choice(const Parameter& parameter, std::string_view unknown) {
  const auto score = [&](std::string_view name) { return std::pair(edit_distance(unknown, name), std::size_t{0}); };
  return nearest(
      parameter.choices, [](std::string_view name) { return name; }, unknown, score);
}

}  // namespace netpocket
