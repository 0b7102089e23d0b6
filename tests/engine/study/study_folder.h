#pragma once
// A folder of its own for a test, with a study file in it.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/study/read_study.h"

namespace netpocket {

class StudyFolder {
 public:
  StudyFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "netpocket_study_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~StudyFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(file(name)).rdbuf();
    return text.str();
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }

  // The study of this text, which starts from case 1.
  StudyResult read(const std::string& study) const {
    const auto base = std::filesystem::relative(NETPOCKET_SOURCE_DIR "/scenarios/case1.toml", path_);
    write("study.toml", "base = \"" + base.string() + "\"\n" + study);
    return read_study_file(file("study.toml"));
  }

 private:
  std::filesystem::path path_;
};

}  // namespace netpocket
