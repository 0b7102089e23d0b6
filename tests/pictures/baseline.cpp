#include "tests/pictures/baseline.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "render/output/contact_sheet.h"
#include "render/output/png_file.h"
#include "tests/pictures/picture_comparison.h"

namespace netpocket::pictures {
namespace {

namespace fs = std::filesystem;

std::string left_picture(const std::string& name, const char* what) {
  const auto folder = fs::path(NETPOCKET_PICTURE_DIR) / "baselines";
  fs::create_directories(folder);
  return (folder / (name + "_" + what + ".png")).string();
}

bool renewing() {
  const char* value = std::getenv("NETPOCKET_RENEW");
  return value && std::string(value) == "1";
}

// Leaves the pictures next to each other; says where.
std::string leave_comparison(const Image& actual, const Image& baseline, const std::string& name) {
  const auto difference = difference_picture(actual, baseline);
  std::string where;
  for (const auto& [what, image] :
       {std::pair{"actual", &actual}, std::pair{"baseline", &baseline}, std::pair{"difference", &difference}}) {
    write_png(*image, left_picture(name, what));
    where += "\n  " + left_picture(name, what);
  }
  SheetLayout layout;
  layout.caption_size = 14;
  const auto all = make_contact_sheet({{actual, "actual"}, {baseline, "baseline"}, {difference, "difference"}}, layout);
  write_png(all, left_picture(name, "comparison"));
  return where + "\n  " + left_picture(name, "comparison");
}

}  // namespace

void expect_like_baseline(const std::string& picture, const std::string& name) {
  const auto actual = read_png(picture);
  ASSERT_FALSE(is_blank(actual)) << picture << " is blank";
  const std::string file = std::string(NETPOCKET_SOURCE_DIR) + "/tests/baselines/" + name + ".png";
  if (renewing()) {
    fs::copy_file(picture, file, fs::copy_options::overwrite_existing);
    return;
  }
  if (!fs::exists(file)) {
    write_png(actual, left_picture(name, "actual"));
    FAIL() << "there is no baseline " << file << "; the picture is\n  " << left_picture(name, "actual")
           << "\nlook at it, then let NETPOCKET_RENEW=1 make it the baseline";
  }
  const auto baseline = read_png(file);
  const auto difference = compare_pictures(actual, baseline);
  if (equal_enough(difference)) return;
  FAIL() << (difference.same_size ? "" : "the size is another; ") << 100 * difference.beyond
         << " % of the pixels differ by more than 3 % (allowed: " << 100 * kLargestBeyond << " %), RMSE "
         << difference.rmse << " (allowed: " << kLargestRmse << ")" << leave_comparison(actual, baseline, name);
}

}  // namespace netpocket::pictures
