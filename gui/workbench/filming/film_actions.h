#pragma once
// Pictures and videos of the window itself, from the menu.
// Thread contract: the user interface's thread.

#include <QObject>
#include <functional>
#include <optional>

#include "gui/workbench/filming/window_film.h"

class QAction;
class QMenu;

namespace netpocket {

class FilmActions : public QObject {
  Q_OBJECT
 public:
  struct Choices {
    std::function<QString()> stem;  // folder and beginning of the names to propose
    std::function<int()> rate;      // pictures a second
  };

  FilmActions(QWidget* window, Choices choices);

  void fill(QMenu& menu);
  WindowFilm& film() { return film_; }
  // Why not, in one sentence, when it fails.
  [[nodiscard]] std::optional<QString> save_picture(const QImage& picture, const QString& path) const;
  // Whether the window may close as far as its video is concerned. False: the video is being finished, and
  // close_window() follows.
  bool may_close();

 signals:
  void problem(const QString& sentence);
  void told(const QString& sentence);
  void close_window();

 private:
  void ask_for_picture();
  void start_or_stop();
  void film_stopped(const QString& path, double seconds, const QString& why);
  // A path that is not taken yet.
  QString proposal(const QString& suffix) const;

  QWidget* window_;
  Choices choices_;
  WindowFilm film_;
  QAction* record_ = nullptr;
  bool closing_ = false;  // as soon as the video is whole
};

}  // namespace netpocket
