#pragma once
// The numbers of the shown moment in large type, for an audience: time, phase, mouth, force, captured or not.
// Thread contract: the user interface's thread.

#include <QWidget>

#include "engine/analysis/verdict.h"
#include "gui/workbench/session/run.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;

namespace netpocket {

class Headline : public QWidget {
  Q_OBJECT
 public:
  explicit Headline(QWidget* parent = nullptr);

  // The run that is shown and which of its frames; null: the scenario `name`, not simulated yet.
  void show_run(const Run* run, std::size_t frame, const QString& name);
  void set_capture(Verdict captured);
  // Something small at the right end.
  void add_corner(QWidget* corner);
  // All that is written, in one line, e.g. for screen readers.
  QString text() const;

  // Letters become smaller where there is less room: it never makes the window wider.
  QSize minimumSizeHint() const override;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Tile {
    QLabel* caption;
    QLabel* value;
    QString widest;
  };

  Tile add_tile(const QString& caption, const QString& widest);
  static void show_value(const Tile& tile, const QString& value);
  void show_capture();
  void fit();
  void set_sizes(double scale);
  void follow_palette();

  QHBoxLayout* row_;
  QGridLayout* tiles_;
  QLabel* name_;
  QString whole_name_;
  Tile time_, phase_, mouth_, force_, capture_;
  Verdict captured_ = Verdict::unknown;
};

}  // namespace netpocket
