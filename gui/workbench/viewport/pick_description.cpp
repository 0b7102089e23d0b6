#include "gui/workbench/viewport/pick_description.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "gui/workbench/panels/engine_words.h"
#include "render/scene/element_curve.h"

namespace netpocket {
namespace {

struct PickWords {
  Q_DECLARE_TR_FUNCTIONS(PickDescription)
};

QString quantity(double value, const char* unit) {
  // A value that is only rounding is shown as the zero it is.
  const double shown = std::abs(value) < 1e-12 ? 0 : value;
  return QString("%1 %2").arg(shown, 0, 'g', 4).arg(QString::fromUtf8(unit)).trimmed();
}

// All components to the same place: the third digit of the largest, but three to six decimals.
QString vector(const Eigen::Vector3d& v, const char* unit) {
  const double largest = v.cwiseAbs().maxCoeff();
  const int wanted = largest > 0 && std::isfinite(largest) ? 2 - static_cast<int>(std::floor(std::log10(largest))) : 3;
  const int decimals = largest < 5e-7 ? 3 : std::clamp(wanted, 3, 6);
  const double invisible = 0.5 * std::pow(10, -decimals);
  const auto number = [&](double x) { return QString::number(std::abs(x) < invisible ? 0 : x, 'f', decimals); };
  return QString("%1, %2, %3 %4").arg(number(v.x()), number(v.y()), number(v.z()), QString::fromUtf8(unit));
}

PickDescription describe_element(const Pick& pick, const Structure& structure, const Snapshot& snapshot) {
  const auto& element = structure.elements[static_cast<std::size_t>(pick.index)];
  const double f = pick.fraction;
  const Eigen::Vector3d velocity =
      (1 - f) * snapshot.velocities.col(element.node[0]) + f * snapshot.velocities.col(element.node[1]);
  PickDescription text{
      engine_words(structure.threads[static_cast<std::size_t>(element.thread)]),
      PickWords::tr("Element of %1, no. %2").arg(engine_words(structure.group_of(element).member)).arg(pick.index),
      {}};
  text.rows = {{PickWords::tr("Tension"), quantity(snapshot.tension[pick.index], "N")},
               {PickWords::tr("Strain"), quantity(snapshot.strain[pick.index], "")},
               {PickWords::tr("Length"), quantity(current_length(snapshot, element), "m")},
               {PickWords::tr("Position"), vector(*position_of(pick, structure, snapshot), "m")},
               {PickWords::tr("Velocity"), vector(velocity, "m/s")},
               {PickWords::tr("Speed"), quantity(velocity.norm(), "m/s")}};
  return text;
}

QString threads_through(std::int32_t node, const Structure& structure) {
  QStringList names;
  for (const auto& element : structure.elements) {
    if (element.node[0] != node && element.node[1] != node) continue;
    const QString name = engine_words(structure.threads[static_cast<std::size_t>(element.thread)]);
    if (!names.contains(name)) names << name;
  }
  constexpr qsizetype kMostNames = 3;
  if (names.size() > kMostNames) names = names.mid(0, kMostNames) << QString::fromUtf8("…");
  return names.join(", ");
}

PickDescription describe_node(const Pick& pick, const Structure& structure, const Snapshot& snapshot) {
  double tension = 0;
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const auto& nodes = structure.elements[i].node;
    if (nodes[0] != pick.index && nodes[1] != pick.index) continue;
    tension = std::max(tension, snapshot.tension[static_cast<Eigen::Index>(i)]);
  }
  const Eigen::Vector3d velocity = snapshot.velocities.col(pick.index);
  return {PickWords::tr("Node %1").arg(pick.index),
          threads_through(pick.index, structure),
          {{PickWords::tr("Largest tension"), quantity(tension, "N")},
           {PickWords::tr("Position"), vector(snapshot.positions.col(pick.index), "m")},
           {PickWords::tr("Velocity"), vector(velocity, "m/s")},
           {PickWords::tr("Speed"), quantity(velocity.norm(), "m/s")}}};
}

PickDescription describe_body(const Pick& pick, const Structure& structure, const Snapshot& snapshot) {
  const auto& body = structure.bodies[static_cast<std::size_t>(pick.index)];
  const auto& state = snapshot.bodies[static_cast<std::size_t>(pick.index)];
  int contacts = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const ContactPoint& contact : snapshot.contacts) {
    if (contact.body != pick.index) continue;
    ++contacts;
    force += contact.force;
  }
  return {engine_words(body.name),
          PickWords::tr("Rigid body, %1").arg(quantity(body.mass, "kg")),
          {{PickWords::tr("Centre of mass"), vector(state.position, "m")},
           {PickWords::tr("Velocity"), vector(state.velocity, "m/s")},
           {PickWords::tr("Spin"), vector(state.angular_velocity, "rad/s")},
           {PickWords::tr("Contacts"), QString::number(contacts)},
           {PickWords::tr("Contact force"), vector(force, "N")}}};
}

}  // namespace

PickDescription describe_pick(const Pick& pick, const Structure& structure, const Snapshot& snapshot) {
  switch (pick.kind) {
    case PickKind::node:
      return describe_node(pick, structure, snapshot);
    case PickKind::element:
      return describe_element(pick, structure, snapshot);
    case PickKind::body:
      break;
  }
  return describe_body(pick, structure, snapshot);
}

}  // namespace netpocket
