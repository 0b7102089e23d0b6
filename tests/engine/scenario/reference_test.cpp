#include "engine/scenario/reference.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace netpocket {
namespace {

TEST(Reference, CommittedFileIsCurrent) {
  const std::string path = NETPOCKET_SOURCE_DIR "/scenarios/REFERENCE.md";
  if (std::getenv("NETPOCKET_RENEW")) std::ofstream(path) << parameter_reference();
  std::ifstream file(path);
  const std::string committed(std::istreambuf_iterator<char>(file), {});
  EXPECT_TRUE(committed == parameter_reference())
      << path << " is not what the parameter table says; renew it with NETPOCKET_RENEW=1 and this test";
}

}  // namespace
}  // namespace netpocket
