#pragma once
// Faults of an input, each described in one sentence. They are values and never thrown.

#include <string>
#include <vector>

namespace netpocket {

struct Diagnostic {
  std::string file{};     // as the user named it; empty for command-line settings
  int line = 0;           // 1-based; 0 when it does not apply
  std::string key{};      // e.g. "net.diameter"; empty when it does not apply
  std::string message{};  // one sentence: what is wrong, what is allowed, the nearest valid name

  // "case1.toml:12: net.diameter: ..." without the parts that do not apply.
  std::string text() const;
};

class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }
  bool ok() const { return list_.empty(); }
  const std::vector<Diagnostic>& list() const { return list_; }
  // All diagnostics, one per line.
  std::string text() const;

 private:
  std::vector<Diagnostic> list_;
};

}  // namespace netpocket
