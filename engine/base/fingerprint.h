#pragma once
// Hash of texts and numbers, to see whether two are the same. It is not cryptographic.
// FNV-1a, 64 bits (Fowler, Noll & Vo; IETF RFC 9923).

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace netpocket {

class Fingerprint {
 public:
  Fingerprint& add(std::string_view text);
  Fingerprint& add(std::span<const double> numbers);  // their bits, lowest byte first

  std::uint64_t value() const { return value_; }
  std::string text() const;  // 16 hexadecimal digits

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace netpocket
