#include <gtest/gtest.h>

#include <QDir>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>

#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "temporary_document.h"

namespace netpocket {
namespace {

// Leaves a recovery file as a crash would: the lock names a process that is gone.
void leave_behind(const QString& folder, const QString& path, const QString& text) {
  QProcess child;
  child.start("true", {});
  child.waitForStarted();
  const qint64 gone = child.processId();
  child.waitForFinished();
  RecoveryFile file(folder);
  ASSERT_TRUE(file.write(path, text));
  const QString name = QDir(folder).entryList({"*.recovery"}).front();
  const QByteArray content = read_file(folder + "/" + name);
  QFile copy(folder + "/crashed.recovery");
  ASSERT_TRUE(copy.open(QIODevice::WriteOnly));
  copy.write(content);
  QFile lock(copy.fileName() + ".lock");
  ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
  lock.write(QByteArray::number(gone) + "\nnetpocket\n" + QSysInfo::machineHostName().toUtf8() + "\n");
}

TEST(Recovery, IsWrittenWhileModifiedAndRemovedWhenClean) {
  TemporaryDocument document;
  const QDir folder(document.file("recovery"));
  document->autosave();
  EXPECT_TRUE(folder.entryList({"*.recovery"}).isEmpty()) << "nothing to lose";
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.0));
  document->autosave();
  EXPECT_EQ(folder.entryList({"*.recovery"}).size(), 1);
  EXPECT_FALSE(document->save_as(document.file("a.toml")));
  EXPECT_TRUE(folder.entryList({"*.recovery"}).isEmpty());
}

TEST(Recovery, IsRemovedOnACleanClose) {
  QTemporaryDir folder;
  {
    ScenarioDocument document(folder.path());
    EXPECT_FALSE(document.set_value(parameter("target.radius"), 4.0));
    document.autosave();
    EXPECT_FALSE(QDir(folder.path()).entryList({"*.recovery"}).isEmpty());
  }
  EXPECT_TRUE(QDir(folder.path()).entryList(QDir::Files).isEmpty());
}

TEST(Recovery, FilesOfLivingProgramsAreNotOffered) {
  TemporaryDocument document;
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.0));
  document->autosave();
  EXPECT_TRUE(document->lost_work().empty());
}

TEST(Recovery, OffersAndTakesOverWhatACrashLeft) {
  TemporaryDocument document;
  const QString path = document.write("mine.toml", "[target]\nradius = 4.0\n");
  leave_behind(document.file("recovery"), path, "[target]\nradius = 3.0 # unsaved\n");
  const auto found = document->lost_work();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].path, path);
  ASSERT_TRUE(document->recover(found[0]).ok());
  EXPECT_EQ(document->scenario().target.radius, 3.0);
  EXPECT_EQ(document->saved_scenario().target.radius, 4.0);
  EXPECT_EQ(document->path(), path);
  EXPECT_TRUE(document->is_modified());
  EXPECT_TRUE(document->lost_work().empty());
  EXPECT_FALSE(document->save());
  EXPECT_EQ(read_file(path), "[target]\nradius = 3.0 # unsaved\n");
  EXPECT_FALSE(document->is_modified());
}

TEST(Recovery, TheEditorOffersIt) {
  TemporaryDocument document;
  leave_behind(document.file("recovery"), "", "[target]\nradius = 3.0\n");
  ScenarioEditor editor(&*document);
  editor.offer_recovery();
  EXPECT_FALSE(editor.recovery_bar()->isHidden());
  EXPECT_TRUE(editor.recovery_bar()->text().contains("untitled"));
  editor.recovery_bar()->findChildren<QPushButton*>().front()->click();
  EXPECT_TRUE(editor.recovery_bar()->isHidden());
  EXPECT_EQ(document->scenario().target.radius, 3.0);
}

TEST(Recovery, DamagedFilesAreIgnored) {
  TemporaryDocument document;
  QDir().mkpath(document.file("recovery"));
  document.write("recovery/x.recovery", "{ not json");
  EXPECT_TRUE(document->lost_work().empty());
}

}  // namespace
}  // namespace netpocket
