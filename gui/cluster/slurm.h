#pragma once
// Slurm through its programs: sbatch submits, squeue tells what became of it. Only what studies need. Source: sbatch(1)
// and squeue(1) of Slurm 22.05. Thread contract: any thread may call these functions.

#include <stdexcept>
#include <string>
#include <vector>

namespace netpocket {

// Slurm is missing, cannot be reached, or refuses; what() is one sentence.
class SlurmError : public std::runtime_error {
 public:
  enum class Kind { unreachable, refused };
  SlurmError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

struct SlurmJob {
  std::string name;
  std::string command;          // of a shell
  std::string log;              // file, added to; "%a" stands for the number of the task
  std::vector<int> tasks;       // of an array, ascending; empty: one job
  std::string after;            // number of a job that must have ended first, whatever became of it
  std::string partition, time;  // as sbatch takes them; empty: as the cluster has them
};

// "1-3,7" of 1, 2, 3, 7.
std::string array_text(const std::vector<int>& tasks);

// Submits and returns the job's number. A task asks for one processor, may be put back into the queue by Slurm, and
// gets SIGTERM half a minute before its time is over.
std::string submit(const SlurmJob& job);

struct SlurmTask {
  int task = 0;        // of an array
  std::string state;   // "PENDING", "RUNNING", "FAILED", ...
  std::string reason;  // "None" when there is none

  // Whether it will still run or is running.
  bool is_alive() const;
};

// Tasks of an array job, also those that ended, as long as Slurm remembers them. Empty when it does not know the job.
std::vector<SlurmTask> tasks_of(const std::string& job);

}  // namespace netpocket
