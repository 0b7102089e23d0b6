#pragma once
// Recordings that never change, whatever the engine computes: the made-up pocket closing on a target, and runs made
// from formulas for the figures.

#include <string>

#include "engine/bodies/shape.h"

namespace netpocket::pictures {

// Eleven frames from 0 to 10 s: the pocket closes, contacts push a target that drifts and turns. Scenario "made_up",
// closing until 7.5 s, towing from 9 s.
void write_pocket_recording(const std::string& path, const std::string& name = "made_up",
                            const Shape& target = Sphere{4.5});

// A run that diverged and was killed: one frame, cords flung away, no end. (The recorder refuses numbers that are not
// finite.)
void write_broken_recording(const std::string& path);

// Channels only, for figures: closing in `closing_time` s.
void write_series_recording(const std::string& path, const std::string& name, double closing_time);

// A run of one frame, in which nothing has happened.
void write_empty_series_recording(const std::string& path);

}  // namespace netpocket::pictures
