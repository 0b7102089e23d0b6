#pragma once
// Asks where a panel's content is to be written.

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

// Does not wait: `write` is called with the path once it is chosen.
void ask_for_file(QWidget* parent, const FileQuestion& question, const std::function<void(const QString&)>& write);

}  // namespace netpocket
