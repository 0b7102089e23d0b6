#include "engine/dynamics/contact/contact_laws.h"

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

// Impact speed (m/s) that determines a contact's greatest depth. A faster impact is stopped there within one step.
constexpr double kSoftImpact = 10;
// Largest penetration of a cord's axis as a fraction of a solid's thickness, well before the opposite side becomes the
// nearer one.
constexpr double kThicknessPart = 0.25;

}  // namespace

ContactLaws::ContactLaws(const Model& model, std::int32_t body, const ContactSearch& search)
    : model_(&model), body_(body), damping_(restitution_damping(model.contact.restitution)) {
  for (const ContactPart& part : search.parts()) thickness_.push_back(part.thickness);
  set_steps({});
}

void ContactLaws::set_steps(const SpringSteps& steps) {
  steps_ = steps;
  laws_.assign(thickness_.size(), {});
  std::ranges::fill(has_rows_, std::uint8_t{0});
}

// The cord's mass at a place is that of half an element, or of a quarter at the end of a cord.
ContactLaw ContactLaws::make(std::int32_t element, std::int32_t part, bool is_cord_end, double body_mass) const {
  const CableMaterial& material = model_->material_of(element);
  const ModelBody& partner = model_->bodies[static_cast<std::size_t>(body_)];
  const double modulus = effective_modulus({material.youngs_modulus, material.poisson_ratio},
                                           {partner.youngs_modulus, partner.poisson_ratio});
  const double of_materials =
      hertz_stiffness(modulus, effective_radius(material.radius, contact_radius(partner.shape)));
  const double share = (is_cord_end ? 0.5 : 1.0) / ContactHolders::kHalves;
  const double length = share * model_->elements[static_cast<std::size_t>(element)].length;
  const double mass = effective_mass(material.section.mass_per_length * length, body_mass);
  const double stiffness = std::min(of_materials, resolved_stiffness(mass, steps_.present));
  const double softest = std::min(of_materials, resolved_stiffness(mass, steps_.reference));
  const double impact = depth_of_impact(mass, softest, kSoftImpact);
  return {{stiffness, damping_ * std::sqrt(stiffness * mass)},
          impact,
          material.radius + kThicknessPart * thickness_[static_cast<std::size_t>(part)],
          stiffness / of_materials,
          softest * impact * std::sqrt(impact)};
}

const ContactLaw& ContactLaws::of(std::int32_t element, std::int32_t part, bool is_cord_end, double body_mass) {
  std::vector<ContactLaw>& laws = laws_[static_cast<std::size_t>(part)];
  if (laws.empty()) laws.resize(2 * model_->elements.size());
  ContactLaw& law = laws[2 * static_cast<std::size_t>(element) + (is_cord_end ? 1 : 0)];
  if (law.law.stiffness == 0) law = make(element, part, is_cord_end, body_mass);
  return law;
}

const LawRows& ContactLaws::of_block(std::int32_t block, std::int32_t place, const ContactSearch& search,
                                     double body_mass) {
  const auto index = static_cast<std::size_t>(block * SphereTouches::kPlaces + place);
  if (index >= rows_.size()) {
    rows_.resize(index + 1);
    has_rows_.resize(index + 1, 0);
  }
  LawRows& rows = rows_[index];
  if (has_rows_[index] != 0) return rows;
  has_rows_[index] = 1;
  rows = {};
  const std::uint8_t* is_cord_end = search.sphere_touches().are_cord_ends(block, place);
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const std::int32_t element = block * kBlockSize + lane;
    if (!search.can_touch(element)) continue;
    const ContactLaw& law = of(element, 0, is_cord_end[lane] != 0, body_mass);
    rows.stiffness[lane] = law.law.stiffness;
    rows.damping[lane] = law.law.damping;
    rows.impact[lane] = law.impact;
    rows.deepest[lane] = law.deepest;
  }
  return rows;
}

}  // namespace netpocket
