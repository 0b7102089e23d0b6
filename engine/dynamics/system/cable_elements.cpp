#include "engine/dynamics/system/cable_elements.h"

#include <cmath>

#include "engine/ancf/mass.h"
#include "engine/ancf/strain_pair.h"
#include "engine/dynamics/system/cable_state.h"

namespace netpocket {

CableElements::CableElements(const Model& model, ElementEvaluation evaluation, const TiedCoordinates* ties)
    : model_(model),
      ties_(ties),
      evaluation_(evaluation),
      layout_(layout_of(model)),
      batch_(initial_elements()),
      full_batch_(batch_.block_count()),
      ropes_(model, layout_),
      lengths_(model.elements.size()),
      wave_rate_(static_cast<std::size_t>(batch_.block_count()) * kBlockSize, 0.0),
      unpaired_rate_(wave_rate_),
      mass_(layout_.size(), 0.0),
      inverse_mass_(layout_.size(), 0.0),
      moving_mass_(layout_.size(), 0.0) {
  for (const CableMaterial& material : model.materials) {
    wave_speed_.push_back(std::sqrt(material.section.EA / material.section.mass_per_length));
  }
  for (std::size_t i = 0; i < model.elements.size(); ++i) set_length(i, model.elements[i].length);
  collect_mass();
}

std::vector<BatchElement> CableElements::initial_elements() const {
  std::vector<BatchElement> elements;
  elements.reserve(model_.elements.size());
  for (const ModelElement& e : model_.elements) {
    elements.push_back({{layout_.position(e.node1), layout_.gradient(e.gradient1), layout_.position(e.node2),
                         layout_.gradient(e.gradient2)},
                        e.length,
                        model_.materials[e.material].section,
                        false,
                        is_full() ? -1 : e.strain_partner});
  }
  for (const VariableRope& rope : model_.ropes) {
    for (const std::int32_t element : rope.elements) elements[element].variable = true;
  }
  return elements;
}

std::vector<BatchElement> CableElements::batch_elements() const {
  std::vector<BatchElement> elements = initial_elements();
  for (std::size_t i = 0; i < elements.size(); ++i) elements[i].length = lengths_[i];
  return elements;
}

void CableElements::set_length(std::size_t element, double length) {
  lengths_[element] = length;
  const double rate = wave_speed_[model_.elements[element].material] / length;
  wave_rate_[element] = rate * rate;
  if (model_.elements[element].strain_partner < 0) unpaired_rate_[element] = rate * rate;
}

void CableElements::collect_mass() {
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    mass_[layout_.position(static_cast<std::int32_t>(i))] = model_.nodes[i].point_mass;
  }
  for (const BatchElement& element : initial_elements()) {
    if (element.variable) continue;
    NodalWeights lump = lumped_mass(element.section.mass_per_length, element.length);
    if (element.strain_partner >= 0) move_from_middle(lump, ends_at_strain_partner(element));
    for (int corner = 0; corner < 4; ++corner) mass_[element.coordinate[corner]] += lump[corner];
  }
  for (const std::int32_t coordinate : ropes_.massive_coordinates()) mass_without_ropes_.push_back(mass_[coordinate]);
  update_ropes();
  for (std::int32_t coordinate = 0; coordinate < layout_.size(); ++coordinate) {
    if (!moves(coordinate) || mass_[coordinate] <= 0) continue;
    inverse_mass_[coordinate] = 1 / mass_[coordinate];
    moving_mass_[coordinate] = mass_[coordinate];
  }
  if (ties_ == nullptr) return;
  massive_ties_ = ties_->groups_with(ropes_.massive_coordinates());
  ties_->share_masses(ties_->groups(), mass_, inverse_mass_, moving_mass_);
}

// Whether the element's second node is the middle node of its pair.
bool CableElements::ends_at_strain_partner(const BatchElement& element) const {
  return element.coordinate[2] == coordinate(static_cast<std::size_t>(element.strain_partner), 0);
}

bool CableElements::moves(std::int32_t coordinate) const {
  if (coordinate < layout_.node_count) return model_.nodes[coordinate].support == Support::free;
  const std::int32_t gradient = coordinate - layout_.gradient(0);
  return gradient >= 0 && gradient < layout_.gradient_count && model_.gradients[gradient].support == Support::free;
}

void CableElements::update_ropes() {
  if (ropes_.empty() || !ropes_.refresh_spans()) return;
  for (std::size_t i = 0; i < mass_without_ropes_.size(); ++i) {
    mass_[ropes_.massive_coordinates()[i]] = mass_without_ropes_[i];
  }
  ropes_.update(batch_, mass_);
  for (const std::int32_t coordinate : ropes_.massive_coordinates()) {
    if (inverse_mass_[coordinate] == 0) continue;
    inverse_mass_[coordinate] = 1 / mass_[coordinate];
    moving_mass_[coordinate] = mass_[coordinate];
  }
  if (ties_ != nullptr) ties_->share_masses(massive_ties_, mass_, inverse_mass_, moving_mass_);
  for (std::int32_t rope = 0; rope < ropes_.rope_count(); ++rope) {
    for (const std::int32_t element : model_.ropes[rope].elements) {
      set_length(static_cast<std::size_t>(element), ropes_.element_length(rope));
      full_batch_.set_start_rate(element, ropes_.span_of(element)->start_rate);
    }
  }
}

BatchPower CableElements::forces(int first, int last, const CoordinateVectors& coordinates,
                                 const CoordinateVectors& velocities, double* rows) const {
  return is_full() ? full_batch_.forces(batch_, first, last, coordinates.rows(), velocities.rows(), rows)
                   : batch_.forces(first, last, coordinates.rows(), velocities.rows(), rows);
}

ElementCoordinates CableElements::gather(const CoordinateVectors& vectors, std::size_t element) const {
  ElementCoordinates q;
  for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(coordinate(element, corner));
  return q;
}

MaterialSpan CableElements::span(std::size_t element) const {
  const MaterialSpan* variable = ropes_.span_of(static_cast<std::int32_t>(element));
  return variable != nullptr ? *variable : MaterialSpan{.length = lengths_[element]};
}

CoordinateVectors CableElements::constant_loads() const {
  CoordinateVectors load(layout_.size());
  for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
    const ModelNode& node = model_.nodes[i];
    load.set(layout_.position(static_cast<std::int32_t>(i)), node.load + node.point_mass * model_.gravity);
  }
  for (const BatchElement& element : initial_elements()) {
    NodalWeights weight = uniform_load(element.length);
    if (element.strain_partner >= 0 && !element.variable) move_from_middle(weight, ends_at_strain_partner(element));
    for (int corner = 0; corner < 4; ++corner) {
      load.add(element.coordinate[corner], element.section.mass_per_length * weight[corner] * model_.gravity);
    }
  }
  return load;
}

}  // namespace netpocket
