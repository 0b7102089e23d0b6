#include "engine/scenario/toml_depth.h"

#include <algorithm>
#include <string>

namespace netpocket {
namespace {

// Length of the string literal at the start of `toml`, of any of TOML's four kinds.
std::size_t string_length(std::string_view toml) {
  const char quote = toml.front();
  const bool multiline = toml.size() >= 3 && toml[1] == quote && toml[2] == quote;
  const std::size_t width = multiline ? 3 : 1;
  const std::string end(width, quote);
  for (std::size_t i = width; i < toml.size(); ++i) {
    if (toml[i] == '\n' && !multiline) return i;
    if (toml[i] == '\\' && quote == '"') {
      ++i;
    } else if (toml.substr(i, width) == end) {
      return i + width;
    }
  }
  return toml.size();
}

// Length of the token at the start of `toml`: a string, a comment, or one character.
std::size_t token_length(std::string_view toml) {
  if (toml.front() == '"' || toml.front() == '\'') return string_length(toml);
  if (toml.front() == '#') return std::min(toml.find('\n'), toml.size());
  return 1;
}

}  // namespace

int line_of_too_deep_key(std::string_view toml, int limit) {
  int line = 1;
  int dots = 0;
  while (!toml.empty()) {
    const std::size_t length = token_length(toml);
    const std::string_view token = toml.substr(0, length);
    if (token == ".") {
      if (++dots > limit) return line;
    } else if (length == 1 && std::string_view("=,[]{}\n").find(token) != std::string_view::npos) {
      dots = 0;
    }
    line += static_cast<int>(std::count(token.begin(), token.end(), '\n'));
    toml.remove_prefix(length);
  }
  return 0;
}

}  // namespace netpocket
