#pragma once
// Gauss-Legendre rules on [-1, 1]. A rule with n points is exact for polynomials of degree 2n - 1.
// Abramowitz & Stegun (1964), table 25.4.

#include <array>

namespace netpocket {

struct QuadraturePoint {
  double xi;
  double weight;
};

inline constexpr std::array<QuadraturePoint, 3> kGauss3 = {{
    {-0.774596669241483377, 0.555555555555555556},
    {0.0, 0.888888888888888889},
    {0.774596669241483377, 0.555555555555555556},
}};

inline constexpr std::array<QuadraturePoint, 4> kGauss4 = {{
    {-0.861136311594052575, 0.347854845137453857},
    {-0.339981043584856265, 0.652145154862546143},
    {0.339981043584856265, 0.652145154862546143},
    {0.861136311594052575, 0.347854845137453857},
}};

inline constexpr std::array<QuadraturePoint, 5> kGauss5 = {{
    {-0.906179845938663993, 0.236926885056189088},
    {-0.538469310105683091, 0.478628670499366468},
    {0.0, 0.568888888888888889},
    {0.538469310105683091, 0.478628670499366468},
    {0.906179845938663993, 0.236926885056189088},
}};

}  // namespace netpocket
