#pragma once
// Unsaved work on disk, so that a crash loses seconds at most. Each open document keeps one file and holds a lock on
// it; a file whose lock nobody holds was left by a crash. Thread contract: one thread at a time per object.

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

namespace netpocket {

// What a crash left behind.
struct LostWork {
  QString file;        // the recovery file
  QString path;        // of the scenario; empty if it never had one
  QString text;        // TOML
  QDateTime saved_at;  // when it was last written
};

class RecoveryFile {
 public:
  explicit RecoveryFile(const QString& folder);
  ~RecoveryFile();  // removes the file: no crash
  RecoveryFile(const RecoveryFile&) = delete;
  RecoveryFile& operator=(const RecoveryFile&) = delete;

  // Replaces what was written before; false when the disk does not take it.
  bool write(const QString& path, const QString& text);
  void remove();

 private:
  QString folder_;
  QString file_;
  std::unique_ptr<QLockFile> lock_;
};

// Where recovery files of this user are.
QString default_recovery_folder();

// All recovery files in a folder whose program is gone, the newest first.
std::vector<LostWork> find_lost_work(const QString& folder);

// Removes the file and its lock, after it was recovered or when it is not wanted.
void forget(const LostWork& work);

}  // namespace netpocket
