#pragma once
// A state that is complete: an object restored from its numbers goes on with the same bits.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace netpocket::test {

template <class Object>
std::vector<double> numbers_of(Object& object) {
  std::vector<double> numbers;
  object.visit_state([&](double& number) { numbers.push_back(number); });
  return numbers;
}

template <class Object>
void restore_numbers(Object& object, const std::vector<double>& numbers) {
  std::size_t next = 0;
  object.visit_state([&](double& number) { number = numbers.at(next++); });
  EXPECT_EQ(next, numbers.size());
}

// Calls step(object, i), which returns a number that depends on the state, for 40 values of i. Saves in between,
// restores a fresh copy of the object from the numbers, and compares. An object that is not restored must go on
// otherwise.
template <class Object, class Step>
void expect_resumes(const Object& fresh, const Step& step) {
  constexpr int kSaved = 23, kEnd = 40;
  const auto go_on = [&](Object& object) {
    std::vector<std::uint64_t> bits;
    for (int i = kSaved; i < kEnd; ++i) bits.push_back(std::bit_cast<std::uint64_t>(double{step(object, i)}));
    return bits;
  };
  Object original = fresh, restored = fresh, forgetful = fresh;
  for (int i = 0; i < kSaved; ++i) step(original, i);
  restore_numbers(restored, numbers_of(original));
  const std::vector<std::uint64_t> expected = go_on(original);
  EXPECT_EQ(go_on(restored), expected);
  EXPECT_NE(go_on(forgetful), expected);
}

}  // namespace netpocket::test
