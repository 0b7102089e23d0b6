#include "engine/recording/hdf5_support.h"

#include <string_view>
#include <tuple>

namespace netpocket {

namespace {

// Stops HDF5 from closing open files at exit. Such files were damaged during use, so that closing crashes, or must not
// be written any more. All others are closed before.
const herr_t kNoWorkAtExit = H5dont_atexit();

herr_t find_system_reason(unsigned, const H5E_error2_t* error, void* out) {
  constexpr std::string_view kMark = "error message = '";
  const std::string_view text = error->desc ? error->desc : "";
  const std::size_t mark = text.find(kMark);
  if (mark == std::string_view::npos) return 0;
  const std::string_view rest = text.substr(mark + kMark.size());
  *static_cast<std::string*>(out) = rest.substr(0, rest.find('\''));
  return 1;
}

}  // namespace

void silence_hdf5() {
  std::ignore = kNoWorkAtExit;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string hdf5_system_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_system_reason, &reason);
  return reason;
}

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  checked(H5Tset_size(type.get(), bytes), "make a text type");
  checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "make a text type");
  checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "make a text type");
  return type;
}

}  // namespace netpocket
