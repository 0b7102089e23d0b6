#pragma once
// A file that is written under a temporary name and gets its own when it is whole, so that what is interrupted leaves
// nothing.

#include <string>

namespace netpocket {

class WholeFile {
 public:
  // Nothing is created yet: write temporary_path(), then commit(). The temporary name keeps the extension.
  explicit WholeFile(std::string path);
  ~WholeFile();  // removes the temporary file unless committed
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::string& path() const { return path_; }
  const std::string& temporary_path() const { return temporary_path_; }
  // Replaces an existing file. Throws RenderError.
  void commit();

 private:
  std::string path_;
  std::string temporary_path_;
};

// Makes a folder and those above it. Throws RenderError.
void make_folder(const std::string& path);

}  // namespace netpocket
