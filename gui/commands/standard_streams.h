#pragma once
// Standard input, output and error as the program finds them: closed, full, or as they should be.

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace netpocket {

// Gives each of the three that is closed something that refuses to be used. Otherwise the next file that is opened,
// such as a recording, would become standard error, and messages would be written into it. The first thing in main().
void open_missing_streams();

// A sentence on standard error, after "netpocket: ". Nothing is thrown: whoever cannot be told is not told.
void say(std::string_view sentence);

// Text on standard output. Nothing is thrown; standard_output_failed() tells.
void print(std::string_view text);
// Whether something printed did not arrive, with the system's reason; to be asked at the end.
bool standard_output_failed(std::string& reason);

}  // namespace netpocket
