#include "engine/base/diagnostics.h"

namespace netpocket {

std::string Diagnostic::text() const {
  std::string text = file;
  if (line > 0) text += (text.empty() ? "line " : ":") + std::to_string(line);
  for (const std::string& part : {key, message}) {
    if (part.empty()) continue;
    if (!text.empty()) text += ": ";
    text += part;
  }
  return text;
}

std::string Diagnostics::text() const {
  std::string text;
  for (const Diagnostic& diagnostic : list_) {
    if (!text.empty()) text += '\n';
    text += diagnostic.text();
  }
  return text;
}

}  // namespace netpocket
