#pragma once
// What the engine says, in the language of the window. The engine speaks English and knows nothing of Qt: its sentences
// are recognised by engine_sentences.h. What is not recognised stays English.
// Thread contract: the user interface's thread.

#include <QString>
#include <string_view>

#include "engine/base/diagnostics.h"

namespace netpocket {

// A name or a sentence, also one with numbers and names in it: "panel 3 row 2".
QString engine_words(std::string_view utf8);
QString engine_words(const QString& text);

// As Diagnostic::text() and Diagnostics::text().
QString diagnostic_words(const Diagnostic& problem);
QString diagnostics_words(const Diagnostics& problems);

}  // namespace netpocket
