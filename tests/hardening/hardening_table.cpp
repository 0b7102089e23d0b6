#include "tests/hardening/hardening_table.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace netpocket::test {
namespace {

constexpr const char* kPath = NETPOCKET_SOURCE_DIR "/tests/HARDENING.md";
constexpr const char* kHeader =
    "# Trials of robustness\n"
    "\n"
    "Written by the trials themselves: `./dev harden` makes them all (some hours of processor time), `./dev fuzz` the\n"
    "fuzzing. The test suite makes a few of each. The commit is the one the trial was made with.\n"
    "\n"
    "| trial | count | outcome | commit |\n"
    "| --- | --- | --- | --- |\n";

std::string output_of(const char* command) {
  std::string text;
  FILE* pipe = popen(command, "r");
  if (pipe == nullptr) return text;
  for (char line[128]; fgets(line, sizeof line, pipe) != nullptr;) text += line;
  pclose(pipe);
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

// The commit that is checked out, "-dirty" when files differ from it; the table itself always does.
std::string checked_out() {
  const std::string name = output_of("git -C " NETPOCKET_SOURCE_DIR " rev-parse --short HEAD 2>/dev/null");
  const std::string changes = output_of("git -C " NETPOCKET_SOURCE_DIR
                                        " status --porcelain --untracked-files=no -- ':/' ':!/tests/HARDENING.md' "
                                        "2>/dev/null");
  if (name.empty()) return "unknown";
  return changes.empty() ? name : name + "-dirty";
}

// Asked when the program starts: a trial lasts hours, in which somebody may work on.
const std::string commit = is_full_hardening() ? checked_out() : "";

// Rows by trial; lines that are no rows are passed over.
std::map<std::string, std::string> parse(const std::string& text) {
  std::map<std::string, std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(" | ");
    if (!line.starts_with("| ") || end == std::string::npos) continue;
    const std::string trial = line.substr(2, end - 2);
    if (trial != "trial" && trial != "---") rows[trial] = line;
  }
  return rows;
}

std::string read_table() {
  std::ifstream file(kPath);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

bool is_full_hardening() { return std::getenv("NETPOCKET_HARDENING") != nullptr; }

bool record_hardening(const HardeningRow& row) {
  if (!is_full_hardening()) return true;
  const int file = open(kPath, O_RDWR | O_CREAT, 0644);
  if (file < 0) return false;
  flock(file, LOCK_EX);
  auto rows = parse(read_table());
  rows[row.trial] = "| " + row.trial + " | " + row.count + " | " + row.outcome + " | " + commit + " |";
  std::string text(kHeader);
  for (const auto& [trial, line] : rows) text += line + "\n";
  const bool written = ftruncate(file, 0) == 0 && write(file, text.data(), text.size()) == std::ssize(text);
  close(file);
  return written;
}

}  // namespace netpocket::test
