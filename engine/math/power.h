#pragma once
// Logarithm and power that give the same bits on every processor, as elementary.h does, but computed with pairs of
// doubles. The result is the double nearest to the exact value, unless that is within 1e-12 of a unit in the last place
// of the middle between two doubles. A call takes some microseconds: use them in the set-up of a model, not in steps.
// Pure functions: any thread may call them.

namespace netpocket {

// Natural logarithm of a positive number. -infinity for 0, NaN for negative numbers.
double logarithm(double x);

// x^y for a positive finite x and a finite y; otherwise NaN.
double power(double x, double y);

}  // namespace netpocket
