#pragma once
// What acts on slots besides the elements' internal forces: gravity and constant loads, and what each step adds to
// them. Most slots bear nothing: blocks of slots that do are marked, so that the others need not be read.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/dynamics/slot_state.h"

namespace netpocket {

class AppliedForces {
 public:
  explicit AppliedForces(std::int32_t slots)
      : forces_(slots),
        marks_(static_cast<std::size_t>(forces_.size() / kBlockSize), Mark::nothing),
        constant_marks_(marks_) {}

  // What acts always, N or N m. To be called before anything is added.
  void set_constant(SlotVectors constant) {
    constant_.reset();
    forces_ = std::move(constant);
    for (std::int32_t slot = 0; slot < forces_.size(); ++slot) {
      if (forces_.get(slot) != Eigen::Vector3d::Zero()) mark(slot) = Mark::constant;
    }
    constant_marks_ = marks_;
    const bool any = std::ranges::any_of(marks_, [](Mark mark) { return mark != Mark::nothing; });
    if (any) constant_ = forces_;
  }
  // Null where nothing acts always.
  const SlotVectors* constant() const { return constant_ ? &*constant_ : nullptr; }

  // Begins a step.
  void clear() {
    for (const std::int32_t first : touched_) {
      double* rows = forces_.data() + static_cast<std::ptrdiff_t>(first) * kSlotRows;
      if (constant_) {
        std::copy_n(constant_->rows().first + static_cast<std::ptrdiff_t>(first) * kSlotRows, kSlotRows * kBlockSize,
                    rows);
      } else {
        std::fill_n(rows, kSlotRows * kBlockSize, 0.0);
      }
      mark(first) = constant_marks_[static_cast<std::size_t>(first / kBlockSize)];
    }
    touched_.clear();
  }
  void add(std::int32_t slot, const Eigen::Vector3d& force) {
    if (mark(slot) != Mark::touched) {
      mark(slot) = Mark::touched;
      touched_.push_back(slot - slot % kBlockSize);
    }
    forces_.add(slot, force);
  }

  SlotRows rows() { return forces_.rows(); }
  // By block of slots: 0 where nothing acts.
  const std::uint8_t* loaded() const { return reinterpret_cast<const std::uint8_t*>(marks_.data()); }

 private:
  enum class Mark : std::uint8_t { nothing, constant, touched };
  Mark& mark(std::int32_t slot) { return marks_[static_cast<std::uint32_t>(slot) / kBlockSize]; }

  SlotVectors forces_;
  std::optional<SlotVectors> constant_;
  std::vector<Mark> marks_;            // by block of slots
  std::vector<Mark> constant_marks_;   // of what acts always
  std::vector<std::int32_t> touched_;  // first slots of blocks
};

}  // namespace netpocket
