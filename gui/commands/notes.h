#pragma once
// Sentences on standard error about what came out otherwise than a user may think. They change no exit status.

#include <set>
#include <string>
#include <vector>

namespace netpocket {

// Files of an earlier drawing or export that stay beside the new ones: PREFIX, a number, SUFFIX.
void note_older_files(const std::string& folder, const std::string& prefix, const std::string& suffix,
                      const std::set<std::string>& new_files);

// Letters of labels and a title that no installed font has.
void note_missing_letters(std::vector<std::string> texts, const std::string& title = {});

}  // namespace netpocket
