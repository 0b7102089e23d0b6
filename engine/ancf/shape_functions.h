#pragma once
// Cubic Hermite shape functions of the gradient-deficient ANCF cable element:
//   r(p) = S1 r1 + S2 g1 + S3 r2 + S4 g2,  xi = (2p - p1 - p2)/L in [-1, 1],  L = p2 - p1 (m, material length),
// where p is the material coordinate. Gerstmayr & Shabana (2006), doi:10.1007/s11071-006-1856-1; Tang et al. (2023)
// Eq. 3, where the sign of the printed S3 is missing.

#include "engine/math/vector.h"

namespace netpocket {

NodalWeights shape(double xi, double length);       // S: r
NodalWeights shape_p(double xi, double length);     // dS/dp, 1/m and 1: the gradient r' = dr/dp
NodalWeights shape_pp(double xi, double length);    // d2S/dp2, 1/m^2 and 1/m: r''
NodalWeights shape_xi(double xi, double length);    // dS/dxi at fixed L
NodalWeights shape_xixi(double xi, double length);  // d2S/dxi2 at fixed L
NodalWeights shape_L(double xi);                    // dS/dL at fixed xi
NodalWeights shape_xiL(double xi);                  // d2S/(dxi dL)
NodalWeights shape_p_L(double xi, double length);   // d(dS/dp)/dL at fixed xi
NodalWeights shape_pp_L(double xi, double length);  // d(d2S/dp2)/dL at fixed xi

}  // namespace netpocket
