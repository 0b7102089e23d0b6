// Files that are whole or not there.
#include "engine/base/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace netpocket {
namespace {

namespace fs = std::filesystem;

class WholeFiles : public testing::Test {
 protected:
  WholeFiles() {
    std::string name = testing::TempDir() + "/whole-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~WholeFiles() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  fs::path folder_;
};

TEST_F(WholeFiles, AppearWhenTheyAreCommitted) {
  {
    WholeFile out(file("a.csv"), FileKind::csv);
    out.write("new");
    EXPECT_FALSE(fs::exists(file("a.csv")));
    out.commit();
    EXPECT_EQ(content(file("a.csv")), "new");
  }
  {
    WholeFile out(file("a.csv"), FileKind::csv);
    out.write("newer");
    EXPECT_EQ(content(file("a.csv")), "new");
  }
  EXPECT_EQ(content(file("a.csv")), "new");
  EXPECT_EQ(count(), 1u);
}

TEST_F(WholeFiles, GoWhereChainsOfLinksLead) {
  fs::create_directory(file("store"));
  fs::create_symlink("store/b", file("a"));
  fs::create_symlink(file("c.csv"), file("store/b"));  // and back, by an absolute one, to nothing yet
  write_whole_file(file("a"), FileKind::csv, "1");
  EXPECT_EQ(content(file("c.csv")), "1");
  EXPECT_TRUE(fs::is_symlink(file("a")));
  EXPECT_TRUE(fs::is_symlink(file("store/b")));
}

TEST_F(WholeFiles, OfAnotherKindStay) {
  std::ofstream(file("a.csv")) << "\x89HDF\r\n\x1a\n";
  EXPECT_THROW(write_whole_file(file("a.csv"), FileKind::csv, "1"), OutputRefused);
  EXPECT_EQ(content(file("a.csv")).size(), 8u);
}

TEST_F(WholeFiles, ThatDoNotFitLeaveTheOlderOne) {
  write_whole_file(file("a.csv"), FileKind::csv, "old");
  rlimit before = {};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit = {1000, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string message;
  try {
    write_whole_file(file("a.csv"), FileKind::csv, std::string(2000, 'x'));
  } catch (const FileError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(message, "cannot write \"" + file("a.csv") + "\": File too large");
  EXPECT_EQ(content(file("a.csv")), "old");
  EXPECT_EQ(count(), 1u);
}

}  // namespace
}  // namespace netpocket
