#pragma once
// Builds the model of a thrown net: a net (net_pattern.h) with a mass on a thread at each corner, folded in front of
// the spacecraft, with a tether to the spacecraft and a drawstring round its perimeter if the scenario has them.
//
// Folding. All cords pull and do not push. The folded net is the flat net at a scale f < 1, with the slopes scaled too:
// every element has the chord slope e = f t and gradients f t. So its bending energy, which counts h = g - e (THEORY.md
// 1.2), and its axial force are zero, and its material length is the natural one. The tether is folded the same way.

#include <vector>

#include "engine/model/model.h"
#include "engine/scenario/thrown_net_parameters.h"
#include "engine/systems/thrown_net/net_pattern.h"

namespace netpocket {

inline constexpr const char* kCornerMasses = "corner masses";

struct ThrownNet {
  Model model;
  std::int32_t spacecraft = 0, target = 0;  // bodies
  NetPattern pattern;                       // of the flat net
  std::vector<std::int32_t> knots;          // nodes, by knot of the pattern
  std::vector<std::int32_t> corner_masses;  // nodes, in their order round the net
  std::vector<std::int32_t> net_elements;   // of the net's cords
  std::int32_t tether_end = -1;             // element of the tether at the spacecraft; -1: none, or it is wound
  std::int32_t tether_rope = -1;            // as the model numbers ropes, after all drawstrings; -1: it is not wound

  // Ropes of the drawstring, which come first.
  std::size_t drawstring_count() const { return model.rope_count() - (tether_rope >= 0 ? 1 : 0); }
  std::int32_t node_of(std::int32_t knot) const { return knots[static_cast<std::size_t>(knot)]; }
};

// The scenario must pass check_scenario. Throws std::runtime_error with one sentence if a file that it names has become
// unreadable since.
ThrownNet build_thrown_net(const Scenario& scenario);

}  // namespace netpocket
