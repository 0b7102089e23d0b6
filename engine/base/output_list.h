#pragma once
// All that a command reads and writes, so that no output destroys an input, another output, or a file of another kind.
// Commands name everything here before they begin. Errors: OutputRefused with one sentence that names the option;
// FileError where nothing can be written (destination.h). Nothing is created.

#include <functional>
#include <string>
#include <vector>

#include "engine/base/destination.h"

namespace netpocket {

class OutputList {
 public:
  // With what standard output and standard error go to.
  OutputList();

  // Files that cannot be found are left to whoever reads them.
  void add_input(const std::string& path);
  // `option` is what the user gave the name with ("--sheet").
  void add(const std::string& option, const std::string& path, FileKind kind,
           ReadOnlyFiles read_only = ReadOnlyFiles::refused);
  // As add(), for the file that a command goes on with: an input, too.
  void add_continued(const std::string& option, const std::string& path, FileKind kind, ReadOnlyFiles read_only);
  // A folder in which files of some names will be written. It need not exist.
  void add_folder(const std::string& option, const std::string& path, std::function<bool(const std::string&)> is_ours);

 private:
  struct Input {
    std::string name;
    struct stat status;
  };
  struct Output {
    std::string option;
    Place place;
  };
  struct Folder {
    std::string option;
    std::string path;
    std::function<bool(const std::string&)> is_ours;
  };

  void require_no_input(const std::string& option, const Destination& destination) const;
  void require_no_output(const std::string& option, const Destination& destination) const;

  std::vector<Input> inputs_;
  std::vector<Output> outputs_;
  std::vector<Folder> folders_;
};

}  // namespace netpocket
