#pragma once
// How far two pictures are apart. Never by the largest difference: one edge pixel that falls the other way must not fail
// a test.

#include "render/output/image.h"

namespace netpocket::pictures {

struct PictureDifference {
  bool same_size = false;
  double beyond = 1;  // fraction of the pixels that differ by more than 3 % in a channel
  double rmse = 1;    // root mean square of the differences of all channels, 1: black and white
};

PictureDifference compare_pictures(const Image& actual, const Image& baseline);

// The same program and the same Mesa give the same bytes. Other processors have other vector widths: with
// LP_NATIVE_VECTOR_WIDTH=128 instead of 256, edges of the pictures here move on no more than 1 pixel in 10 000 and
// RMSE stays below 0.0006. The bounds leave room for that and stay well below the smallest thing to be seen, a missing
// label (test_comparison.cpp).
inline constexpr double kLargestBeyond = 5e-4;
inline constexpr double kLargestRmse = 4e-3;

bool equal_enough(const PictureDifference& difference);

// Nothing but the background's colour, that of the first pixel, on all but one in a thousand pixels.
bool is_blank(const Image& image);

// White where the pictures agree; the darker and the redder, the more they differ.
Image difference_picture(const Image& actual, const Image& baseline);

}  // namespace netpocket::pictures
