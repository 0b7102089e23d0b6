#pragma once
// The holders of contact: the nodes and middles of elements, half an element apart. Where halves of elements are longer
// than the body is thick, holders are a quarter of an element apart. Otherwise one holder could have to bear at two
// edges of the body. Each holder has a weight that falls linearly from one at the holder to zero at its neighbours; the
// weights add up to one.
//
// Any thread may call const members.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace netpocket {

class ContactHolders {
 public:
  // Usual number of pieces of an element, between a node and the middle.
  static constexpr int kHalves = 2;

  // `next`: by element, the element that continues its cord, or -1. `pieces`: of an element, between its holders;
  // divides CordPolyline::kSegments.
  ContactHolders(std::span<const std::int32_t> next, int pieces);

  int pieces() const { return pieces_; }
  int capsules_of_a_piece() const;
  std::size_t count() const { return (static_cast<std::size_t>(pieces_) + 1) * next_.size(); }
  // `place`: of the element's holders, 0 to pieces(). Less than count(). Elements that continue each other share the
  // holder at their node.
  std::size_t index(std::int32_t element, int place) const;
  bool is_cord_end(std::int32_t element, int place) const;
  // The holders before and behind a holder on its cord; -1 for none.
  std::array<std::int32_t, 2> neighbours(std::int32_t holder) const;
  // Of a holder at a vertex of the capsules of a piece, 0 to capsules_of_a_piece(). `is_before`: whether the piece ends
  // at the holder; else it starts there.
  double weight_at(bool is_before, int vertex) const;

  std::span<const std::int32_t> next_elements() const { return next_; }
  std::span<const std::int32_t> previous_elements() const { return previous_; }

 private:
  std::vector<std::int32_t> next_, previous_;
  int pieces_;
};

}  // namespace netpocket
