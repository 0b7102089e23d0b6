#pragma once
// Runs trials in processes of their own, several at a time: one that crashes or hangs is a result like any other.

#include <functional>
#include <string>

namespace netpocket::test {

struct ChildResult {
  bool ended_well = false;  // the trial returned
  std::string text;         // what it returned; else why there is nothing: the signal that ended it, or the time
};

// What a trial found out; called in a process of its own.
using ChildTrial = std::function<std::string(int trial)>;
// Takes the results, in the order in which trials end; called in this process.
using ChildResultSink = std::function<void(int trial, const ChildResult&)>;

// Makes the trials first, first + 1, ... last, as many side by side as there are processors. Each may take this many
// seconds of processor time.
void run_in_children(int first, int last, unsigned seconds, const ChildTrial& trial, const ChildResultSink& sink);

}  // namespace netpocket::test
