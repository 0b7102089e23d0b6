#pragma once
// Force laws of the contacts of cords with one body. Internal to ContactSolver. Theory: THEORY.md, section 6.
//
// Laws are made when they are first needed, and made again after the step that springs are for has changed.
//
// Thread contract: one thread at a time.

#include <cstdint>
#include <vector>

#include "engine/contact/force_law.h"
#include "engine/dynamics/contact/contact_search.h"
#include "engine/dynamics/contact/sphere_kernel.h"
#include "engine/model/model.h"

namespace netpocket {

// Force law of an element with a body.
struct ContactLaw {
  NormalLaw law;
  double impact;     // m, compression that no approach may pass
  double deepest;    // m, depth that no approach may pass
  double softening;  // stiffness / stiffness of the materials
  double largest;    // N, force of the softest spring at the compression `impact`
};

// The steps (s) that springs of contacts are for: the first one of the run, and the present one.
struct SpringSteps {
  double reference = 0, present = 0;
};

class ContactLaws {
 public:
  // `model` must outlive this object.
  ContactLaws(const Model& model, std::int32_t body, const ContactSearch& search);

  // Forgets all laws; the next ones are for these steps.
  void set_steps(const SpringSteps& steps);

  // `body_mass` (kg): smallest mass that any point of the body can have.
  const ContactLaw& of(std::int32_t element, std::int32_t part, bool is_cord_end, double body_mass);
  // Laws of the elements of a block at a place of SphereTouches. Lanes without an element that can touch are zero.
  const LawRows& of_block(std::int32_t block, std::int32_t place, const ContactSearch& search, double body_mass);

 private:
  ContactLaw make(std::int32_t element, std::int32_t part, bool is_cord_end, double body_mass) const;

  const Model* model_;
  std::int32_t body_;
  double damping_;                 // alpha of force_law.h
  std::vector<double> thickness_;  // m, by part of the body
  SpringSteps steps_;
  // By part, then by element and whether the place is at the end of its cord. Zero stiffness: not yet made.
  std::vector<std::vector<ContactLaw>> laws_;
  AlignedVector<LawRows> rows_;         // by block of elements and place
  std::vector<std::uint8_t> has_rows_;  // likewise
};

}  // namespace netpocket
