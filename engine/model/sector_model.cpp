#include "engine/model/sector_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "engine/math/block_size.h"
#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// Largest difference of two numbers that are taken as equal, as a part of the larger one or of one unit.
constexpr double kAlike = 1e-9;

bool are_alike(double a, double b) { return std::abs(a - b) <= kAlike * std::max({1.0, std::abs(a), std::abs(b)}); }
bool are_alike(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return are_alike(a.x(), b.x()) && are_alike(a.y(), b.y()) && are_alike(a.z(), b.z());
}
// Lengths and stiffnesses may be small: they are compared by their ratio.
bool have_ratio_one(double a, double b) { return std::abs(a - b) <= kAlike * std::max(std::abs(a), std::abs(b)); }
bool is_on_axis(const Eigen::Vector3d& v) { return std::abs(v.x()) <= kAlike && std::abs(v.z()) <= kAlike; }

class SymmetryTest {
 public:
  SymmetryTest(const Model& model, int sectors) : model_(model), sectors_(sectors), turn_(sectors) {}

  std::optional<std::string> operator()() const {
    if (const auto problem = unsupported()) return problem;
    for (const auto& test : {&SymmetryTest::counts, &SymmetryTest::nodes, &SymmetryTest::gradients,
                             &SymmetryTest::elements, &SymmetryTest::hinges, &SymmetryTest::ropes}) {
      if (const auto problem = (this->*test)()) return problem;
    }
    return bodies();
  }

 private:
  using Problem = std::optional<std::string>;

  // The index that one turn takes `i` to.
  std::int32_t next(std::int32_t i) const {
    if (i < 0) return i;
    return i % sectors_ + 1 < sectors_ ? i + 1 : i + 1 - sectors_;
  }

  Problem unsupported() const {
    if (sectors_ < 3) return "the model has no sectors";
    if (!model_.lines.empty() || !model_.ring_ropes.empty() || !model_.locks.empty()) {
      return "lines, ropes through rings and locked bodies have no sectors";
    }
    if (model_.orbit) return "the tide of an orbit acts across the axis";
    if (!is_on_axis(model_.gravity)) return "gravity acts across the axis";
    return std::nullopt;
  }

  Problem counts() const {
    const auto divides = [this](std::size_t count) { return count % static_cast<std::size_t>(sectors_) == 0; };
    if (divides(model_.nodes.size()) && divides(model_.gradients.size()) && divides(model_.elements.size()) &&
        divides(model_.hinges.size()) && divides(model_.ropes.size())) {
      return std::nullopt;
    }
    return "sectors have different numbers of parts";
  }

  Problem nodes() const {
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      const ModelNode& node = model_.nodes[i];
      const ModelNode& image = model_.nodes[static_cast<std::size_t>(next(static_cast<std::int32_t>(i)))];
      if (are_alike(turn_(1, node.position), image.position) && are_alike(turn_(1, node.velocity), image.velocity) &&
          are_alike(turn_(1, node.load), image.load) && are_alike(node.point_mass, image.point_mass) &&
          node.support == image.support && node.body == image.body)
        continue;
      return fmt::format("node {} is not the turned node of the sector before", image_index(i));
    }
    return std::nullopt;
  }

  Problem gradients() const {
    for (std::size_t i = 0; i < model_.gradients.size(); ++i) {
      const ModelGradient& one = model_.gradients[i];
      const ModelGradient& image = model_.gradients[static_cast<std::size_t>(next(static_cast<std::int32_t>(i)))];
      if (next(one.node) == image.node && are_alike(turn_(1, one.value), image.value) &&
          are_alike(turn_(1, one.rate), image.rate) && one.support == image.support && one.body == image.body)
        continue;
      return fmt::format("gradient {} is not the turned gradient of the sector before", image_index(i));
    }
    return std::nullopt;
  }

  Problem elements() const {
    for (std::size_t i = 0; i < model_.elements.size(); ++i) {
      const ModelElement& one = model_.elements[i];
      const ModelElement& image = model_.elements[static_cast<std::size_t>(next(static_cast<std::int32_t>(i)))];
      if (next(one.node1) == image.node1 && next(one.node2) == image.node2 && next(one.gradient1) == image.gradient1 &&
          next(one.gradient2) == image.gradient2 && have_ratio_one(one.length, image.length) &&
          one.material == image.material && one.group == image.group &&
          next(one.strain_partner) == image.strain_partner)
        continue;
      return fmt::format("{} differs from {}", thread_of(image), thread_of(one));
    }
    return std::nullopt;
  }

  // R of the next sector is T R T^-1: compared by what both do to three vectors.
  Problem hinges() const {
    for (std::size_t i = 0; i < model_.hinges.size(); ++i) {
      const Hinge& one = model_.hinges[i];
      const Hinge& image = model_.hinges[static_cast<std::size_t>(next(static_cast<std::int32_t>(i)))];
      bool alike = next(one.gradient1) == image.gradient1 && next(one.gradient2) == image.gradient2 &&
                   one.body == image.body && have_ratio_one(one.stiffness, image.stiffness) &&
                   have_ratio_one(one.damping, image.damping);
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d v = Eigen::Vector3d::Unit(axis);
        alike = alike && are_alike(turn_(1, one.rest_rotation * v), image.rest_rotation * turn_(1, v));
      }
      if (!alike) return fmt::format("hinge {} differs from hinge {}", image_index(i), i);
    }
    return std::nullopt;
  }

  Problem ropes() const {
    for (std::size_t i = 0; i < model_.ropes.size(); ++i) {
      const VariableRope& one = model_.ropes[i];
      const VariableRope& image = model_.ropes[static_cast<std::size_t>(next(static_cast<std::int32_t>(i)))];
      const bool same_elements = std::ranges::equal(one.elements, image.elements,
                                                    [this](std::int32_t a, std::int32_t b) { return next(a) == b; });
      if (same_elements && have_ratio_one(one.motion.length, image.motion.length) &&
          are_alike(one.motion.rate, image.motion.rate) && are_alike(one.share_at_start, image.share_at_start))
        continue;
      return fmt::format("rope {} differs from rope {}", image_index(i), i);
    }
    return std::nullopt;
  }

  Problem bodies() const {
    for (const ModelBody& body : model_.bodies) {
      if (!is_on_axis(body.state.position) || !is_on_axis(body.state.velocity) ||
          !is_on_axis(body.state.angular_velocity)) {
        return fmt::format("the {} is not on the axis or does not move along it", body.name);
      }
      const Eigen::Matrix3d to_world = body.state.attitude.toRotationMatrix();
      const Eigen::Vector3d along = to_world * body.inertia * to_world.transpose() * Eigen::Vector3d::UnitY();
      if (!(std::abs(along.x()) <= kAlike * along.y() && std::abs(along.z()) <= kAlike * along.y())) {
        return fmt::format("the axis is no principal axis of the {}", body.name);
      }
    }
    return std::nullopt;
  }

  std::int32_t image_index(std::size_t i) const { return next(static_cast<std::int32_t>(i)); }
  const std::string& thread_of(const ModelElement& element) const {
    return model_.threads[static_cast<std::size_t>(element.thread)];
  }

  const Model& model_;
  int sectors_;
  SectorTurn turn_;
};

// Elements of a cord, in their order. A unit is what one lane holds at one place: a pair of elements with their middle,
// or one element.
struct Chain {
  std::vector<std::int32_t> elements;  // of the whole
  bool paired = false;

  int units() const { return static_cast<int>(elements.size()) / (paired ? 2 : 1); }
};

std::vector<Chain> chains_of_first_sector(const Model& whole, int sectors) {
  std::map<std::int32_t, std::int32_t> starting;  // element by its first gradient
  std::map<std::int32_t, bool> continued;         // gradients at which an element ends
  for (std::size_t i = 0; i < whole.elements.size(); i += static_cast<std::size_t>(sectors)) {
    starting[whole.elements[i].gradient1] = static_cast<std::int32_t>(i);
    continued[whole.elements[i].gradient2] = true;
  }
  std::vector<Chain> chains;
  for (const auto& [gradient, first] : starting) {
    if (continued.contains(gradient)) continue;
    Chain chain;
    for (auto at = starting.find(gradient); at != starting.end();
         at = starting.find(whole.elements[static_cast<std::size_t>(chain.elements.back())].gradient2)) {
      chain.elements.push_back(at->second);
    }
    chain.paired = chain.elements.size() % 2 == 0;
    for (std::size_t i = 0; i + 1 < chain.elements.size(); i += 2) {
      const ModelElement& element = whole.elements[static_cast<std::size_t>(chain.elements[i])];
      chain.paired = chain.paired && element.strain_partner == chain.elements[i + 1];
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

// A lane has places in a row, each of them between two slots for knots. Between two chains one place is idle.
using Lane = std::vector<const Chain*>;
int places_of(const Lane& lane) {
  int places = -1;
  for (const Chain* chain : lane) places += chain->units() + 1;
  return places;
}

// Lays the chains side by side in eight lanes of so many places, the longest first, each into the fullest lane that has
// room. Nothing if a chain finds none.
std::optional<std::vector<Lane>> lanes_of(const std::vector<const Chain*>& chains, int places) {
  std::vector<Lane> lanes(kBlockSize);
  for (const Chain* chain : chains) {
    Lane* fullest = nullptr;
    for (Lane& lane : lanes) {
      if (places_of(lane) + 1 + chain->units() > places) continue;
      if (fullest == nullptr || places_of(lane) > places_of(*fullest)) fullest = &lane;
    }
    if (fullest == nullptr) return std::nullopt;
    fullest->push_back(chain);
  }
  return lanes;
}

// In as few places as this finds.
std::vector<Lane> lanes_of(std::vector<const Chain*> chains) {
  std::ranges::stable_sort(chains, [](const Chain* a, const Chain* b) { return a->units() > b->units(); });
  for (int places = chains.front()->units();; ++places) {
    if (auto lanes = lanes_of(chains, places)) return std::move(*lanes);
  }
}

// Cuts few chains so that each lane holds one piece and all lanes are about as long. Many chains stay whole. Strain
// partners stay together: they share their middle node.
std::vector<Chain> cut_to_lanes(const std::vector<Chain>& chains, const Model& whole) {
  if (chains.size() > static_cast<std::size_t>(kBlockSize)) return chains;
  const auto is_pair = [&](std::int32_t one, std::int32_t next) {
    return whole.elements[static_cast<std::size_t>(one)].strain_partner == next;
  };
  std::vector<Chain> pieces;
  for (std::size_t longest = 1; pieces.empty() || pieces.size() > static_cast<std::size_t>(kBlockSize); ++longest) {
    pieces.clear();
    for (const Chain& chain : chains) {
      pieces.emplace_back();
      for (std::size_t i = 0; i < chain.elements.size(); ++i) {
        const std::vector<std::int32_t>& last = pieces.back().elements;
        if (last.size() >= longest && !is_pair(last.back(), chain.elements[i])) pieces.emplace_back();
        pieces.back().elements.push_back(chain.elements[i]);
      }
    }
  }
  return pieces;
}

class SectorBuild {
 public:
  SectorBuild(const Model& whole, int sectors) : whole_(whole), sectors_(sectors) {}

  SectorModel operator()() {
    begin();
    const std::vector<Chain> chains = chains_of_first_sector(whole_, sectors_);
    for (const bool paired : {true, false}) {
      std::vector<Chain> alike;
      std::ranges::copy_if(chains, std::back_inserter(alike), [&](const Chain& c) { return c.paired == paired; });
      if (alike.empty()) continue;
      if (!paired) alike = cut_to_lanes(alike, whole_);
      std::vector<const Chain*> pieces;
      for (const Chain& chain : alike) pieces.push_back(&chain);
      lay(lanes_of(pieces), paired);
    }
    add_strain_partners();
    add_joints();
    add_ties();
    return std::move(result_);
  }

 private:
  void begin() {
    result_.sectors = sectors_;
    Model& model = result_.model;
    model.materials = whole_.materials;
    CableMaterial idle;
    idle.section = CableSection{};
    idle.section.EA = idle.section.EI = 0;
    idle.section.mass_per_length = std::numeric_limits<double>::min();  // its wave speed is 0 and not undefined
    result_.idle_material = model.add_material(idle);
    model.element_groups = whole_.element_groups;
    model.threads = whole_.threads;
    model.bodies = whole_.bodies;
    model.contact = whole_.contact;
    model.contact.cords = false;
    model.gravity = whole_.gravity;
  }

  // Adds eight nodes with a gradient each, all idle.
  std::int32_t add_block() {
    Model& model = result_.model;
    const auto first = static_cast<std::int32_t>(model.nodes.size());
    for (std::int32_t lane = 0; lane < kBlockSize; ++lane) {
      model.nodes.push_back({.position = Eigen::Vector3d::Zero(), .support = Support::fixed});
      model.gradients.push_back({.node = first + lane, .value = Eigen::Vector3d::UnitX(), .support = Support::fixed});
      result_.node_of.push_back(-1);
      result_.gradient_of.push_back(-1);
    }
    return first;
  }

  // Makes an idle place hold a node and a gradient of the whole.
  void fill(std::int32_t place, std::int32_t node, std::int32_t gradient) {
    const auto at = static_cast<std::size_t>(place);
    result_.model.nodes[at] = whole_.nodes[static_cast<std::size_t>(node)];
    result_.model.nodes[at].point_mass = 0;  // the first copy has it
    result_.model.nodes[at].load.setZero();
    result_.model.gradients[at] = whole_.gradients[static_cast<std::size_t>(gradient)];
    result_.model.gradients[at].node = place;
    result_.node_of[at] = node;
    result_.gradient_of[at] = gradient;
  }

  void add_element(std::int32_t from, std::int32_t to, std::int32_t of_whole) {
    ModelElement element;
    if (of_whole >= 0) {
      element = whole_.elements[static_cast<std::size_t>(of_whole)];
    } else {
      element = whole_.elements.front();
      element.material = result_.idle_material;
    }
    element.node1 = element.gradient1 = from;
    element.node2 = element.gradient2 = to;
    element.strain_partner = -1;
    result_.element_of.push_back(of_whole);
    result_.model.elements.push_back(element);
  }

  // The elements of each lane, by place; -1: idle.
  std::vector<std::vector<std::int32_t>> places(const std::vector<Lane>& lanes, int per_unit) const {
    int count = 0;
    for (const Lane& lane : lanes) count = std::max(count, places_of(lane));
    std::vector<std::vector<std::int32_t>> result;
    for (const Lane& lane : lanes) {
      std::vector<std::int32_t> row;
      for (const Chain* chain : lane) {
        if (!row.empty()) row.insert(row.end(), static_cast<std::size_t>(per_unit), -1);
        row.insert(row.end(), chain->elements.begin(), chain->elements.end());
      }
      row.resize(static_cast<std::size_t>(count * per_unit), -1);
      result.push_back(std::move(row));
    }
    return result;
  }

  // Blocks of nodes at the slots and, of pairs, at the middles; blocks of elements in between.
  void lay(const std::vector<Lane>& lanes, bool paired) {
    const int per_unit = paired ? 2 : 1;
    const auto rows = places(lanes, per_unit);
    const auto steps = static_cast<std::int32_t>(rows.front().size());
    const std::int32_t first = add_block();
    for (std::int32_t i = 0; i < steps; ++i) add_block();
    for (std::int32_t i = 0; i < steps; ++i) {
      for (std::int32_t lane = 0; lane < kBlockSize; ++lane) {
        const std::int32_t from = first + i * kBlockSize + lane, to = from + kBlockSize;
        const std::int32_t element = rows[static_cast<std::size_t>(lane)][static_cast<std::size_t>(i)];
        add_element(from, to, element);
        if (element < 0) continue;
        const ModelElement& whole = whole_.elements[static_cast<std::size_t>(element)];
        fill(from, whole.node1, whole.gradient1);
        fill(to, whole.node2, whole.gradient2);
      }
    }
    if (!paired) return;
    // Idle pairs too: the kernel takes a block of pairs as a whole.
    for (std::int32_t i = 0; i < steps; i += 2) {
      const auto base = static_cast<std::int32_t>(result_.model.elements.size()) - (steps - i) * kBlockSize;
      for (std::int32_t lane = 0; lane < kBlockSize; ++lane) {
        if (result_.element_of[static_cast<std::size_t>(base + lane)] < 0) {
          result_.model.pair(base + lane, base + lane + kBlockSize);
        }
      }
    }
  }

  void add_strain_partners() {
    for (std::size_t i = 0; i < result_.element_of.size(); ++i) {
      if (result_.element_of[i] >= 0) place_of_element_[result_.element_of[i]] = static_cast<std::int32_t>(i);
    }
    for (const auto& [element, place] : place_of_element_) {
      const std::int32_t partner = whole_.elements[static_cast<std::size_t>(element)].strain_partner;
      if (partner >= 0)
        result_.model.elements[static_cast<std::size_t>(place)].strain_partner = place_of_element_.at(partner);
    }
  }

  void add_joints() {
    std::map<std::int32_t, std::int32_t> place_of_gradient;
    for (std::size_t i = 0; i < result_.gradient_of.size(); ++i) {
      if (result_.gradient_of[i] >= 0) place_of_gradient[result_.gradient_of[i]] = static_cast<std::int32_t>(i);
    }
    const auto stride = static_cast<std::size_t>(sectors_);
    for (std::size_t i = 0; i < whole_.hinges.size(); i += stride) {
      Hinge hinge = whole_.hinges[i];
      hinge.gradient1 = place_of_gradient.at(hinge.gradient1);
      hinge.gradient2 = place_of_gradient.at(hinge.gradient2);
      result_.model.hinges.push_back(hinge);
    }
    for (std::size_t i = 0; i < whole_.ropes.size(); i += stride) {
      VariableRope rope = whole_.ropes[i];
      for (std::int32_t& element : rope.elements) element = place_of_element_.at(element);
      result_.model.ropes.push_back(std::move(rope));
    }
  }

  // Copies of a node of one place in the sectors: the copy with the fewest turns leads.
  void add_ties() {
    std::map<std::int32_t, std::vector<std::int32_t>> copies;  // by place in the sectors
    for (std::size_t i = 0; i < result_.node_of.size(); ++i) {
      if (result_.node_of[i] >= 0) copies[result_.node_of[i] / sectors_].push_back(static_cast<std::int32_t>(i));
    }
    const auto turns = [&](std::int32_t copy) { return result_.node_of[static_cast<std::size_t>(copy)] % sectors_; };
    for (auto& [place, nodes] : copies) {
      std::ranges::stable_sort(nodes, {}, turns);
      const std::int32_t leader = nodes.front();
      ModelNode& leading = result_.model.nodes[static_cast<std::size_t>(leader)];
      const ModelNode& whole =
          whole_.nodes[static_cast<std::size_t>(result_.node_of[static_cast<std::size_t>(leader)])];
      leading.point_mass = whole.point_mass;
      leading.load = whole.load;
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        result_.ties.push_back({leader, nodes[i], turns(nodes[i]) - turns(leader)});
      }
    }
    std::ranges::stable_sort(result_.ties, {}, &SectorModel::Tie::leader);
    std::map<std::int32_t, std::int32_t> first;  // copy of a gradient of the whole
    for (std::size_t i = 0; i < result_.gradient_of.size(); ++i) {
      if (result_.gradient_of[i] < 0) continue;
      const auto copy = static_cast<std::int32_t>(i);
      const auto [leader, is_new] = first.try_emplace(result_.gradient_of[i], copy);
      if (is_new) continue;
      result_.gradient_ties.push_back({leader->second, copy, 0});
      result_.model.gradients[i].copy_of = leader->second;
    }
    std::ranges::stable_sort(result_.gradient_ties, {}, &SectorModel::Tie::leader);
  }

  const Model& whole_;
  int sectors_;
  SectorModel result_;
  std::map<std::int32_t, std::int32_t> place_of_element_;  // index in the sector by index in the whole
};

}  // namespace

SectorTurn::SectorTurn(int sectors) {
  for (int i = 0; i < sectors; ++i) {
    const double angle = 2 * std::numbers::pi * i / sectors;
    cosine_.push_back(netpocket::cosine(angle));
    sine_.push_back(netpocket::sine(angle));
  }
  if (sectors % 4 != 0) return;
  const int quarter = sectors / 4;
  for (int i = 0; i < sectors; ++i) {
    const int rest = i % quarter;
    double c = rest == 0 ? 1 : 8 * rest == sectors ? std::sqrt(0.5) : cosine_[static_cast<std::size_t>(rest)];
    double s = rest == 0 ? 0 : 8 * rest == sectors ? std::sqrt(0.5) : sine_[static_cast<std::size_t>(rest)];
    for (int turn = 0; turn < i / quarter; ++turn) {
      const double before = c;
      c = -s;
      s = before;
    }
    cosine_[static_cast<std::size_t>(i)] = c;
    sine_[static_cast<std::size_t>(i)] = s;
  }
}

std::optional<std::string> find_asymmetry(const Model& whole, int sectors) { return SymmetryTest(whole, sectors)(); }

SectorModel sector_model(const Model& whole, int sectors) { return SectorBuild(whole, sectors)(); }

}  // namespace netpocket
