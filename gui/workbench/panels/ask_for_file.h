#pragma once
// Asks where something is to be written.

#include <QString>
#include <functional>

class QWidget;

namespace netpocket {

struct FileQuestion {
  QString title;
  QString name;     // suggested
  QString filters;  // as QFileDialog's
  QString suffix;   // when none is typed
};

// Waits: the path chosen, or nothing. The suffix is part of it before anyone is asked whether to replace what is there.
QString ask_for_path(QWidget* parent, const FileQuestion& question);

// Does not wait: `write` is called with the path once it is chosen.
void ask_for_file(QWidget* parent, const FileQuestion& question, const std::function<void(const QString&)>& write);

}  // namespace netpocket
