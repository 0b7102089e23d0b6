#pragma once
// That the window is being recorded: a red dot, for how long, and a button that ends it. Hidden at other times.

#include <QWidget>

class QLabel;
class QToolButton;

namespace netpocket {

class WindowFilm;

class FilmIndicator : public QWidget {
  Q_OBJECT
 public:
  // The film must outlive the indicator.
  explicit FilmIndicator(WindowFilm& film, QWidget* parent = nullptr);

  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();
  void make_room();

  WindowFilm& film_;
  QLabel* label_;
  QToolButton* stop_;
};

// "1:05" for 65 s, "1:00:00" for an hour.
QString length_words(double seconds);

}  // namespace netpocket
