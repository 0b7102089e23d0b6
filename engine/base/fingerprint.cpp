#include "engine/base/fingerprint.h"

#include <fmt/format.h>

#include <bit>

namespace netpocket {

Fingerprint& Fingerprint::add(std::string_view text) {
  for (const char c : text) add_byte(static_cast<unsigned char>(c));
  return *this;
}

Fingerprint& Fingerprint::add(std::span<const double> numbers) {
  for (const double number : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(bits >> shift));
  }
  return *this;
}

std::string Fingerprint::text() const { return fmt::format("{:016x}", value_); }

}  // namespace netpocket
