// The report as a reader sees it: opened in Chromium from a file, without a network.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>

#include "render/output/png_file.h"
#include "tests/gui/program.h"
#include "tests/pictures/browser.h"
#include "tests/pictures/made_up_recordings.h"
#include "tests/pictures/picture_comparison.h"

namespace netpocket::pictures {
namespace {

constexpr int kWidth = 1200, kHeight = 9000;  // pixels; longer than the page

// Writes into the document what the browser made of the page: of each figure its place and the natural size of what it
// shows, and requests that were made. Waits for the video's first picture.
constexpr const char* kProbe = R"(<script>
function probe() {
  let text = "";
  for (const figure of document.querySelectorAll("figure")) {
    const box = figure.firstElementChild.getBoundingClientRect();
    const media = figure.querySelector("img, video");
    const width = media ? media.naturalWidth || media.videoWidth : box.width;
    text += `[${figure.id} ${Math.round(box.left)} ${Math.round(box.top)} ${Math.round(box.width)} ` +
            `${Math.round(box.height)} ${Math.round(width)}]`;
  }
  const loaded = performance.getEntriesByType("resource").filter(entry => !entry.name.startsWith("data:")).length;
  document.body.dataset.probe = text + " loaded " + loaded + " height " + document.documentElement.scrollHeight;
}
window.addEventListener("load", probe);
for (const video of document.querySelectorAll("video")) video.addEventListener("loadeddata", probe);
</script>)";

struct Box {
  int left, top, width, height;
  int natural_width;  // of the picture or video, pixels
};

std::map<std::string, Box> figures_of(const std::string& document) {
  std::map<std::string, Box> figures;
  const std::regex figure(R"(\[(\w+) (-?\d+) (-?\d+) (\d+) (\d+) (\d+)\])");
  const auto start = document.find("data-probe=");
  if (start == std::string::npos) return figures;
  const std::string probe = document.substr(start, document.find(">", start) - start);
  for (std::sregex_iterator match(probe.begin(), probe.end(), figure), end; match != end; ++match) {
    const auto number = [&](std::size_t i) { return std::stoi((*match)[i]); };
    figures[(*match)[1]] = {number(2), number(3), number(4), number(5), number(6)};
  }
  return figures;
}

Image cut_out(const Image& image, const Box& box) {
  Image part{box.width, box.height, {}};
  for (int row = box.top; row < box.top + box.height; ++row) {
    const auto* from = image.rgb.data() + row * image.row_bytes() + 3 * static_cast<std::size_t>(box.left);
    part.rgb.insert(part.rgb.end(), from, from + part.row_bytes());
  }
  return part;
}

TEST(ReportPage, OpensInABrowserWithoutANetwork) {
  const TestFolder folder;
  const auto run = folder.file("case1.h5"), page = folder.file("report.html"), picture = folder.file("page.png");
  write_pocket_recording(run, "case1");
  const auto result = run_program({"report", run, "-o", page, "--fps", "2", "--backend", "osmesa", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  std::ofstream(page, std::ios::app) << kProbe;
  const auto document = open_in_browser(page, picture, kWidth, kHeight);
  if (!document) GTEST_SKIP() << "Chromium is not installed";

  EXPECT_NE(document->find(" loaded 0 height"), std::string::npos) << "the page asked for something";
  const auto shown = read_png(picture);
  ASSERT_EQ(shown.width, kWidth);
  const auto figures = figures_of(*document);
  EXPECT_EQ(figures.size(), 9u) << "sheet, video and seven figures";
  for (const char* name : {"sheet", "video", "figure03_closing", "figure05_force", "figure06_position", "energy"}) {
    EXPECT_TRUE(figures.contains(name)) << name;
  }
  for (const auto& [name, box] : figures) {
    EXPECT_GT(box.natural_width, 400) << name << " was not read";
    ASSERT_GT(box.height, 100) << name;
    ASSERT_LE(box.left + box.width, kWidth) << name << " leaves the page";
    ASSERT_LE(box.top + box.height, shown.height) << name;
    EXPECT_FALSE(is_blank(cut_out(shown, box))) << name << " is blank";
  }
  // As text, so that a reader can search for it.
  for (const char* part :
       {"Contact force on the target", ">F11</th>", "First contact", "[closing]", "Target captured"}) {
    EXPECT_NE(document->find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace netpocket::pictures
