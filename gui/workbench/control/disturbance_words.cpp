#include "gui/workbench/control/disturbance_words.h"

#include <QCoreApplication>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {
namespace {

QString words(const char* text) { return QCoreApplication::translate("netpocket::DisturbanceWords", text); }

}  // namespace

QString disturbance_words(const DisturbanceParameters& disturbance) {
  const bool torque = disturbance.torque != Eigen::Vector3d::Zero();
  const Eigen::Vector3d& vector = torque ? disturbance.torque : disturbance.force;
  Eigen::Index axis = 0;
  vector.cwiseAbs().maxCoeff(&axis);
  const QString body = disturbance.body == DisturbedBody::spacecraft ? words("the spacecraft") : words("the target");
  const QString along = torque ? words("about") : words("along");
  return words("%1 %2 %3 %4 on %5 for %6 s")
      .arg(number_words(vector[axis]), torque ? QStringLiteral("N\u202fm") : QStringLiteral("N"), along,
           QString("xyz"[axis]), body, number_words(disturbance.duration));
}

}  // namespace netpocket
