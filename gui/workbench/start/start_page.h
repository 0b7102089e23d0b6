#pragma once
// What one sees when the program opens without a file: ways to begin. It covers its parent below the menu bar.
// Thread contract: the user interface's thread.

#include <QFrame>

#include "gui/workbench/start/scenario_pictures.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace netpocket {

class StartPage : public QFrame {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* window);

  // Files that were used lately, the last one first; those that are gone are left out.
  void set_recent(const QStringList& paths);
  void open_page();
  void close_page();

  QListWidget* scenarios() const { return scenarios_; }
  QListWidget* recent() const { return recent_; }
  QPushButton* guide_button() const { return guide_; }

 signals:
  void guide_chosen();
  void new_chosen();
  void open_chosen();
  void file_chosen(const QString& path);
  void scenario_chosen(const QString& name);
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  QWidget* make_ways();
  QWidget* make_scenarios();
  void fill_scenarios();
  void draw_pictures();
  void fit_cards();
  void cover_window();

  QPushButton* guide_;
  QListWidget* recent_;
  QLabel* no_recent_;
  QListWidget* scenarios_;
  ScenarioPictures pictures_;
  int fitted_width_ = 0;  // of the list that the cards were made to fit
  bool drawn_ = false;
};

}  // namespace netpocket
