#include "gui/workbench/control/loop_reading.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {
namespace {

struct LoopWords {
  Q_DECLARE_TR_FUNCTIONS(LoopReading)
};

std::vector<double> values_of(const std::vector<std::string>& names, const ChannelList& channels,
                              const std::vector<double>& values) {
  std::vector<double> found;
  for (const std::string& name : names) {
    const auto index = channels.find(name);
    if (index && *index < values.size()) found.push_back(values[*index]);
  }
  if (found.size() != names.size()) found.clear();
  return found;
}

QString unit_of(const std::vector<std::string>& names, const ChannelList& channels) {
  const auto index = names.empty() ? std::nullopt : channels.find(names.front());
  return index ? unit_words(channels[*index].unit) : QString();
}

}  // namespace

bool LoopReading::is_saturated() const {
  constexpr double kRounding = 1e-9;
  return load && *load >= 1 - kRounding;
}

LoopReading read_loop(const ControlLoopInfo& loop, const ChannelList& channels, const std::vector<double>& values) {
  LoopReading reading;
  const auto read = [&](const std::vector<std::string>& names) { return values_of(names, channels, values); };
  const auto first = [&](const std::vector<std::string>& names) -> std::optional<double> {
    const auto found = read(names);
    return found.empty() ? std::nullopt : std::optional(found.front());
  };
  constexpr double kLast = static_cast<double>(LoopState::jammed);
  if (const auto state = first(loop.state); state && *state >= 0 && *state <= kLast) {
    reading.state = static_cast<LoopState>(*state);
  }
  reading.set_point = read(loop.set_point);
  reading.actual = read(loop.actual);
  reading.error = read(loop.error);
  if (loop.error.empty() && reading.actual.size() == reading.set_point.size()) {
    reading.error = reading.actual;
    for (std::size_t i = 0; i < reading.error.size(); ++i) reading.error[i] -= reading.set_point[i];
  }
  reading.commanded = read(loop.commanded);
  reading.delivered = read(loop.delivered);
  reading.disturbance = read(loop.disturbance);
  reading.load = first(loop.load);
  reading.unit = unit_of(loop.actual, channels);
  reading.effort_unit = unit_of(loop.delivered, channels);
  // What does not act has no set point to be kept.
  if (reading.state && *reading.state != LoopState::active) {
    reading.set_point.clear();
    reading.error.clear();
  }
  return reading;
}

QString state_words(LoopState state) {
  switch (state) {
    case LoopState::waiting:
      return LoopWords::tr("waiting");
    case LoopState::active:
      return LoopWords::tr("active");
    case LoopState::over:
      return LoopWords::tr("over");
    case LoopState::off:
      return LoopWords::tr("off");
    case LoopState::jammed:
      break;
  }
  return LoopWords::tr("jammed");
}

QString short_number(double value, double largest) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  if (std::abs(value) < 1e-3 * largest || std::abs(value) < 1e-12) return QStringLiteral("0");
  return QString::number(value, 'g', 3).replace('-', QChar(0x2212));
}

double size_of(const std::vector<double>& vector) {
  double square = 0;
  for (const double component : vector) square += component * component;
  return std::sqrt(square);
}

}  // namespace netpocket
