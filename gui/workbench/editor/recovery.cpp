#include "gui/workbench/editor/recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <optional>

namespace netpocket {
namespace {

const QString kExtension = QStringLiteral(".recovery");

QString lock_name(const QString& file) { return file + ".lock"; }

// A lock of a living program is never stale, however old; that of a dead one always is.
std::unique_ptr<QLockFile> take_lock(const QString& file) {
  auto lock = std::make_unique<QLockFile>(lock_name(file));
  lock->setStaleLockTime(0);
  return lock->tryLock(0) ? std::move(lock) : nullptr;
}

std::optional<LostWork> read(const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  const QJsonObject content = QJsonDocument::fromJson(file.readAll()).object();
  if (!content["text"].isString()) return std::nullopt;
  return LostWork{name, content["path"].toString(), content["text"].toString(), QFileInfo(name).lastModified()};
}

}  // namespace

RecoveryFile::RecoveryFile(const QString& folder)
    : folder_(folder), file_(QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + kExtension)) {}

RecoveryFile::~RecoveryFile() { remove(); }

bool RecoveryFile::write(const QString& path, const QString& text) {
  if (!QDir().mkpath(folder_)) return false;
  if (!lock_) lock_ = take_lock(file_);
  if (!lock_) return false;
  QSaveFile file(file_);
  if (!file.open(QIODevice::WriteOnly)) return false;
  const QByteArray content = QJsonDocument(QJsonObject{{"path", path}, {"text", text}}).toJson();
  return file.write(content) == content.size() && file.commit();
}

void RecoveryFile::remove() {
  QFile::remove(file_);
  lock_.reset();
}

QString default_recovery_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery";
}

std::vector<LostWork> find_lost_work(const QString& folder) {
  std::vector<LostWork> found;
  const QDir directory(folder);
  for (const QString& name : directory.entryList({"*" + kExtension}, QDir::Files)) {
    const QString file = directory.filePath(name);
    if (!take_lock(file)) continue;
    if (auto work = read(file)) found.push_back(std::move(*work));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.saved_at > b.saved_at; });
  return found;
}

void forget(const LostWork& work) {
  QFile::remove(work.file);
  QFile::remove(lock_name(work.file));
}

}  // namespace netpocket
