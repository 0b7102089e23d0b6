#pragma once
// Watches whether cords touch each other while one sector of a system stands for all (symmetric_sector.h). It looks at
// two adjacent sectors: by symmetry every pair of cords of one sector or of adjacent ones is among theirs. Sectors that
// are not adjacent must stay clear of each other, which follows from the angle that a sector takes up. Internal to this
// room.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/contact/cord_contact.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/model/sector_model.h"

namespace netpocket {

class NeighbourWatch {
 public:
  // `whole`: the model of all sectors, with the state that it begins in. `sector` must outlive this object.
  NeighbourWatch(const Model& whole, const CableState& state, const CableElements& elements, const SectorModel& sector);

  // To be called when the sector has moved otherwise than by a step.
  void forget();

  struct Motion {
    double way;         // m, upper bound for any point of a cord since the last look
    double cord_speed;  // m/s, likewise
    double last_step, dt;
  };
  // To be called before each step, at the sector's present state. Why one sector cannot stand for all in this step;
  // nothing if it can.
  std::optional<std::string> look(const CableState& sector, const std::vector<double>& lengths, const Motion& motion);

 private:
  struct Copy {
    std::int32_t coordinate, of_sector;
    int turns;
  };

  void take_over(const CableState& sector, const std::vector<double>& lengths);
  double gap_of_far_sectors(const CableState& sector, const std::vector<double>& lengths) const;

  const SectorModel& sector_;
  SectorTurn turn_;
  Model model_;  // of two adjacent sectors
  CoordinateLayout layout_;
  CoordinateVectors coordinates_, velocities_;
  std::vector<Copy> copies_;
  std::vector<std::int32_t> element_of_sector_;  // by element of model_
  std::vector<double> lengths_;                  // m
  double gap_ = 0, way_ = 0;                     // m: gap_of_far_sectors, and the way since it was found
  ContactedCoordinates contacted_;
  std::unique_ptr<CordContact> contact_;
};

}  // namespace netpocket
