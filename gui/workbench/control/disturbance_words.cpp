#include "gui/workbench/control/disturbance_words.h"

#include <QCoreApplication>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {
namespace {

struct DisturbanceWords {
  Q_DECLARE_TR_FUNCTIONS(DisturbanceWords)
};

}  // namespace

QString disturbance_words(const DisturbanceParameters& disturbance) {
  const bool torque = disturbance.torque != Eigen::Vector3d::Zero();
  const Eigen::Vector3d& vector = torque ? disturbance.torque : disturbance.force;
  Eigen::Index axis = 0;
  vector.cwiseAbs().maxCoeff(&axis);
  const QString body = disturbance.body == DisturbedBody::spacecraft ? DisturbanceWords::tr("the spacecraft")
                                                                     : DisturbanceWords::tr("the target");
  const QString along = torque ? DisturbanceWords::tr("about") : DisturbanceWords::tr("along");
  return DisturbanceWords::tr("%1 %2 %3 %4 on %5 for %6 s")
      .arg(number_words(vector[axis]), torque ? QStringLiteral("N\u202fm") : QStringLiteral("N"), along,
           QString("xyz"[axis]), body, number_words(disturbance.duration));
}

}  // namespace netpocket
