#include "tests/pictures/browser.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace netpocket::pictures {
namespace {

bool installed() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  char part[4096];
  while (pipe) {
    const auto count = std::fread(part, 1, sizeof part, pipe.get());
    if (count == 0) break;
    text.append(part, count);
  }
  return text;
}

// No name is resolved and no address reached; settings go to a folder of their own. Virtual time: what the page waits
// for is over before the document is written.
std::string command_line(const std::string& page, const std::string& picture, int width, int height) {
  return fmt::format(
      "timeout 240 chromium --headless --no-sandbox --disable-gpu --disable-background-networking "
      "--host-resolver-rules='MAP * ~NOTFOUND' --proxy-server=127.0.0.1:9 --user-data-dir='{}' "
      "--force-device-scale-factor=1 --hide-scrollbars --window-size={},{} --virtual-time-budget=20000 "
      "--screenshot='{}' --dump-dom 'file://{}' 2>/dev/null",
      std::filesystem::path(page).parent_path().string() + "/browser", width, height, picture, page);
}

}  // namespace

std::optional<std::string> open_in_browser(const std::string& page, const std::string& picture, int width, int height) {
  if (!installed()) return std::nullopt;
  return output_of(command_line(page, picture, width, height));
}

}  // namespace netpocket::pictures
