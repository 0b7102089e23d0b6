#pragma once
// The standard normal distribution, with the same bits on every processor. Pure functions: any thread may call them.

namespace netpocket {

// Probability below x. Its relative error is below 1e-14 for x > -5 and grows with x^2, the rounding of which it
// contains, to 2e-13 at -37. 0 below -38.
double normal_cumulative(double x);

// Its inverse, to about 1e-15 of the result: Wichura (1988), Algorithm AS 241, PPND16, Appl. Statist. 37(3),
// doi:10.2307/2347330. -infinity at 0, infinity at 1; NaN outside.
double normal_quantile(double fraction);

}  // namespace netpocket
