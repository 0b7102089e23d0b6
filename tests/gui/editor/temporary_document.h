#pragma once
// A document whose recovery files live in a folder of its own.

#include <QFile>
#include <QTemporaryDir>

#include "gui/workbench/editor/scenario_document.h"

namespace netpocket {

class TemporaryDocument {
 public:
  ScenarioDocument* operator->() { return &document_; }
  ScenarioDocument& operator*() { return document_; }
  QString file(const QString& name) const { return folder_.filePath(name); }

  // Writes a file and gives its path.
  QString write(const QString& name, const QByteArray& bytes) const {
    QFile file(folder_.filePath(name));
    file.open(QIODevice::WriteOnly);
    file.write(bytes);
    return file.fileName();
  }

 private:
  QTemporaryDir folder_;
  ScenarioDocument document_{folder_.filePath("recovery")};
};

inline const Parameter& parameter(const char* key) { return *find_parameter(key); }

inline QByteArray read_file(const QString& path) {
  QFile file(path);
  file.open(QIODevice::ReadOnly);
  return file.readAll();
}

}  // namespace netpocket
