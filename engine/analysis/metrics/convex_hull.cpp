#include "engine/analysis/metrics/convex_hull.h"

#include <libqhull_r/qhull_ra.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>

namespace netpocket {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, FileCloser>;

// One computation. Qhull writes remarks into a file, here into none; it gives errors as an exit code.
class QhullRun {
 public:
  explicit QhullRun(Eigen::Matrix3Xd points) : points_(std::move(points)), sink_(std::fopen("/dev/null", "w")) {
    qh_zero(&qh_, sink_.get());
    char options[] = "qhull Qt Pp";
    failed_ = qh_new_qhull(&qh_, 3, static_cast<int>(points_.cols()), points_.data(), False, options, nullptr,
                           sink_.get()) != qh_ERRnone;
  }
  ~QhullRun() {
    int blocks = 0, bytes = 0;
    qh_freeqhull(&qh_, !qh_ALL);
    qh_memfreeshort(&qh_, &blocks, &bytes);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  std::optional<ConvexHull> hull() {
    if (failed_) return std::nullopt;
    qh_getarea(&qh_, qh_.facet_list);
    ConvexHull hull{qh_.totvol, qh_.totarea, {}};
    for (const facetT* facet = qh_.facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
      hull.planes.push_back({Eigen::Vector3d(facet->normal), facet->offset});
    }
    return hull;
  }

 private:
  Eigen::Matrix3Xd points_;
  OpenFile sink_;
  qhT qh_{};
  bool failed_ = false;
};

bool is_flat(const Eigen::Matrix3Xd& points) {
  constexpr double kFlat = 1e-9;  // of the points' spread across to that along
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred * centred.transpose(), Eigen::EigenvaluesOnly);
  return !(solver.eigenvalues()[0] > kFlat * kFlat * solver.eigenvalues()[2]);
}

}  // namespace

double ConvexHull::signed_distance(const Eigen::Vector3d& point) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes) largest = std::max(largest, plane.normal.dot(point) + plane.offset);
  return largest;
}

std::optional<ConvexHull> convex_hull(const Eigen::Matrix3Xd& points) {
  if (points.cols() < 4 || !points.allFinite() || is_flat(points)) return std::nullopt;
  return QhullRun(points).hull();
}

}  // namespace netpocket
