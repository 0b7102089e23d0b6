#pragma once
// A directory of its own for the running test, so that tests may run side by side; emptied at the start, kept at the
// end to be looked at.

#include <gtest/gtest.h>

#include <filesystem>

namespace netpocket {

inline std::filesystem::path test_directory() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path directory =
      std::filesystem::path(testing::TempDir()) / "netpocket_figures" / test.test_suite_name() / test.name();
  std::filesystem::remove_all(directory);
  return directory;
}

}  // namespace netpocket
