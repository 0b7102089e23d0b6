// What `netpocket render` and `netpocket report` write besides pictures that are compared.

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkGLTFImporter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>

#include "engine/recording/recorder.h"
#include "render/gl/hosted_render_window.h"
#include "render/output/png_file.h"
#include "tests/gui/program.h"
#include "tests/pictures/made_up_recordings.h"
#include "tests/pictures/picture_comparison.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket::pictures {
namespace {

namespace fs = std::filesystem;

std::string content(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class Rendering : public testing::Test {
 protected:
  Rendering() { write_pocket_recording(run_); }

  // Runs the program with OSMesa and small pictures; its standard error when the exit status is as expected.
  std::string render(std::vector<std::string> options, int exit_code = 0) const {
    std::vector<std::string> arguments = {"render", run_, "--quiet"};
    if (std::ranges::find(options, "--backend") == options.end()) {
      arguments.insert(arguments.end(), {"--backend", "osmesa"});
    }
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = run_program(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.error;
    return result.error;
  }

  TestFolder folder_;
  std::string run_ = folder_.file("run.h5");
};

// Sets a variable of the environment while it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

void expect_one_sentence(const std::string& error, const std::string& part) {
  EXPECT_EQ(std::ranges::count(error, '\n'), 1) << error;
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

TEST_F(Rendering, BothBackEndsDrawTheSame) {
  for (const char* name : {"osmesa", "egl"}) {
    render({"-o", folder_.file(name), "--times", "6", "--size", "480x320", "--backend", name, "--arrows", "--color-by",
            "tension"});
  }
  const auto difference =
      compare_pictures(read_png(folder_.file("osmesa/0000.png")), read_png(folder_.file("egl/0000.png")));
  EXPECT_TRUE(equal_enough(difference)) << difference.beyond << " " << difference.rmse;
}

TEST_F(Rendering, TransparentPicturesAreTheOpaqueOnesOnWhite) {
  render({"-o", folder_.file("opaque"), "--times", "6", "--size", "480x320"});
  render({"-o", folder_.file("clear"), "--times", "6", "--size", "480x320", "--transparent"});
  const auto clear = read_png(folder_.file("clear/0000.png"));
  ASSERT_EQ(clear.alpha.size(), 480u * 320);
  EXPECT_EQ(clear.alpha.front(), 0);
  const auto solid = std::ranges::count(clear.alpha, 255);
  EXPECT_GT(solid, 10000);
  // On white (what the comparison assumes) it is the same picture.
  auto opaque = read_png(folder_.file("opaque/0000.png"));
  opaque.alpha.assign(clear.alpha.size(), 255);
  const auto difference = compare_pictures(clear, opaque);
  EXPECT_EQ(difference.beyond, 0);
  EXPECT_LT(difference.rmse, 2e-3);  // rounding of colours and alpha to bytes
}

TEST_F(Rendering, ResumeDrawsWhatIsMissingOrDifferent) {
  const auto out = folder_.file("out");
  const std::vector<std::string> first = {"-o", out, "--every", "5", "--size", "160x120"};
  render(first);
  const auto again = [&](std::vector<std::string> options) {
    options.insert(options.begin(), first.begin(), first.end() - 2);
    options.emplace_back("--resume");
    render(options);
  };
  const auto whole = content(out + "/0001.png");
  const auto long_ago =
      std::chrono::floor<std::chrono::hours>(fs::file_time_type::clock::now()) - std::chrono::hours(24);
  const auto mark = [&](const char* name) { fs::last_write_time(out + name, long_ago); };
  const auto kept = [&](const char* name) { return fs::last_write_time(out + name) == long_ago; };
  mark("/0000.png");
  mark("/0002.png");
  fs::remove(out + "/0001.png");
  again({"--size", "160x120"});
  EXPECT_TRUE(kept("/0000.png"));
  EXPECT_EQ(content(out + "/0001.png"), whole);
  EXPECT_TRUE(kept("/0002.png"));
  // A torn file and another look are drawn again.
  fs::resize_file(out + "/0000.png", 40);
  again({"--size", "160x120"});
  EXPECT_FALSE(kept("/0000.png"));
  EXPECT_TRUE(kept("/0002.png"));
  again({"--size", "176x120"});
  EXPECT_FALSE(kept("/0002.png"));
  EXPECT_EQ(read_png(out + "/0002.png").width, 176);
}

TEST_F(Rendering, ResumedVideoHasAllFrames) {
  const auto video = folder_.file("video.mp4");
  render({"-o", folder_.file("out"), "--fps", "1", "--size", "160x120"});
  fs::remove(folder_.file("out/0003.png"));
  render({"-o", folder_.file("out"), "--fps", "1", "--size", "160x120", "--video", video, "--resume"});
  EXPECT_GT(fs::file_size(video), 1000u);
  EXPECT_TRUE(fs::exists(folder_.file("out/0003.png")));
}

TEST_F(Rendering, EveryTakesRecordedFrames) {
  render({"-o", folder_.file("out"), "--every", "4", "--size", "64x64"});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.file("out")), {}), 3);  // 0, 4 and 8 s
}

TEST_F(Rendering, SavedViewDrawsTheSamePicture) {
  const auto view = folder_.file("view.toml");
  render({"-o", folder_.file("preset"), "--times", "6", "--size", "320x240", "--camera", "mouth", "--save-view", view});
  render({"-o", folder_.file("file"), "--times", "6", "--size", "320x240", "--view", view});
  EXPECT_TRUE(equal_enough(
      compare_pictures(read_png(folder_.file("preset/0000.png")), read_png(folder_.file("file/0000.png")))));
}

TEST_F(Rendering, BadViewsAreOneSentence) {
  const auto bad = [&](const std::string& text, const std::string& part) {
    const auto view = folder_.write("bad.toml", text);
    expect_one_sentence(render({"-o", folder_.file("out"), "--times", "6", "--view", view}, 3), part);
  };
  bad("position = [1, 2]\nfocal_point = [0, 0, 0]\n", "line 1: 'position' must be three numbers");
  bad("position = [1, 2, 3]\n", "'focal_point' is missing");
  bad("position = [1, 2, 3]\nfocal_point = [1, 2, 3]\n", "must differ");
  bad("position = [0, 9, 0]\nfocal_point = [0, 0, 0]\nview_up = [0, 1, 0]\n", "view_up must not point along");
  bad("position = [0, 9, 0]\nfocal_point = [0, 0, 0]\nview_up = [0, 0, 0]\n", "view_up must not be zero");
  bad("position = [1e9, 9, 0]\nfocal_point = [0, 0, 0]\n", "from -1e+06 to 1e+06");
  bad("position = [1, 2, 3]\nfocal_point = [0, 0, 0]\nview_angle = 30\nhalf_height = 9\n", "contradict each other");
  bad("position = [1, 2, 3]\nfocal_point = [0, 0, 0]\nzoom = 2\n", "line 3: unknown key 'zoom'");
  bad("position = [1, 2, 3]\nfocal_point = [0, 0, 0]\nview_angle = 180\n", "between 0 and 170");
  bad("position = \n", "line 1");
  expect_one_sentence(render({"-o", folder_.file("out"), "--view", folder_.file("none.toml")}, 3),
                      "cannot read the view");
}

// Without an up of its own it is the one with which the preset "front" looks along the pocket's axis.
TEST_F(Rendering, StraightFromAboveNeedsNoUp) {
  const auto view = folder_.file("front.toml");
  render({"-o", folder_.file("front"), "--times", "6", "--size", "320x240", "--camera", "front", "--save-view", view});
  const auto without_up = std::regex_replace(content(view), std::regex("view_up[^\n]*\n"), "");
  ASSERT_NE(without_up, content(view));
  render({"-o", folder_.file("own"), "--times", "6", "--size", "320x240", "--view",
          folder_.write("own.toml", without_up)});
  EXPECT_TRUE(
      equal_enough(compare_pictures(read_png(folder_.file("front/0000.png")), read_png(folder_.file("own/0000.png")))));
}

TEST_F(Rendering, NumbersWithoutSenseAreRefused) {
  const std::vector<std::string> picture = {"-o", folder_.file("out"), "--size", "64x64"};
  const auto bad = [&](const std::string& option, const std::string& value, const std::string& part) {
    auto options = picture;
    options.insert(options.end(), {option, value});
    expect_one_sentence(render(options, 2), part);
    EXPECT_FALSE(fs::exists(folder_.file("out"))) << option << " " << value;
  };
  for (const char* rate : {"1e9", "1e300", "1e-9", "nan", "inf", "0"}) bad("--fps", rate, "from 0.001 to 1000");
  for (const char* opacity : {"nan", "1.01", "-0.1"}) bad("--target-opacity", opacity, "from 0 to 1");
  bad("--times", "0,,0.5", "a comma too many");
  bad("--times", "0,0.5,", "a comma too many");
  bad("--times", "0,nan", "\"nan\" is not a number from 0");
  for (const char* range : {"0", "0,inf", "nan,1", "0,1,2"}) bad("--color-range", range, "two numbers");
  bad("--color-range", "2,1", "the first value must be below the second");
  EXPECT_EQ(render({"-o", folder_.file("out"), "--size", "64x64", "--times", "0,5", "--times", "6"}), "");
  EXPECT_TRUE(fs::exists(folder_.file("out/0002.png")));
}

// The rate is in bounds, the pictures of a long run are too many.
TEST_F(Rendering, CountsOfPicturesAreBounded) {
  const auto structure = synthetic::make_structure();
  {
    Recorder recorder(run_, {}, structure, true);
    for (const double time : {0, 200}) recorder.write(synthetic::make_snapshot(structure, time, 0));
    recorder.finish({RunReason::finished, 200, ""}, {});
  }
  expect_one_sentence(render({"-o", folder_.file("out"), "--fps", "1000", "--size", "64x64"}, 2), "pictures");
  const auto report = run_program({"report", run_, "-o", folder_.file("r.html"), "--fps", "1000", "--quiet"});
  EXPECT_EQ(report.exit_code, 2);
  expect_one_sentence(report.error, "pictures");
}

TEST_F(Rendering, OlderPicturesAreMentioned) {
  const auto out = folder_.file("out");
  EXPECT_EQ(render({"-o", out, "--times", "0,2,4,6", "--size", "64x64"}), "");
  expect_one_sentence(render({"-o", out, "--times", "0,2", "--size", "64x64"}),
                      "also holds 2 older files, 0002.png to 0003.png");
  fs::remove(out + "/0002.png");
  folder_.write("out/12345.jpg", "");
  expect_one_sentence(render({"-o", out, "--times", "0,2", "--size", "64x64"}), "also holds 1 older file, 0003.png:");
}

// Ink of a picture's columns from `left` on, in its upper fifth.
int dark_pixels(const Image& image, int left) {
  int count = 0;
  for (int y = 0; y < image.height / 5; ++y) {
    for (int x = left; x < image.width; ++x) count += image.rgb[y * image.row_bytes() + 3 * x] < 128;
  }
  return count;
}

TEST_F(Rendering, LongTitlesKeepWithinThePicture) {
  const std::string title = "A title that goes on and on, as titles do that name every setting of a study, one by one";
  const auto drawn = [&](const std::string& text) {
    EXPECT_EQ(render({"-o", folder_.file("out"), "--times", "0", "--size", "480x480", "--title", text}), "");
    return read_png(folder_.file("out/0000.png"));
  };
  const auto image = drawn(title);
  EXPECT_GT(dark_pixels(image, 380), 0) << "it uses the width there is";
  EXPECT_EQ(dark_pixels(image, 480 - 12), 0) << "it runs off the picture";
  EXPECT_GT(dark_pixels(image, 0), dark_pixels(drawn("A title"), 0));
}

TEST_F(Rendering, LettersThatNoFontHasAreNamed) {
  const std::vector<std::string> picture = {"-o", folder_.file("out"), "--times", "0", "--size", "64x64", "--title"};
  const auto with = [&](const std::string& title) {
    auto options = picture;
    options.push_back(title);
    return render(options);
  };
  expect_one_sentence(with("Probe \U0010FFFD"), "no installed font has all letters");
  EXPECT_EQ(with("Gr\u00F6\u00DFe \u2900"), "") << "another font has it";
}

// What desktops set: fonts of the user's choice, their smoothing, languages, scales.
TEST_F(Rendering, NothingDependsOnTheMachinesSettings) {
  write_pocket_recording(folder_.file("second.h5"), "other");
  const auto draw = [&](const std::string& name) {
    fs::create_directory(folder_.file(name));
    render({folder_.file("second.h5"), "-o", folder_.file(name), "--times", "6", "--size", "320x240", "--sheet",
            folder_.file(name + "/sheet.png"), "--panel-size", "160x160", "--title", "Settings", "--arrows"});
    for (const char* format : {"png", "svg", "pdf"}) {
      const auto plot =
          run_program({"plot", run_, "-o", folder_.file(name), "--format", format, "--figure", "figure05_force"});
      EXPECT_EQ(plot.exit_code, 0) << plot.error;
    }
  };
  draw("plain");
  fs::create_directories(folder_.file("config/fontconfig"));
  folder_.write("config/fontconfig/fonts.conf", R"(<?xml version="1.0"?>
<fontconfig>
  <match target="pattern">
    <edit name="family" mode="assign" binding="strong"><string>DejaVu Serif</string></edit>
  </match>
  <match target="font">
    <edit name="antialias" mode="assign"><bool>false</bool></edit>
    <edit name="hintstyle" mode="assign"><const>hintfull</const></edit>
    <edit name="rgba" mode="assign"><const>rgb</const></edit>
  </match>
</fontconfig>
)");
  {
    const Variable config("XDG_CONFIG_HOME", folder_.file("config")), scale("QT_SCALE_FACTOR", "2"),
        language("LC_ALL", "de_DE.UTF-8"), theme("GTK_THEME", "Adwaita:dark"), platform("QT_QPA_PLATFORMTHEME", "gtk3");
    draw("desktop");
  }
  for (const char* name : {"0000.png", "sheet.png", "figure05_force.png", "figure05_force.svg"}) {
    EXPECT_TRUE(content(folder_.file(std::string("plain/") + name)) ==
                content(folder_.file(std::string("desktop/") + name)))
        << name;
  }
  // Of a PDF the date differs; its size would not stay with another font.
  EXPECT_NEAR(static_cast<double>(fs::file_size(folder_.file("plain/figure05_force.pdf"))),
              static_cast<double>(fs::file_size(folder_.file("desktop/figure05_force.pdf"))), 8);
}

// Each thing whose absence the program must explain; the last resort of the loader is a file that is no library.
TEST_F(Rendering, MissingLibrariesProgramsAndFontsAreOneSentence) {
  const std::vector<std::string> picture = {"-o", folder_.file("out"), "--times", "6", "--size", "64x64", "--backend"};
  const auto with = [&](const char* backend) {
    auto options = picture;
    options.emplace_back(backend);
    return options;
  };
  folder_.write("libOSMesa.so.8", "no library");
  {
    const Variable path("LD_LIBRARY_PATH", fs::path(run_).parent_path());
    expect_one_sentence(render(with("osmesa"), 6), "cannot draw with osmesa: ");
  }
  {
    const Variable drivers("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/driver.json");
    expect_one_sentence(render(with("egl"), 6), "cannot draw with egl: ");
  }
  {
    const Variable path("PATH", "/nowhere");
    expect_one_sentence(render({"--video", folder_.file("video.mp4"), "--fps", "1", "--size", "64x64"}, 6),
                        "the program ffmpeg is not installed");
  }
  folder_.write("fonts.conf", "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  const Variable fonts("FONTCONFIG_FILE", folder_.file("fonts.conf"));
  expect_one_sentence(render(with("osmesa"), 6), "the font DejaVu Sans is not installed");
  const auto plot = run_program({"plot", run_, "-o", folder_.file("figures")});
  EXPECT_EQ(plot.exit_code, 6);
  expect_one_sentence(plot.error, "the font DejaVu Sans is not installed");
}

TEST_F(Rendering, ContradictingOptionsAreRefused) {
  expect_one_sentence(render({"--times", "6"}, 2), "nothing to write");
  expect_one_sentence(render({"--video", folder_.file("v.mp4"), "--transparent"}, 2), "--transparent");
  expect_one_sentence(render({"--video", folder_.file("v.mp4"), "--resume"}, 2), "--resume");
  expect_one_sentence(render({"--gltf", folder_.file("m.glb")}, 2), "--gltf");
}

TEST_F(Rendering, GltfCanBeImportedAgain) {
  const auto file = folder_.file("moment.glb");
  render({"--gltf", file, "--times", "6", "--arrows", "--ghost", "--trails", "--target-opacity", "0.4", "--color-by",
          "tension"});
  // The container (specification, chapter 4).
  const auto bytes = content(file);
  ASSERT_GT(bytes.size(), 100000u);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  std::uint32_t length = 0, json_length = 0;
  std::memcpy(&length, bytes.data() + 8, 4);
  std::memcpy(&json_length, bytes.data() + 12, 4);
  EXPECT_EQ(length, bytes.size());
  const auto json = nlohmann::json::parse(bytes.substr(20, json_length));
  for (const auto& view : json["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
  std::vector<std::string> names;
  for (const auto& node : json["nodes"]) names.push_back(node["name"]);
  for (const char* name : {"spacecraft", "target", "rods", "net", "closing ropes", "contact forces", "initial shape"}) {
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
  }

  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(file.c_str());
  const auto window = HostedRenderWindow::make(make_gl_host(GlBackend::osmesa), 64, 64);
  importer->SetRenderWindow(window);
  importer->Update();
  auto* actors = importer->GetRenderer()->GetActors();
  ASSERT_EQ(actors->GetNumberOfItems(), static_cast<int>(names.size()));
  actors->InitTraversal();
  int with_colors = 0;
  for (const auto& name : names) {
    auto* actor = actors->GetNextActor();
    auto* mesh = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
    ASSERT_GT(mesh->GetNumberOfPoints(), 0) << name;
    if (mesh->GetNumberOfPolys() > 0) {
      auto* normals = mesh->GetPointData()->GetNormals();
      ASSERT_TRUE(normals) << name;
      for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); i += 17) {
        const double* n = normals->GetTuple3(i);
        EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-5) << name;
      }
    }
    with_colors += mesh->GetPointData()->GetArray("COLOR_0") || mesh->GetPointData()->GetScalars();
  }
  // VTK's importer does not pass opacity on: by the file itself.
  int translucent = 0;
  for (const auto& material : json["materials"]) {
    if (!material.contains("alphaMode")) continue;
    ++translucent;
    EXPECT_EQ(material["alphaMode"], "BLEND");
    EXPECT_NEAR(material["pbrMetallicRoughness"]["baseColorFactor"][3].get<double>(), 0.4, 1e-6);
  }
  EXPECT_EQ(translucent, 1);  // the target
  EXPECT_GE(with_colors, 5);
}

TEST_F(Rendering, ReportIsOneFileThatNeedsNothingElse) {
  const auto first = folder_.file("case1.h5"), second = folder_.file("other.h5");
  write_pocket_recording(first, "case1");
  write_pocket_recording(second, "<other> & more");
  const auto page = folder_.file("report.html");
  const auto result =
      run_program({"report", first, second, "-o", page, "--fps", "1", "--backend", "osmesa", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto text = content(page);
  // Nothing is loaded: every source is inside.
  const std::regex reference("(src|href)=\"([^\"]{0,40})");
  int inside = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), reference), end; match != end; ++match) {
    EXPECT_TRUE((*match)[2].str().starts_with("data:")) << (*match)[0];
    ++inside;
  }
  EXPECT_EQ(inside, 2);  // sheet and video; the figures are part of the page
  for (const char* part : {"url(\"", "url(h", "@import", "<script", "<link"})
    EXPECT_EQ(text.find(part), std::string::npos) << part;
  EXPECT_NE(text.find("&lt;other&gt; &amp; more"), std::string::npos);
  EXPECT_EQ(text.find("<other>"), std::string::npos);
  for (const char* part :
       {"data:image/png;base64,", "data:video/mp4;base64,", "<svg ", "F11", "First contact", "[closing]"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  {
    const Variable path("PATH", "/nowhere");
    const auto without = run_program({"report", first, "-o", page, "--backend", "osmesa", "--quiet"});
    EXPECT_EQ(without.exit_code, 6);
    expect_one_sentence(without.error, "the program ffmpeg is not installed");
    const auto plain = run_program({"report", first, "-o", page, "--no-video", "--backend", "osmesa", "--quiet"});
    EXPECT_EQ(plain.exit_code, 0) << plain.error;
  }
  EXPECT_EQ(content(page).find("<video"), std::string::npos);
}

}  // namespace
}  // namespace netpocket::pictures
