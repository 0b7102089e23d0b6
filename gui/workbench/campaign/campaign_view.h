#pragma once
// A campaign that runs or is done: how far it is, what it says so far, its captures on a map, and what can be done with
// one of them.
// Thread contract: the user interface's thread.

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "gui/workbench/campaign/campaign.h"

class QComboBox;
class QFrame;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace netpocket {

class CaptureMapView;
class StillFigure;

class CampaignView : public QWidget {
  Q_OBJECT
 public:
  explicit CampaignView(QWidget* parent = nullptr);

  // Must outlive the view or be replaced; null: none.
  void set_campaign(Campaign* campaign);
  // How many captures run at a time when the campaign goes on.
  void set_jobs(int jobs) { jobs_ = jobs; }

  CaptureMapView* map() const { return map_; }
  QComboBox* pictures() const { return pictures_; }
  QComboBox* x_axis() const { return x_axis_; }
  QComboBox* y_axis() const { return y_axis_; }
  QPushButton* stop_button() const { return stop_; }
  QPushButton* open_button() const { return open_; }
  QPushButton* adopt_button() const { return adopt_; }
  QPushButton* leave_button() const { return leave_; }
  // As shown.
  QString state_text() const;
  QString estimate_text() const;
  QString draft_text() const;
  QString point_text() const;

 signals:
  void open_requested(std::size_t row);   // run this capture in the window
  void adopt_requested(std::size_t row);  // its values become the scenario
  void leave_requested();                 // define or open another campaign

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_head();
  QWidget* make_chooser();
  QWidget* make_details();
  void refresh_state();
  void refresh_results();
  void offer_axes();
  void take_axes();
  void show_picture();
  void show_chosen();

  Campaign* campaign_ = nullptr;
  int jobs_ = 1;
  QLabel *name_, *state_, *estimate_, *drafts_;
  QProgressBar* progress_;
  QPushButton *stop_, *leave_;
  QComboBox *pictures_, *x_axis_, *y_axis_;
  QWidget* axes_;
  QStackedWidget* stack_;
  CaptureMapView* map_;
  StillFigure* figure_;
  QScrollArea* figure_frame_;
  QFrame* details_;
  QLabel* point_;
  QPushButton *open_, *adopt_;
  QTimer throttle_;
};

}  // namespace netpocket
