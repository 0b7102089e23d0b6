#pragma once
// Compares pictures of the window with those of tests/baselines/workbench. NETPOCKET_RENEW=1 makes them anew: look at
// every one before it is committed.

#include <gtest/gtest.h>

#include <QImage>
#include <QString>

namespace netpocket {

struct PictureDifference {
  double differing = 1;  // fraction of the pixels that differ in a channel by more than 3 % of full scale
  double rms = 255;      // root of the mean square over all channels, levels of 255
};

// Pictures of different sizes differ everywhere.
PictureDifference compare_pictures(const QImage& a, const QImage& b);

// At most 1 pixel in 2000 may differ and 1.5 levels in the mean square: fonts are drawn with rounding that may differ
// between builds of the font library. A word that is missing is several times as much.
bool is_same_picture(const PictureDifference& difference);

// On failure the actual picture and the difference are written next to each other, and the message says where.
testing::AssertionResult matches_baseline(const QImage& actual, const QString& name);

}  // namespace netpocket
