// What a file is, by its name and its first bytes.
#include "engine/base/file_kind.h"

#include <gtest/gtest.h>

namespace netpocket {
namespace {

TEST(FileKind, NamesOfOtherFormatsAreKnown) {
  EXPECT_FALSE(names_another_format(FileKind::png, "a.png"));
  EXPECT_FALSE(names_another_format(FileKind::png, "a.PNG"));
  EXPECT_FALSE(names_another_format(FileKind::png, "a"));
  EXPECT_FALSE(names_another_format(FileKind::recording, "run_0.5"));
  EXPECT_FALSE(names_another_format(FileKind::recording, "run.hdf5"));
  EXPECT_FALSE(names_another_format(FileKind::html, "a.htm"));
  EXPECT_FALSE(names_another_format(FileKind::png, "folder.jpg/a"));
  for (const char* name : {"a.jpg", "a.JPEG", "a.h5", "a.hdf5", "a.toml", "a.tar.gz", "a.svg"}) {
    EXPECT_TRUE(names_another_format(FileKind::png, name)) << name;
  }
  EXPECT_TRUE(names_another_format(FileKind::gltf, "a.gltf"));
  EXPECT_TRUE(names_another_format(FileKind::html, "a.pdf"));
  EXPECT_TRUE(names_another_format(FileKind::video, "a.mkv"));
}

TEST(FileKind, ContentIsReplacedByItsLike) {
  const std::string png = "\x89PNG\r\n\x1a\n....", hdf5 = "\x89HDF\r\n\x1a\n....",
                    view = "position = [1, 2, 3]\nfocal_point = [0, 0, 0]\n", svg = "<?xml version=\"1.0\"?>\n<svg>",
                    vtk = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">",
                    page = "\xEF\xBB\xBF\n<!DOCTYPE html>", scenario = "name = \"mine\"\n[net]\ndiameter = 0.004\n",
                    log = "2026-01-31 10:11:12 netpocket 0.1.0", video = std::string("\0\0\0\x20", 4) + "ftypisom",
                    notes = "my notes\n";
  const std::pair<FileKind, std::string> own[] = {{FileKind::png, png},
                                                  {FileKind::recording, hdf5},
                                                  {FileKind::view, view},
                                                  {FileKind::svg, svg},
                                                  {FileKind::vtp, vtk},
                                                  {FileKind::pvd, vtk},
                                                  {FileKind::vtkhdf, hdf5 + "VTKHDF"},
                                                  {FileKind::html, page},
                                                  {FileKind::log, log},
                                                  {FileKind::video, video},
                                                  {FileKind::csv, "time,length\n"},
                                                  {FileKind::markdown, "# Findings\n"},
                                                  {FileKind::json, "{\"a\": 1}"},
                                                  {FileKind::gltf, "glTF\2"},
                                                  {FileKind::pdf, "%PDF-1.5"},
                                                  {FileKind::stl, "solid cube\nfacet normal 0 0 1\n"},
                                                  {FileKind::stl, "netpocket" + std::string(71, ' ') + "\1"},
                                                  {FileKind::findings, "F1   The contact force\n"},
                                                  {FileKind::obj, "# cube\nv 0 0 0\nf 1 2 3\n"}};
  for (const auto& [kind, content] : own) {
    EXPECT_TRUE(may_replace(kind, content)) << description(kind);
    EXPECT_TRUE(may_replace(kind, "")) << description(kind);
    EXPECT_TRUE(may_replace(kind, std::string(100, '\0'))) << description(kind);
    for (const std::string& other : {hdf5, png, scenario}) {
      if (other != content) {
        EXPECT_FALSE(may_replace(kind, other)) << description(kind) << " for " << content_description(other);
      }
    }
  }
  for (const FileKind kind : {FileKind::view, FileKind::markdown, FileKind::log, FileKind::html, FileKind::svg,
                              FileKind::stl, FileKind::obj}) {
    EXPECT_FALSE(may_replace(kind, notes)) << description(kind);
  }
  for (const char* toml : {"# mine\n\nname = \"mine\"\n", "[net]\ndiameter = 1\n", "# only words\n"}) {
    EXPECT_TRUE(may_replace(FileKind::scenario, toml)) << toml;
  }
  for (const std::string& other : {notes, view, page, svg, hdf5, std::string("# Findings\n\nThe text.\n")}) {
    EXPECT_FALSE(may_replace(FileKind::scenario, other)) << other;
  }
  EXPECT_FALSE(may_replace(FileKind::view, "focal_point = 1\n[net]\n"));
  EXPECT_FALSE(may_replace(FileKind::recording, hdf5 + "VTKHDF"));
  EXPECT_FALSE(may_replace(FileKind::svg, vtk));
  EXPECT_FALSE(may_replace(FileKind::markdown, "# Case 1\n" + scenario));
  EXPECT_TRUE(may_replace(FileKind::markdown, "# Findings\n\n[Tang et al.](https://doi.org) a = b\n"));
}

TEST(FileKind, SaysWhatIsThere) {
  EXPECT_EQ(content_description("\x89HDF\r\n\x1a\n"), "an HDF5 file, such as a recording");
  EXPECT_EQ(content_description("[net]\ndiameter = 1\n"), "a TOML file, such as a scenario");
  EXPECT_EQ(content_description("my notes"), "a text file of another kind");
  EXPECT_EQ(content_description(std::string("a\0b", 3)), "a file of another kind");
}

}  // namespace
}  // namespace netpocket
