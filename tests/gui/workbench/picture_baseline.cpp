#include "tests/gui/workbench/picture_baseline.h"

#include <QDir>
#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

constexpr int kTolerance = 8;  // levels of 255
const QString kBaselines = NETPOCKET_SOURCE_DIR "/tests/baselines/workbench";

int largest_difference(QRgb a, QRgb b) {
  return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

// Black where they agree.
QImage difference_picture(const QImage& a, const QImage& b) {
  QImage picture(a.size(), QImage::Format_RGB32);
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const int difference = b.valid(x, y) ? largest_difference(a.pixel(x, y), b.pixel(x, y)) : 255;
      const int shown = std::min(255, 8 * difference);
      picture.setPixel(x, y, qRgb(shown, shown, shown));
    }
  }
  return picture;
}

}  // namespace

PictureDifference compare_pictures(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return {};
  std::size_t differing = 0;
  double squares = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      differing += largest_difference(p, q) > kTolerance ? 1 : 0;
      squares += std::pow(qRed(p) - qRed(q), 2) + std::pow(qGreen(p) - qGreen(q), 2) + std::pow(qBlue(p) - qBlue(q), 2);
    }
  }
  const double pixels = static_cast<double>(a.width()) * a.height();
  return {static_cast<double>(differing) / pixels, std::sqrt(squares / pixels / 3)};
}

bool is_same_picture(const PictureDifference& difference) {
  return difference.differing <= 1.0 / 2000 && difference.rms <= 1.5;
}

testing::AssertionResult matches_baseline(const QImage& actual, const QString& name) {
  const QString baseline_path = QDir(kBaselines).filePath(name + ".png");
  if (qEnvironmentVariableIntValue("NETPOCKET_RENEW") == 1) {
    QDir().mkpath(kBaselines);
    if (!actual.save(baseline_path))
      return testing::AssertionFailure() << "cannot write " << baseline_path.toStdString();
    return testing::AssertionSuccess();
  }
  const QImage baseline(baseline_path);
  const PictureDifference difference = compare_pictures(actual, baseline);
  if (is_same_picture(difference)) return testing::AssertionSuccess();
  const QDir folder(NETPOCKET_PICTURE_DIR);
  QDir().mkpath(folder.path());
  const QString actual_path = folder.filePath(name + "_actual.png");
  const QString difference_path = folder.filePath(name + "_difference.png");
  actual.save(actual_path);
  difference_picture(actual, baseline).save(difference_path);
  return testing::AssertionFailure() << name.toStdString() << ": " << 100 * difference.differing
                                     << " % of the pixels differ, RMS " << difference.rms << " levels\n  baseline   "
                                     << baseline_path.toStdString() << "\n  actual     " << actual_path.toStdString()
                                     << "\n  difference " << difference_path.toStdString()
                                     << "\n  NETPOCKET_RENEW=1 makes the baseline anew";
}

}  // namespace netpocket
