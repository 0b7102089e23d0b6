#pragma once
// Where the session's recordings lie until they are saved. The folder is locked while the program lives and removed
// when it ends; a folder whose lock nobody holds was left by a crash, and its runs can be taken over. Thread contract:
// one thread at a time per object.

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

namespace netpocket {

// What a crash left behind.
struct LostRuns {
  QString folder;
  QStringList recordings;  // paths
  QDateTime written_at;    // of the latest
};

class RunFolder {
 public:
  // Makes a folder of its own in `parent`, or in the system's temporary folder when that cannot be written.
  explicit RunFolder(const QString& parent);
  ~RunFolder();  // removes it with all it holds
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const QString& path() const { return path_; }

 private:
  QString path_;
  std::unique_ptr<QLockFile> lock_;
};

// Folders in `parent` whose program is gone and that hold recordings, the newest first.
std::vector<LostRuns> find_lost_runs(const QString& parent);

// Removes the folder with what is still in it.
void forget(const LostRuns& runs);

}  // namespace netpocket
