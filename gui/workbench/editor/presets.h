#pragma once
// The scenarios that come with the program, built into it.

#include <QString>
#include <vector>

namespace netpocket {

struct Preset {
  QString name;         // "case1"
  QString description;  // one sentence
  QString text;         // TOML
};

// In the language of the window.
QString sentence_of(const Preset& preset);

// In the order of their names.
const std::vector<Preset>& presets();

}  // namespace netpocket
