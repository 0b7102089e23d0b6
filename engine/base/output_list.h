#pragma once
// List of all files that a command reads and writes. It ensures that no output destroys an input, another output, or a
// file of another kind. A command adds all its files before it begins. The functions throw OutputRefused, with one
// sentence that names the option, or FileError if nothing can be written (destination.h). They create nothing.

#include <functional>
#include <string>
#include <vector>

#include "engine/base/destination.h"

namespace netpocket {

class OutputList {
 public:
  // Contains the files to which standard output and standard error go, if any; outputs must not replace them.
  OutputList();

  // Ignores a file that does not exist: the function that reads it reports it.
  void add_input(const std::string& path);
  // `option`: the option with which the user gave the name, e.g. "--sheet".
  void add(const std::string& option, const std::string& path, FileKind kind,
           ReadOnlyFiles read_only = ReadOnlyFiles::refused);
  // As add(), but for a file that a command continues, which may be an input as well. The suffix is not checked.
  void add_continued(const std::string& option, const std::string& path, FileKind kind, ReadOnlyFiles read_only);
  // Adds a folder, which need not exist. `is_ours` tells whether a name is one of the files written there.
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
