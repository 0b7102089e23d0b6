#include "engine/model/lane_order.h"

#include <algorithm>
#include <map>

#include "engine/math/block_size.h"

namespace netpocket {
namespace {

// The items at one place, by part; -1: the part lacks it.
struct Group {
  std::array<std::int32_t, kBlockSize> item;
  int missing = kBlockSize;

  Group() { item.fill(-1); }
};

}  // namespace

std::vector<std::int32_t> lane_order(std::span<const LaneItem> items) {
  std::vector<Group> groups;
  std::map<std::array<std::int32_t, 4>, std::size_t> group_at;
  std::vector<std::int32_t> fillers;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto index = static_cast<std::int32_t>(i);
    if (items[i].part < 0) {
      fillers.push_back(index);
      continue;
    }
    const auto [found, is_new] = group_at.try_emplace(items[i].place, groups.size());
    if (is_new) groups.emplace_back();
    Group& group = groups[found->second];
    group.item[static_cast<std::size_t>(items[i].part)] = index;
    --group.missing;
  }
  std::ranges::stable_sort(groups, {}, &Group::missing);
  std::size_t gaps = 0;
  for (const Group& group : groups) gaps += static_cast<std::size_t>(group.missing);
  // The rarest places are given up until there are as many fillers as gaps.
  while (gaps > fillers.size()) {
    const Group& last = groups.back();
    std::ranges::copy_if(last.item, std::back_inserter(fillers), [](std::int32_t item) { return item >= 0; });
    gaps -= static_cast<std::size_t>(last.missing);
    groups.pop_back();
  }
  std::vector<std::int32_t> order;
  order.reserve(items.size());
  auto filler = fillers.begin();
  for (const Group& group : groups) {
    for (const std::int32_t item : group.item) order.push_back(item >= 0 ? item : *filler++);
  }
  order.insert(order.end(), filler, fillers.end());
  return order;
}

}  // namespace netpocket
