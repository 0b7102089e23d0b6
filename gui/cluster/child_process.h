#pragma once
// Runs another program to its end and takes what it writes. Thread contract: any thread may call it.

#include <string>
#include <vector>

namespace netpocket {

struct ChildResult {
  bool is_found = true;  // false: there is no such program
  int exit_code = 0;     // 128 + signal if a signal ended it
  std::string out;
  std::string error;
};

// `words`: the program, looked for in PATH, and its arguments. Its standard input is empty. Throws FileError when the
// system cannot start any program.
ChildResult run_child(const std::vector<std::string>& words);

}  // namespace netpocket
