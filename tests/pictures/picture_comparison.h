#pragma once
// How far two pictures are apart. Never by the largest difference: one edge pixel that falls the other way must not
// fail a test.

#include "render/output/image.h"

namespace netpocket::pictures {

struct PictureDifference {
  bool same_size = false;
  double beyond = 1;  // fraction of the pixels that differ by more than 3 % in a channel
  double rmse = 1;    // root mean square of the differences of all channels, 1: black and white
};

PictureDifference compare_pictures(const Image& actual, const Image& baseline);

// The same program and the same Mesa give the same bytes, also with another width of vectors
// (LP_NATIVE_VECTOR_WIDTH=128 instead of 256). Other releases of Mesa and of the font library round edges and letters
// otherwise: the bounds leave room for 46 of the 153 600 pixels of a frame here, and stay below the smallest thing to
// be seen: a missing label changes 100 pixels, the rod that is hidden most 97 (comparison_test.cpp).
inline constexpr double kLargestBeyond = 3e-4;
inline constexpr double kLargestRmse = 4e-3;

bool equal_enough(const PictureDifference& difference);

// Nothing but the background's colour, that of the first pixel, on all but one in a thousand pixels.
bool is_blank(const Image& image);

// White where the pictures agree; the darker and the redder, the more they differ.
Image difference_picture(const Image& actual, const Image& baseline);

}  // namespace netpocket::pictures
