#include "gui/workbench/filming/film_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <exception>
#include <utility>

#include "gui/workbench/filming/film_indicator.h"
#include "gui/workbench/filming/window_picture.h"
#include "gui/workbench/panels/ask_for_file.h"
#include "render/output/png_file.h"

namespace netpocket {

FilmActions::FilmActions(QWidget* window, Choices choices)
    : QObject(window), window_(window), choices_(std::move(choices)), film_(*window) {
  connect(&film_, &WindowFilm::stopped, this, &FilmActions::film_stopped);
  connect(&film_, &WindowFilm::failed, this, [this](const QString& reason) {
    closing_ = false;
    emit problem(reason);
  });
}

void FilmActions::fill(QMenu& menu) {
  const auto add = [&](const QString& text, const QKeySequence& key, const QString& help) {
    auto* action = menu.addAction(text);
    action->setShortcut(key);
    action->setToolTip(QString("%1 (%2)").arg(help, key.toString(QKeySequence::NativeText)));
    action->setStatusTip(help);
    return action;
  };
  auto* picture = add(tr("Save p&icture of the window…"), Qt::CTRL | Qt::SHIFT | Qt::Key_W,
                      tr("Save the whole window as one sees it, as a PNG picture"));
  connect(picture, &QAction::triggered, this, &FilmActions::ask_for_picture);
  record_ = add(tr("Record the &window…"), Qt::CTRL | Qt::SHIFT | Qt::Key_R,
                tr("Make a video of the whole window until it is stopped"));
  connect(record_, &QAction::triggered, this, &FilmActions::start_or_stop);
  connect(&film_, &WindowFilm::state_changed, record_, [this] {
    record_->setText(film_.is_active() ? tr("Stop recording the &window") : tr("Record the &window…"));
    record_->setEnabled(film_.is_filming() || !film_.is_active());
  });
}

QString FilmActions::proposal(const QString& suffix) const {
  const QString stem = choices_.stem() + "_window";
  QString path = stem + suffix;
  for (int i = 2; QFileInfo::exists(path); ++i) path = QString("%1_%2%3").arg(stem).arg(i).arg(suffix);
  return path;
}

// What one sees when one asks, not what lies under the question.
void FilmActions::ask_for_picture() {
  const QImage picture = window_picture(*window_);
  const QString path =
      ask_for_path(window_, {tr("Save picture of the window"), proposal(".png"), tr("Pictures (*.png)"), "png"});
  if (path.isEmpty()) return;
  if (const auto refusal = save_picture(picture, path)) {
    emit problem(*refusal);
  } else {
    emit told(tr("Saved %1").arg(path));
  }
}

std::optional<QString> FilmActions::save_picture(const QImage& picture, const QString& path) const {
  try {
    write_png(to_image(picture), path.toStdString());
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
  return std::nullopt;
}

void FilmActions::start_or_stop() {
  if (film_.is_active()) return film_.stop();
  const QString path = ask_for_path(window_, {tr("Record the window"), proposal(".mp4"), tr("Videos (*.mp4)"), "mp4"});
  if (!path.isEmpty()) film_.start(path, choices_.rate());
}

void FilmActions::film_stopped(const QString& path, double seconds, const QString& why) {
  if (why.isEmpty()) {
    emit told(tr("Recorded %1 of the window: %2").arg(length_words(seconds), path));
  } else {
    emit problem(why);
  }
  if (std::exchange(closing_, false)) emit close_window();
}

bool FilmActions::may_close() {
  if (!film_.is_active()) return true;
  closing_ = true;
  film_.stop();
  return false;
}

}  // namespace netpocket
