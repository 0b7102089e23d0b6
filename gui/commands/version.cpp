#include "gui/commands/version.h"

#include <H5public.h>
#include <cairo.h>
#include <fmt/format.h>
#include <vtkVersion.h>

#include "commit.h"

namespace netpocket {

const char* program_version() { return NETPOCKET_VERSION; }
const char* program_commit() { return NETPOCKET_COMMIT; }

std::string version_text() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("netpocket {} ({})\nVTK {}\nHDF5 {}.{}.{}\nCairo {}", program_version(), program_commit(),
                     vtkVersion::GetVTKVersion(), major, minor, release, cairo_version_string());
}

}  // namespace netpocket
