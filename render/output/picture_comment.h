#pragma once
// What a picture says about itself in its file, so that a later rendering can tell whether it is the one it wants.

#include <string>
#include <vector>

#include "render/output/run_renderer.h"

namespace netpocket {

class PictureComment {
 public:
  PictureComment(const std::vector<const Recording*>& recordings, const RunView& view);

  // Recordings, time and a fingerprint of their content and of every choice of the view: different pictures have
  // different comments.
  std::string at(double time) const;

 private:
  std::string names_;
  std::string fingerprint_;
};

}  // namespace netpocket
