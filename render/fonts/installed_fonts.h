#pragma once
// The outline fonts of this machine, as Fontconfig lists them.

#include <fontconfig/fontconfig.h>

#include <memory>
#include <string>
#include <vector>

namespace netpocket {

using CharSet = std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)>;

struct InstalledFont {
  std::string family;
  std::string file;
  int weight = FC_WEIGHT_NORMAL;
  int slant = FC_SLANT_ROMAN;
  int width = FC_WIDTH_NORMAL;
  CharSet letters{nullptr, FcCharSetDestroy};

  bool has(FcChar32 letter) const { return FcCharSetHasChar(letters.get(), letter) == FcTrue; }
};

// In the order of their files. Rules of the machine or the user that put one font in another's place have no effect.
// Only the first face of a file: VTK opens no other. Any thread.
const std::vector<InstalledFont>& installed_fonts();

}  // namespace netpocket
