#pragma once
// Texts that the window takes from the engine and from the scenarios that come with the program, to be translated.

#include <string>
#include <vector>

namespace netpocket {

struct GeneratedFile {
  std::string name;
  std::string text;
};

// What such files in gui/workbench/translations are to hold: lists for lupdate.
std::vector<GeneratedFile> generated_texts();

}  // namespace netpocket
