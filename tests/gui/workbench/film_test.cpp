// Pictures and videos of the window: what they show, and what becomes of them when something goes wrong.

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QProcess>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>

#include "gui/workbench/filming/film_actions.h"
#include "gui/workbench/filming/film_indicator.h"
#include "gui/workbench/filming/window_picture.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

QByteArray output_of(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  process.waitForFinished();
  return process.readAllStandardOutput();
}

struct Video {
  QSize size;
  int pictures = 0;
};

Video probe(const QString& path) {
  const QByteArray text = output_of("ffprobe", {"-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                                                "stream=width,height,nb_read_frames", "-of", "csv=p=0", path});
  const QList<QByteArray> fields = text.trimmed().split(',');
  if (fields.size() < 3) return {};
  return {{fields[0].toInt(), fields[1].toInt()}, fields[2].toInt()};
}

QImage last_picture(const QString& video) {
  const QString png = video + ".png";
  output_of("ffmpeg", {"-v", "error", "-y", "-sseof", "-0.2", "-i", video, "-update", "1", png});
  return QImage(png);
}

// Mean difference of the channels, 0 to 255, of two pictures of one size.
double difference(const QImage& a, const QImage& b) {
  EXPECT_EQ(a.size(), b.size());
  if (a.size() != b.size() || a.isNull()) return 255;
  double sum = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
    }
  }
  return sum / (3.0 * a.width() * a.height());
}

// The PATH without ffmpeg, or with another one.
class OtherPath {
 public:
  explicit OtherPath(const QString& path) : before_(qgetenv("PATH")) { qputenv("PATH", path.toUtf8()); }
  ~OtherPath() { qputenv("PATH", before_); }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;

 private:
  QByteArray before_;
};

class FilmTest : public WindowTest {
 protected:
  FilmTest() {
    window_->resize(1200, 700);
    QObject::connect(&film(), &WindowFilm::stopped, [this](const QString&, double seconds, const QString& why) {
      ended_ = true;
      seconds_ = seconds;
      why_ = why;
    });
    QObject::connect(&film(), &WindowFilm::failed, [this](const QString& reason) {
      ended_ = true;
      problem_ = reason;
    });
  }

  WindowFilm& film() const { return window_->film_actions().film(); }
  QAction* action(const QString& words) const {
    for (QAction* found : window_->findChildren<QAction*>()) {
      if (found->text().remove('&').contains(words)) return found;
    }
    return nullptr;
  }
  void record(const QString& name, int milliseconds = 400) {
    film().start(file(name), 25);
    QTest::qWait(milliseconds);
  }
  bool wait_for_end() {
    return wait_until([this] { return ended_; }, 60);
  }
  QStringList left_overs() const {
    return QDir(folder_.path()).entryList({"*.mp4*", ".*mp4*"}, QDir::AllEntries | QDir::Hidden);
  }

  bool ended_ = false;
  double seconds_ = 0;
  QString why_, problem_;
};

TEST_F(FilmTest, APictureHasTheWholeWindow) {
  ASSERT_TRUE(wait_for_picture());
  const QImage picture = window_picture(*window_);
  EXPECT_EQ(picture.size(), (QSizeF(window_->size()) * window_->devicePixelRatioF()).toSize());
  // The view is in it, whichever way it is drawn, under its overlay.
  const Viewport& view = window_->viewport();
  const QPoint at = view.mapTo(window_.get(), QPoint());
  const QImage part = picture.copy(QRect(at, view.size())).convertToFormat(QImage::Format_RGB32);
  EXPECT_LT(difference(part, window_->viewport().picture().convertToFormat(QImage::Format_RGB32)), 2);
  // What was painted last is the same as what is painted anew, but for the pointer.
  EXPECT_LT(difference(window_frame(*window_), picture), 0.2);
}

TEST_F(FilmTest, MenusOverTheWindowAreInThePicture) {
  QMenu menu(window_.get());
  menu.addAction("something that is asked");
  const QImage before = window_picture(*window_);
  menu.popup(window_->mapToGlobal(QPoint(300, 200)));
  ASSERT_TRUE(wait_until([&] { return menu.isVisible(); }));
  const QImage over = window_picture(*window_);
  EXPECT_NE(before.copy(300, 200, menu.width(), menu.height()), over.copy(300, 200, menu.width(), menu.height()));
  menu.close();
}

TEST_F(FilmTest, TheVideoLastsAsLongAsTheFilmingAndShowsTheWindow) {
  ASSERT_TRUE(wait_for_picture());
  record("film.mp4", 1500);
  film().stop();
  EXPECT_TRUE(film().is_active());
  EXPECT_FALSE(film().is_filming());
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(problem_, "");
  const Video video = probe(file("film.mp4"));
  EXPECT_EQ(video.pictures, static_cast<int>(std::lround(25 * seconds_)));
  EXPECT_GE(seconds_, 1.5);
  EXPECT_EQ(video.size, window_picture(*window_).size());
  EXPECT_LT(difference(last_picture(file("film.mp4")), window_frame(*window_)), 4);
  EXPECT_EQ(left_overs().filter("film").size(), 2);  // with the picture taken out of it
}

TEST_F(FilmTest, AWindowThatChangesItsSizeFitsIn) {
  const QSize size = window_picture(*window_).size();
  record("film.mp4");
  window_->resize(1501, 655);
  QTest::qWait(300);
  window_->resize(1400, 900);
  QTest::qWait(300);
  film().stop();
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(problem_, "");
  EXPECT_EQ(probe(file("film.mp4")).size, size);
}

TEST_F(FilmTest, TellsThatItIsRecordingAndStops) {
  const auto* indicator = window_->statusBar()->findChild<FilmIndicator*>();
  ASSERT_NE(indicator, nullptr);
  EXPECT_FALSE(indicator->isVisible());
  record("film.mp4");
  EXPECT_TRUE(indicator->isVisible());
  EXPECT_TRUE(wait_until([&] { return indicator->text() == "Recording 0:01"; })) << indicator->text().toStdString();
  // Messages of the status bar leave it in sight.
  window_->statusBar()->showMessage("something else");
  EXPECT_TRUE(indicator->isVisible());
  ASSERT_NE(action("Stop recording"), nullptr);
  indicator->findChild<QToolButton*>()->click();
  ASSERT_TRUE(wait_for_end());
  EXPECT_FALSE(indicator->isVisible());
  EXPECT_NE(action("Record the window"), nullptr);
  EXPECT_EQ(length_words(65), "1:05");
  EXPECT_EQ(length_words(3661), "1:01:01");
}

TEST_F(FilmTest, WithoutFfmpegOneSentence) {
  const OtherPath path("/nowhere");
  film().start(file("film.mp4"), 25);
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(problem_.contains("ffmpeg is not installed")) << problem_.toStdString();
  EXPECT_EQ(window_->notice(), problem_);
  EXPECT_FALSE(film().is_active());
  EXPECT_TRUE(left_overs().isEmpty());
}

TEST_F(FilmTest, AFailingEncoderLeavesTheEarlierFile) {
  write_file("ffmpeg", "#!/bin/sh\n/usr/bin/head -c 4000000 >/dev/null\necho 'No space left on device' >&2\nexit 1\n");
  QFile::setPermissions(file("ffmpeg"), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  QFile(file("film.mp4")).open(QIODevice::WriteOnly);
  const OtherPath path(folder_.path());
  film().start(file("film.mp4"), 25);
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(problem_.contains("No space left on device")) << problem_.toStdString();
  EXPECT_EQ(left_overs(), QStringList{"film.mp4"});
  EXPECT_FALSE(film().is_active());
}

TEST_F(FilmTest, NoFolderOneSentence) {
  film().start(file("nowhere/film.mp4"), 25);
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(problem_.contains("film.mp4")) << problem_.toStdString();
}

TEST_F(FilmTest, EndsByItselfWhenTheDiskIsNearlyFull) {
  film().set_least_free(std::numeric_limits<qint64>::max());
  record("film.mp4", 300);
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(problem_, "");
  EXPECT_TRUE(why_.contains("nearly full")) << why_.toStdString();
  EXPECT_EQ(window_->notice(), why_);
  EXPECT_GE(probe(file("film.mp4")).pictures, 20);
}

TEST_F(FilmTest, ClosingTheWindowFinishesTheVideoFirst) {
  record("film.mp4");
  EXPECT_FALSE(window_->close());
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(wait_until([this] { return !window_->isVisible(); }));
  EXPECT_GE(probe(file("film.mp4")).pictures, 10);
}

TEST_F(FilmTest, AWindowThatGoesFinishesTheVideo) {
  record("film.mp4");
  window_.reset();
  EXPECT_GE(probe(file("film.mp4")).pictures, 10);
}

TEST_F(FilmTest, ProposesANameThatIsNotTaken) {
  write_file("mine.toml", "name = \"mine\"\n");
  write_file("mine_window.mp4", "");
  window_->open(file("mine.toml"));
  QString proposed;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      proposed = dialog->selectedFiles().value(0);
      dialog->reject();
    }
  });
  timer.start(20);
  action("Record the window")->trigger();
  EXPECT_EQ(QFileInfo(proposed).fileName(), "mine_window_2.mp4");
  EXPECT_FALSE(film().is_active());
}

TEST_F(FilmTest, APictureThatCannotBeWrittenIsToldOf) {
  const QImage picture = window_picture(*window_);
  EXPECT_EQ(window_->film_actions().save_picture(picture, file("window.png")), std::nullopt);
  EXPECT_LT(difference(QImage(file("window.png")), picture), 1e-9);
  const auto refusal = window_->film_actions().save_picture(picture, file("nowhere/window.png"));
  ASSERT_TRUE(refusal.has_value());
  EXPECT_TRUE(refusal->contains("window.png"));
}

QImage plain(int width, int height, const QColor& colour) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(colour);
  return image;
}

TEST(FilmWriter, PicturesStandUntilTheNextOne) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("film.mp4");
  FilmEnd end;
  {
    FilmWriter writer(path.toStdString(), {64, 48, 25, Qt::gray}, [&](const FilmEnd& result) { end = result; });
    EXPECT_TRUE(writer.add(plain(64, 48, Qt::red), 0));
    EXPECT_TRUE(writer.add(plain(64, 48, Qt::blue), 10));
    writer.finish(30);
  }
  EXPECT_EQ(end.problem, "");
  EXPECT_DOUBLE_EQ(end.seconds, 1.2);
  EXPECT_EQ(probe(path).pictures, 30);
}

TEST(FilmWriter, PicturesOfAnotherShapeStandInTheMiddle) {
  const FilmFormat format{100, 60, 25, Qt::green};
  EXPECT_EQ(fit_picture(plain(100, 60, Qt::red), format).pixelColor(0, 0), QColor(Qt::red));
  const QImage tall = fit_picture(plain(60, 120, Qt::red), format);
  EXPECT_EQ(tall.size(), QSize(100, 60));
  EXPECT_EQ(tall.pixelColor(20, 30), QColor(Qt::green));
  EXPECT_EQ(tall.pixelColor(50, 30), QColor(Qt::red));
  // An odd size is not blurred by stretching it.
  QImage odd = plain(99, 59, Qt::red);
  odd.setPixelColor(1, 0, Qt::black);
  EXPECT_EQ(fit_picture(odd, format).pixelColor(1, 0), QColor(Qt::black));
}

}  // namespace
}  // namespace netpocket
