#include "gui/workbench/session/run_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QUuid>
#include <algorithm>

namespace netpocket {
namespace {

const QString kPrefix = QStringLiteral("runs-");

// A lock of a living program is never stale, however old; that of a dead one always is.
std::unique_ptr<QLockFile> take_lock(const QString& folder) {
  auto lock = std::make_unique<QLockFile>(folder + ".lock");
  lock->setStaleLockTime(0);
  return lock->tryLock(0) ? std::move(lock) : nullptr;
}

}  // namespace

RunFolder::RunFolder(const QString& parent) {
  const QString name = kPrefix + QUuid::createUuid().toString(QUuid::WithoutBraces);
  for (const QString& place : {parent, QDir::tempPath() + "/netpocket"}) {
    path_ = QDir(place).filePath(name);
    if (!QDir().mkpath(place)) continue;
    // Locked before it is there, so that nobody takes it for a lost one.
    lock_ = take_lock(path_);
    if (lock_ && QDir().mkpath(path_)) return;
  }
}

RunFolder::~RunFolder() { QDir(path_).removeRecursively(); }

std::vector<LostRuns> find_lost_runs(const QString& parent) {
  std::vector<LostRuns> found;
  const QDir directory(parent);
  for (const QString& name : directory.entryList({kPrefix + "*"}, QDir::Dirs)) {
    LostRuns runs{directory.filePath(name), {}, {}};
    if (!take_lock(runs.folder)) continue;
    for (const QFileInfo& file : QDir(runs.folder).entryInfoList({"*.h5"}, QDir::Files, QDir::Name)) {
      runs.recordings << file.filePath();
      runs.written_at = std::max(runs.written_at, file.lastModified());
    }
    if (runs.recordings.isEmpty()) {
      forget(runs);
    } else {
      found.push_back(std::move(runs));
    }
  }
  std::ranges::sort(found, std::ranges::greater(), &LostRuns::written_at);
  return found;
}

void forget(const LostRuns& runs) { QDir(runs.folder).removeRecursively(); }

}  // namespace netpocket
