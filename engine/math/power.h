#pragma once
// Logarithm and powers that give the same bits on every processor, as elementary.h does, but computed with pairs of
// doubles: the result is the double nearest to the exact value but for cases that are nearer than 1e-12 of a unit in
// the last place to the middle of two. Some microseconds each: for the set-up of a model, not for steps.

namespace netpocket {

// Natural logarithm of a positive number; -infinity of 0, not a number below.
double logarithm(double x);

// x^y of a positive finite x, y finite; else not a number.
double power(double x, double y);

}  // namespace netpocket
