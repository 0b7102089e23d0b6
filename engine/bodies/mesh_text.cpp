#include "engine/bodies/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "engine/bodies/mesh_data.h"

namespace netpocket {
namespace {

constexpr std::string_view kBlank = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const auto last = text.find_last_not_of(kBlank);
  return last == text.npos ? std::string_view() : text.substr(0, last + 1);
}

}  // namespace

void require_room_for_triangles(std::size_t count) {
  if (count > kLargestTriangleCount) {
    throw MeshFileError(fmt::format("has more than the {} triangles that are allowed", kLargestTriangleCount));
  }
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

std::string_view plain_text(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    throw MeshFileError("is text in UTF-16, which mesh files are not: save it as UTF-8");
  }
  if (const auto zero = bytes.find('\0'); zero != bytes.npos) {
    throw MeshFileError(fmt::format("is not a text: byte {} is zero", zero + 1));
  }
  return bytes;
}

bool MeshWords::next_line() {
  while (line_.ends_with('\\') && !rest_.empty()) take_line();  // skips unread continuation lines
  if (rest_.empty()) return false;
  take_line();
  return true;
}

void MeshWords::take_line() {
  const auto end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ = rest_.substr(0, end);
  const bool two = rest_.substr(end).starts_with("\r\n");
  rest_ = rest_.substr(std::min(end + (two ? 2 : 1), rest_.size()));
  ++number_;
  line_ = line_.substr(0, line_.find(comment_));
  line_ = trimmed(line_);
}

std::string_view MeshWords::next() {
  for (;;) {
    const auto first = std::min(line_.find_first_not_of(kBlank), line_.size());
    line_ = line_.substr(first);
    if (line_ != "\\" || rest_.empty()) break;
    take_line();
  }
  auto last = std::min(line_.find_first_of(kBlank), line_.size());
  // A backslash at the end of the last word is a continuation mark, not part of the word.
  if (last == line_.size() && last > 1 && line_.back() == '\\') --last;
  const std::string_view word = line_.substr(0, last);
  line_ = line_.substr(last);
  return word;
}

std::string_view MeshWords::peek() {
  const std::string_view word = next();
  line_ = std::string_view(word.data(), word.size() + line_.size());
  return word;
}

void MeshWords::fail(const std::string& problem, int line) {
  throw MeshFileError(fmt::format("cannot be read: line {}: {}", line, problem));
}

double MeshWords::number() {
  const std::string_view word = next();
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) {
    fail("a coordinate is not a number");
  }
  return value;
}

Eigen::Vector3d MeshWords::vector() {
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

}  // namespace netpocket
