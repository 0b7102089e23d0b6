// The rooms of the engine obey the map in engine/README.md: a file includes only what lies in its own room or below.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace netpocket {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = NETPOCKET_SOURCE_DIR;
// Lowest first, as the map says.
const std::vector<std::string> kRoomsOfDynamics = {"assembly", "contact", "ropes", "joints", "system", "stepping"};
const std::vector<std::string> kTop = {"engine", "render", "gui"};

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Lowest first.
std::vector<std::string> rooms_of_the_map() {
  std::vector<std::string> rooms;
  std::istringstream lines(text_of(kSource / "engine/README.md"));
  std::smatch match;
  bool is_map = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) is_map = line == "## Rooms";
    if (is_map && std::regex_search(line, match, std::regex("^\\| `([a-z]+)` \\|"))) rooms.push_back(match[1]);
  }
  std::ranges::reverse(rooms);
  return rooms;
}

struct Include {
  std::string file, included;
};

std::vector<fs::path> sources_under(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string suffix = entry.path().extension().string();
    if (suffix == ".h" || suffix == ".cpp") files.push_back(entry.path());
  }
  return files;
}

std::vector<Include> includes_under(const std::string& folder) {
  std::vector<Include> includes;
  const std::regex pattern("#include \"([^\"]+)\"");
  for (const fs::path& path : sources_under(kSource / folder)) {
    const std::string text = text_of(path);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      includes.push_back({fs::relative(path, kSource).generic_string(), (*it)[1]});
    }
  }
  return includes;
}

// Place of the first folder of `path` below `above` in `order`, or -1.
std::ptrdiff_t level(const std::string& path, const std::string& above, const std::vector<std::string>& order) {
  if (!path.starts_with(above)) return -1;
  const std::string rest = path.substr(above.size());
  const auto found = std::ranges::find(order, rest.substr(0, rest.find('/')));
  return found == order.end() ? -1 : found - order.begin();
}

void expect_no_include_points_up(const std::string& folder, const std::vector<std::string>& order) {
  const std::vector<Include> includes = includes_under(folder);
  std::size_t seen = 0;
  for (const Include& include : includes) {
    const std::ptrdiff_t from = level(include.file, folder, order), to = level(include.included, folder, order);
    EXPECT_GE(from, 0) << include.file << " lies in no room of the map";
    if (to < 0) continue;
    ++seen;
    EXPECT_LE(to, from) << include.file << " includes " << include.included;
  }
  EXPECT_GT(seen, 20);  // the pattern finds something
}

TEST(Rooms, MapNamesEveryFolder) {
  const std::vector<std::string> rooms = rooms_of_the_map();
  for (const auto& entry : fs::directory_iterator(kSource / "engine")) {
    if (!entry.is_directory()) continue;
    EXPECT_EQ(std::ranges::count(rooms, entry.path().filename().string()), 1) << entry.path();
  }
  for (const std::string& room : rooms) EXPECT_TRUE(fs::is_directory(kSource / "engine" / room)) << room;
}

TEST(Rooms, EngineIncludesPointDown) { expect_no_include_points_up("engine/", rooms_of_the_map()); }

TEST(Rooms, DynamicsIncludesPointDown) { expect_no_include_points_up("engine/dynamics/", kRoomsOfDynamics); }

TEST(Rooms, EngineUsesNeitherPicturesNorWindow) {
  for (const std::string& folder : kTop) {
    for (const Include& include : includes_under(folder)) {
      EXPECT_LE(level(include.included, "", kTop), level(include.file, "", kTop))
          << include.file << " includes " << include.included;
    }
  }
}

TEST(Rooms, FilesAreShort) {
  constexpr std::ptrdiff_t kMostLines = 500;
  for (const std::string& folder : kTop) {
    for (const fs::path& path : sources_under(kSource / folder)) {
      const std::string text = text_of(path);
      EXPECT_LE(std::ranges::count(text, '\n'), kMostLines) << path;
    }
  }
}

}  // namespace
}  // namespace netpocket
