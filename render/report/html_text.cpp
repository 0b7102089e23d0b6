#include "render/report/html_text.h"

#include <vtkBase64Utilities.h>

#include <nlohmann/json.hpp>

namespace netpocket {
namespace {

std::string utf8(std::string_view text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : utf8(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string data_url(std::string_view media_type, std::string_view bytes) {
  std::string encoded(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const auto* input = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = vtkBase64Utilities::Encode(input, static_cast<unsigned long>(bytes.size()),
                                               reinterpret_cast<unsigned char*>(encoded.data()));
  encoded.resize(size);
  return "data:" + std::string(media_type) + ";base64," + encoded;
}

}  // namespace netpocket
