// The fuzzers' corpus and random changes of it, with the compiler at hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/fuzz_targets.h"

namespace netpocket {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> corpus(const std::string& folder, const std::string& extension = "") {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(NETPOCKET_SOURCE_DIR "/" + folder)) {
    if (extension.empty() || entry.path().extension() == extension) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);  // the same order everywhere
  std::vector<Bytes> inputs;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return inputs;
}

// Changes, removes, doubles or inserts a few bytes.
Bytes mutated(Bytes bytes, std::mt19937& random) {
  for (unsigned i = 1 + random() % 4; i > 0 && !bytes.empty(); --i) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
    const auto end = at + static_cast<std::ptrdiff_t>(random() % std::min<std::size_t>(32, bytes.end() - at) + 1);
    switch (random() % 4) {
      case 0:
        *at = static_cast<std::uint8_t>(random());
        break;
      case 1:
        bytes.erase(at, end);
        break;
      case 2: {
        const Bytes piece(at, end);
        bytes.insert(at, piece.begin(), piece.end());
        break;
      }
      default:
        bytes.insert(at, static_cast<std::uint8_t>(random()));
    }
  }
  return bytes;
}

template <typename Target>
void replay(const std::vector<Bytes>& inputs, int mutations, Target target) {
  ASSERT_FALSE(inputs.empty());
  for (const Bytes& input : inputs) target(input);
  std::mt19937 random(1);
  for (int i = 0; i < mutations; ++i) target(mutated(inputs[random() % inputs.size()], random));
}

TEST(FuzzReplay, Scenario) {
  std::vector<Bytes> inputs = corpus("tests/fuzz/corpus/scenario");
  std::ranges::copy(corpus("scenarios", ".toml"), std::back_inserter(inputs));
  replay(inputs, 2000, fuzz_scenario);
}

TEST(FuzzReplay, Recording) {
  std::vector<Bytes> inputs = corpus("tests/fuzz/corpus/recording");
  replay(inputs, 500, fuzz_recording);
}

}  // namespace
}  // namespace netpocket
