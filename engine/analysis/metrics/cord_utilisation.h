#pragma once
// How much of the strength of its cords a run has used. Thread contract: one thread at a time per object.

#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

class CordUtilisation {
 public:
  // `strengths`: breaking force (N) by element group; groups with 0 are left out.
  CordUtilisation(const Structure& structure, const std::vector<double>& strengths);

  void add(const Snapshot& snapshot);

  // Largest tension of any element by its strength. NaN if no element has a strength.
  double peak() const;
  // The value that 99 % of the elements never exceed. One overloaded element is a defect of a knot, one in a hundred is
  // a net that is too weak. NaN as above.
  double most_elements() const;

 private:
  std::vector<double> strengths_;  // N, by element; 0: none
  std::vector<double> largest_;    // tension by strength, by element
};

}  // namespace netpocket
