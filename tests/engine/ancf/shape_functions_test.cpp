// V1: shape functions, mass matrix, load weights.

#include "engine/ancf/shape_functions.h"

#include "element_checks.h"
#include "engine/ancf/mass.h"
#include "engine/ancf/quadrature.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationShapeFunctions : public VerificationTest {};
class VerificationMass : public VerificationTest {};

constexpr double kElementLength = 0.7;

TEST_F(VerificationShapeFunctions, InterpolateTheNodes) {
  const Eigen::Matrix4d unit = Eigen::Matrix4d::Identity();
  EXPECT_EQ(shape(-1, kElementLength), unit.col(0));
  EXPECT_EQ(shape(1, kElementLength), unit.col(2));
  EXPECT_LT((shape_p(-1, kElementLength) - unit.col(1)).norm(), 1e-15);
  EXPECT_LT((shape_p(1, kElementLength) - unit.col(3)).norm(), 1e-15);
}

TEST_F(VerificationShapeFunctions, ReproduceTranslationAndStraightLine) {
  double unity = 0, line = 0;
  for (double xi = -1; xi <= 1; xi += 0.125) {
    const NodalWeights s = shape(xi, kElementLength);
    unity = std::max(unity, std::abs(s[0] + s[2] - 1));
    line = std::max(line, std::abs(kElementLength * s[2] + s[1] + s[3] - kElementLength * (1 + xi) / 2));
  }
  expect_error_below("partition of unity", unity, 1e-15);
  expect_error_below("straight line", line, 1e-15);
}

TEST_F(VerificationShapeFunctions, DerivativesMatchDifferences) {
  double error = 0;
  const double L = kElementLength, h = 1e-3;
  for (double xi = -1; xi <= 1; xi += 0.25) {
    const auto by_xi = [&](auto f) { return derivative([&](double x) { return NodalWeights(f(x, L)); }, xi, h); };
    const auto by_L = [&](auto f) { return derivative([&](double x) { return NodalWeights(f(xi, x)); }, L, h); };
    for (const double difference : {(by_xi(shape) - shape_xi(xi, L)).norm(),            //
                                    (by_xi(shape_xi) - shape_xixi(xi, L)).norm(),       //
                                    (by_L(shape) - shape_L(xi)).norm(),                 //
                                    (by_L(shape_xi) - shape_xiL(xi)).norm(),            //
                                    (by_xi(shape) * 2 / L - shape_p(xi, L)).norm(),     //
                                    (by_xi(shape_p) * 2 / L - shape_pp(xi, L)).norm(),  //
                                    (by_L(shape_p) - shape_p_L(xi, L)).norm(),          //
                                    (by_L(shape_pp) - shape_pp_L(xi, L)).norm()}) {
      error = std::max(error, difference);
    }
  }
  // Differences of fourth order leave step^4 / 30 = 3e-14 of the fifth derivative, up to 720 * 6 / L^7 = 5e4.
  expect_error_below("derivatives of the shape functions", error, 1e-8);
}

TEST_F(VerificationMass, ConsistentMatrixIsTheIntegral) {
  Eigen::Matrix4d integral = Eigen::Matrix4d::Zero();
  NodalWeights load = NodalWeights::Zero();
  for (const auto& [xi, weight] : kGauss4) {
    const NodalWeights s = shape(xi, kElementLength);
    integral += weight * kElementLength / 2 * s * s.transpose();
    load += weight * kElementLength / 2 * s;
  }
  expect_error_below("mass matrix", relative_error(consistent_mass(3, kElementLength), 3 * integral), 1e-15);
  expect_error_below("load weights", relative_error(uniform_load(kElementLength), load), 1e-15);
}

TEST_F(VerificationMass, ConsistentMatrixHasThePublishedNumbers) {
  // Per rhoA L.
  const double L = 2;
  const Eigen::Matrix4d m = consistent_mass(1, L) / L;
  Eigen::Matrix4d published;
  published << 13. / 35, 11 * L / 210, 9. / 70, -13 * L / 420,  //
      11 * L / 210, L * L / 105, 13 * L / 420, -L * L / 140,    //
      9. / 70, 13 * L / 420, 13. / 35, -11 * L / 210,           //
      -13 * L / 420, -L * L / 140, -11 * L / 210, L * L / 105;
  expect_error_below("mass matrix against the published fractions", (m - published).norm(), 1e-15,
                     "verification case V1; round-off");
  EXPECT_EQ(m, m.transpose());
}

TEST_F(VerificationMass, LumpedMassScalesTheConsistentDiagonal) {
  const double L = kElementLength, m = 3;
  const NodalWeights lumped = lumped_mass(m, L), diagonal = consistent_mass(m, L).diagonal();
  EXPECT_DOUBLE_EQ(lumped[0] + lumped[2], m * L);
  const double scale = m * L / (diagonal[0] + diagonal[2]);
  expect_error_below("lumped mass", relative_error(lumped, NodalWeights(scale * diagonal)), 1e-15);
}

}  // namespace
}  // namespace netpocket
