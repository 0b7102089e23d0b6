#include "gui/workbench/lost_runs_bar.h"

#include <QLocale>
#include <QPushButton>

namespace netpocket {

LostRunsBar::LostRunsBar(RunLibrary& runs, const QString& folder, QWidget* parent)
    : MessageBar(Tone::accent, parent), runs_(runs) {
  auto* recover_button = add_button(tr("Recover"));
  recover_button->setToolTip(tr("Add them to the runs of this session"));
  auto* discard_button = add_button(tr("Discard"));
  discard_button->setToolTip(tr("Delete them"));
  connect(recover_button, &QPushButton::clicked, this, &LostRunsBar::recover);
  connect(discard_button, &QPushButton::clicked, this, &LostRunsBar::discard);
  for (LostRuns& lost : find_lost_runs(folder)) lost_.push_back(std::move(lost));
  offer();
}

void LostRunsBar::offer() {
  if (lost_.empty()) return show_text({});
  const LostRuns& lost = lost_.front();
  const QString when = QLocale().toString(lost.written_at, QLocale::ShortFormat);
  const auto count = lost.recordings.size();
  show_text(count == 1 ? tr("A run that was not saved, of %1, was found.").arg(when)
                       : tr("%1 runs that were not saved, of %2, were found.").arg(count).arg(when));
}

void LostRunsBar::recover() {
  if (lost_.empty()) return;
  runs_.recover(lost_.front());
  lost_.pop_front();
  offer();
}

void LostRunsBar::discard() {
  if (lost_.empty()) return;
  forget(lost_.front());
  lost_.pop_front();
  offer();
}

}  // namespace netpocket
