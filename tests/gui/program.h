#pragma once
// Runs the real program, with no display.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace netpocket {

struct ProgramResult {
  int exit_code = -1;    // 128 + signal when a signal ended it
  std::string out;       // standard output
  std::string error;     // standard error
  long peak_memory = 0;  // largest resident set, kB
};

// What a program finds around it.
struct Surroundings {
  std::string out = {};                       // a file that takes standard output; empty: the result has it
  std::string error = {};                     // likewise standard error
  std::vector<int> closed = {};               // of the standard streams
  std::vector<std::string> environment = {};  // "NAME=VALUE", besides or instead of what there is
  std::size_t largest_file = 0;               // bytes that it may write into a file; 0: any number
};

// A program that is running; at most one result may be waited for.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  ~RunningProgram();  // kills it when it was not waited for
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  void signal(int number) const;
  ProgramResult wait();

 private:
  pid_t process_ = -1;
  int out_ = -1, error_ = -1;  // unlinked files
};

ProgramResult run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

// A folder of its own that goes with the object.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  // Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  bool empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

// A scenario of the repository.
std::string scenario_file(const std::string& name);

// A recording of the first moments of case 1; short, because most tests make one.
std::string short_recording(const TestFolder& folder, const std::vector<std::string>& more = {});

}  // namespace netpocket
