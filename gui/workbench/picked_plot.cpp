#include "gui/workbench/picked_plot.h"

#include <utility>

#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/viewport/pick_description.h"

namespace netpocket {
namespace {

// Whether what is picked in one is the same thing in the other.
bool same_parts(const Structure& a, const Structure& b) {
  return &a == &b || (a.threads == b.threads && a.elements.size() == b.elements.size() &&
                      a.bodies.size() == b.bodies.size() && a.node_groups == b.node_groups);
}

}  // namespace

PickedPlot::PickedPlot(CaptureSession& session, PlotsPanel& plots, QObject* parent)
    : QObject(parent), session_(session), plots_(plots) {
  connect(&session_, &CaptureSession::current_changed, this, [this] {
    if (follows_ && session_.current()) show_run(session_.current()->id);
  });
  connect(&session_.runs(), &RunLibrary::frames_added, this, [this](RunId id) {
    if (id == run_) catch_up();
  });
  connect(&session_.runs(), &RunLibrary::run_removed, this, [this](RunId id) {
    if (id == run_ && !follows_) plots_.set_picked({});
  });
}

bool PickedPlot::plot(RunId id, const Pick& pick) {
  const Run* run = session_.runs().find(id);
  if (run == nullptr || run->frame_count() == 0) return false;
  follows_ = session_.current() == run;
  pick_ = pick;
  structure_ = run->structure;
  quantities_ = quantities_of(pick);
  const QString name = describe_pick(pick, *structure_, *run->first_frame).title;
  for (PickedQuantity& quantity : quantities_) quantity.title = QString("%1: %2").arg(name, quantity.title.toLower());
  bring_up_ = true;
  show_run(id);
  return true;
}

void PickedPlot::show_run(RunId id) {
  const Run* run = session_.runs().find(id);
  run_ = id;
  times_.clear();
  rows_.clear();
  if (run != nullptr && run->structure && !same_parts(*run->structure, *structure_)) {
    run_ = -1;
    plots_.set_picked({});
    return;
  }
  collect();
}

void PickedPlot::collect() {
  const Run* run = session_.runs().find(run_);
  if (run == nullptr || run->frame_count() == 0) return;
  collecting_ = true;
  session_.runs().collect(
      run_, [pick = *pick_, structure = run->structure](const Snapshot& f) { return values_of(pick, *structure, f); },
      [this, id = run_, pick = *pick_](const auto& times, const auto& rows) {
        // Something else may be plotted by now.
        if (id == run_ && pick == *pick_) take(times, rows);
      });
}

void PickedPlot::take(const std::vector<double>& times, const std::vector<std::vector<double>>& rows) {
  collecting_ = false;
  times_ = times;
  rows_ = rows;
  catch_up();
  if (std::exchange(bring_up_, false)) plots_.show_figure("picked");
}

// Frames that came since; those that have left the memory already are read with all the others.
void PickedPlot::catch_up() {
  const Run* run = session_.runs().find(run_);
  if (run == nullptr || collecting_) return;
  if (!same_parts(*run->structure, *structure_)) return show_run(run_);
  while (times_.size() < run->frame_count()) {
    const auto frame = session_.runs().frame_in_memory(run_, times_.size());
    if (!frame) return collect();
    times_.push_back(frame->time);
    rows_.push_back(values_of(*pick_, *run->structure, *frame));
  }
  show();
}

void PickedPlot::show() { plots_.set_picked(picked_panels(quantities_, times_, rows_)); }

}  // namespace netpocket
