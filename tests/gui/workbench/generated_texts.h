#pragma once
// Texts that the window takes from the engine and from the scenarios that come with the program, to be translated.

#include <string>

namespace netpocket {

// What gui/workbench/translations/generated_texts.h is to hold: a list for lupdate.
std::string generated_texts();

}  // namespace netpocket
