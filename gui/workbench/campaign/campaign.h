#pragma once
// A study's folder that the window shows: its results as they come in, whoever writes them, and the process that runs
// it if it was started here.
// Thread contract: the user interface's thread.

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <optional>
#include <semaphore>
#include <thread>

#include "engine/study/live_results.h"
#include "gui/workbench/campaign/campaign_job.h"

namespace netpocket {

class Campaign : public QObject {
  Q_OBJECT
 public:
  // `program`: that runs studies. `study`: the study's file; empty: as the folder says. The folder need not exist yet.
  Campaign(const QString& program, const QString& study, const QString& folder, QObject* parent = nullptr);
  ~Campaign() override;

  const QString& folder() const { return folder_; }
  // Empty when it is not known; then the study cannot go on here.
  QString study() const;
  QString name() const;
  // Nothing until the folder says what it holds.
  const std::optional<StudyManifest>& manifest() const { return manifest_; }
  // Null until then.
  const LiveResults* results() const { return results_.get(); }

  // Begins, or goes on.
  void start(int jobs);
  void stop();
  bool is_running() const { return job_.is_running(); }
  bool is_stopping() const { return job_.is_stopping(); }
  // Every point is there, or it ended early as it was told to.
  bool is_complete() const;
  // Another program writes into the folder.
  bool is_run_elsewhere() const { return elsewhere_; }

  // Of the captures since the start, or since the folder was opened; 0 until that can be told.
  double captures_a_minute() const;
  // Seconds; nothing until that can be told. A study that ends early takes less.
  std::optional<double> time_left() const;

  // Reads a row's record and makes its scenario, s. recorded_scenario().
  StudyScenario scenario_of(std::size_t row) const;

 signals:
  void changed();      // state or folder
  void points_came();  // to results()
  void failed(const QString& reason);

 private:
  using Batch = std::shared_ptr<const std::vector<FollowedRecord>>;

  // Batches that were read and not taken yet. More would only fill the memory.
  static constexpr std::ptrdiff_t kMostUnderWay = 2;

  void follow(const std::stop_token& stop);
  bool wait_for_room(const std::stop_token& stop);
  void take(const std::optional<StudyManifest>& manifest, const Batch& batch, bool is_written);

  QString program_, study_, folder_;
  std::optional<StudyManifest> manifest_;
  std::unique_ptr<LiveResults> results_;
  CampaignJob job_;
  bool ended_ = false;  // by itself
  bool elsewhere_ = false;
  bool has_caught_up_ = false;  // has read what was there at the start
  QElapsedTimer clock_;         // since the start
  std::size_t before_ = 0;      // points at the start
  double last_ = 0;             // s of the clock, when a point came last
  std::counting_semaphore<kMostUnderWay> room_{kMostUnderWay};
  std::jthread follower_;  // last: it is stopped before the rest goes
};

}  // namespace netpocket
