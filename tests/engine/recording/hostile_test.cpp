// Files that nobody vouches for: one sentence, no crash, no huge allocation.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <random>

#include "engine/recording/recording.h"
#include "tests/engine/recording/synthetic_run.h"
#include "tests/hardening/hardening_table.h"

namespace netpocket {
namespace {

// Opens a file and reads all of it. Returns the refusal, or "".
std::string read_all(const std::string& path) {
  try {
    const Recording recording(path);
    for (std::size_t i = 0; i < recording.frame_count(); ++i) recording.frame(i);
  } catch (const RecordingError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& path, const std::string& reason) {
  return "cannot read \"" + path + "\": " + reason;
}

// A small valid recording, changed by the HDF5 library.
class Tampered {
 public:
  explicit Tampered(const std::function<void(hid_t)>& change) : path_(folder_.file("run.h5")) {
    write_synthetic_run(path_, 5);
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
  }
  std::string reason() const {
    const std::string text = read_all(path_);
    const std::string start = "cannot read \"" + path_ + "\": ";
    return text.starts_with(start) ? text.substr(start.size()) : text;
  }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

void replace_attribute(hid_t file, const char* object, const char* name, hid_t type, const void* value) {
  const hid_t space = H5Screate(H5S_SCALAR);
  H5Adelete_by_name(file, object, name, H5P_DEFAULT);
  const hid_t attribute = H5Acreate_by_name(file, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, value);
  H5Aclose(attribute);
  H5Sclose(space);
}

void replace_count(hid_t file, const char* object, const char* name, std::int64_t value) {
  replace_attribute(file, object, name, H5T_NATIVE_INT64, &value);
}

void replace_dataset(hid_t file, const char* path, hid_t type, std::vector<hsize_t> size) {
  H5Ldelete(file, path, H5P_DEFAULT);
  const std::vector<hsize_t> chunk(size.size(), 1);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
  const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
  H5Dclose(H5Dcreate2(file, path, type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
  H5Sclose(space);
  H5Pclose(properties);
}

void write_element(hid_t file, const char* path, std::int32_t value) {
  const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT);
  const hid_t space = H5Dget_space(dataset);
  std::vector<std::int32_t> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(dataset, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  values.back() = value;
  H5Dwrite(dataset, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(dataset);
}

TEST(Hostile, OtherFiles) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing.h5");
  EXPECT_EQ(read_all(missing), refusal(missing, "No such file or directory"));
  EXPECT_EQ(read_all(folder.path().string()), refusal(folder.path().string(), "it is not a file"));
  const std::string text = folder.file("text.h5");
  for (const std::string& content : {std::string(), std::string("a text"), std::string(100000, 'x')}) {
    write_bytes(text, content);
    EXPECT_EQ(read_all(text), refusal(text, "it is damaged or not an HDF5 file"));
  }
  const std::string scenario = folder.file("own.toml");
  write_bytes(scenario, "name = \"own\"");
  EXPECT_EQ(read_all(scenario), refusal(scenario, "it is a scenario; netpocket run makes a recording of it"));
  const std::string foreign = folder.file("foreign.h5");
  H5Fclose(H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(read_all(foreign), refusal(foreign, "it is not a Netpocket recording"));
}

TEST(Hostile, WrongAttributes) {
  const auto attribute = [](const char* object, const char* name, std::int64_t value) {
    return Tampered([=](hid_t file) { replace_count(file, object, name, value); }).reason();
  };
  EXPECT_EQ(attribute("/", "format_version", 4), "its format is version 4, this program reads versions 2 and 3");
  EXPECT_EQ(attribute("/", "format", 2), "it is not a Netpocket recording");
  EXPECT_EQ(attribute("/", "commit", 2), "attribute commit has the wrong type");
  EXPECT_EQ(attribute("/structure", "node_count", -1), "attribute node_count is out of range");
  EXPECT_EQ(attribute("/structure", "node_count", 20), "element 19 names a node that does not exist");
  EXPECT_EQ(attribute("/structure", "node_count", 2147483647), "/frames/position has the wrong dimensions");
  EXPECT_EQ(attribute("/structure", "rope_count", 1), "element 1 names a rope that does not exist");
  EXPECT_EQ(attribute("/frames/channels", "names", 1), "attribute names has the wrong type");
}

// A recording may lack any channel but the time; names are distinct.
TEST(Hostile, MissingChannels) {
  const auto renamed = [](Channel old_name, const std::string& new_name) {
    std::string names;
    for (const ChannelInfo& channel : *known_channels()) {
      const bool is_renamed = channel.name == channel_info(old_name).name;
      names += fmt::format("{}{}", names.empty() ? "" : ",", is_renamed ? new_name : channel.name);
    }
    return Tampered([&names](hid_t file) {
             const hid_t type = H5Tcopy(H5T_C_S1);
             H5Tset_size(type, names.size());
             replace_attribute(file, "/frames/channels", "names", type, names.data());
             H5Tclose(type);
           })
        .reason();
  };
  EXPECT_EQ(renamed(Channel::time, "another"), "there is no channel called time");
  EXPECT_EQ(renamed(Channel::contact_fx, "contact_fy"), "two channels are called contact_fy");
  EXPECT_EQ(renamed(Channel::contact_fy, "another"), "");
}

TEST(Hostile, WrongDatasets) {
  const auto dataset = [](const char* path, hid_t type, std::vector<hsize_t> size) {
    return Tampered([=](hid_t file) { replace_dataset(file, path, type, size); }).reason();
  };
  EXPECT_EQ(dataset("/frames/position", H5T_NATIVE_INT32, {5, 21, 3}), "/frames/position has the wrong type");
  EXPECT_EQ(dataset("/frames/position", H5T_NATIVE_FLOAT, {5, 22, 3}), "/frames/position has the wrong dimensions");
  EXPECT_EQ(dataset("/frames/position", H5T_NATIVE_FLOAT, {5, 63}), "/frames/position has the wrong dimensions");
  EXPECT_EQ(dataset("/frames/position", H5T_NATIVE_FLOAT, {3, 21, 3}), "some of its frames are incomplete");
  EXPECT_EQ(dataset("/frames/step", H5T_NATIVE_INT64, {1ull << 40}), "/frames/step claims an impossible size");
  EXPECT_EQ(dataset("/structure/element_nodes", H5T_NATIVE_INT32, {1ull << 40, 2}),
            "/structure/element_nodes claims an impossible size");
  EXPECT_EQ(dataset("/structure/element_group", H5T_NATIVE_INT32, {3}),
            "/structure/element_group has the wrong length");
  const std::string variable = Tampered([](hid_t file) {
                                 const hid_t type = H5Tcopy(H5T_C_S1);
                                 H5Tset_size(type, H5T_VARIABLE);
                                 replace_dataset(file, "/scenario", type, {1});
                                 H5Tclose(type);
                               }).reason();
  EXPECT_EQ(variable, "/scenario has the wrong type");
}

TEST(Hostile, WrongIndices) {
  const auto last = [](const char* path, std::int32_t value) {
    return Tampered([=](hid_t file) { write_element(file, path, value); }).reason();
  };
  EXPECT_EQ(last("/structure/element_nodes", 21), "element 19 names a node that does not exist");
  EXPECT_EQ(last("/structure/element_gradients", -1), "element 19 names a gradient that does not exist");
  EXPECT_EQ(last("/structure/element_thread", 2), "element 19 names a thread that does not exist");
  EXPECT_EQ(last("/structure/element_group", 3), "element 19 names a group that does not exist");
  EXPECT_EQ(last("/structure/group_look", 3), "the group of closing ropes has an unknown look");
  EXPECT_EQ(last("/structure/node_group_look", 5), "the group of rod tips has an unknown look");
  EXPECT_EQ(last("/structure/node_group_size", 3), "a group of nodes is larger than what is stored of it");
  EXPECT_EQ(last("/structure/body_shape", 5), "a body has an unknown shape");
  EXPECT_EQ(last("/structure/body_shape", 4), "a body names a mesh that does not exist");
  EXPECT_EQ(last("/structure/body_shape", 3), "a body has an impossible size or mass");
  EXPECT_EQ(last("/structure/node_group_nodes", 21), "the group of rod tips names a node that does not exist");
  EXPECT_EQ(last("/contacts/body", 3), "its contacts are damaged");
  EXPECT_EQ(last("/contacts/element", -2), "its contacts are damaged");
  EXPECT_EQ(last("/frames/contact_range", 1000000), "/contacts/position is shorter than expected");
}

// A link that leads to another file is not followed.
TEST(Hostile, LinksOutOfTheFile) {
  const TemporaryFolder folder;
  const std::string other = folder.file("other.h5");
  write_synthetic_run(other, 5);
  const Tampered linked([&](hid_t file) {
    H5Ldelete(file, "/frames", H5P_DEFAULT);
    H5Lcreate_external(other.c_str(), "/frames", file, "/frames", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_EQ(linked.reason(), "/frames/channels is missing");
}

// Nor are data read that a table keeps in another file, raw or as a table there.
TEST(Hostile, TablesInOtherFiles) {
  const auto replaced = [](const std::function<void(hid_t properties, hid_t space)>& describe) {
    return Tampered([&](hid_t file) {
             const hsize_t size[] = {5};
             const hid_t properties = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(1, size, nullptr);
             describe(properties, space);
             H5Ldelete(file, "/frames/step", H5P_DEFAULT);
             H5Dclose(H5Dcreate2(file, "/frames/step", H5T_NATIVE_INT64, space, H5P_DEFAULT, properties, H5P_DEFAULT));
             H5Sclose(space);
             H5Pclose(properties);
           })
        .reason();
  };
  EXPECT_EQ(replaced([](hid_t properties, hid_t) { H5Pset_external(properties, "/etc/passwd", 0, 40); }),
            "/frames/step is not stored in chunks");
  EXPECT_EQ(replaced([](hid_t properties, hid_t space) {
              H5Pset_virtual(properties, space, "/tmp/other.h5", "/frames/step", space);
            }),
            "/frames/step is not stored in chunks");
}

TEST(Hostile, TruncatedFiles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 5);
  const std::string whole = read_bytes(path);
  for (std::size_t i = 0; i < 200; ++i) {
    const std::size_t length = whole.size() * i / 200;
    write_bytes(path, whole.substr(0, length));
    EXPECT_NE(read_all(path), "") << length << " of " << whole.size() << " bytes";
  }
}

TEST(HostileHardening, FlippedBytes) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 5);
  const std::string whole = read_bytes(path);
  std::mt19937 random(300);
  const int trials = test::trial_count(300, 10000);
  int refused = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::string damaged = whole;
    for (unsigned flips = 1 + random() % 3; flips > 0; --flips) {
      damaged[random() % damaged.size()] ^= static_cast<char>(1 + random() % 255);
    }
    write_bytes(path, damaged);
    if (!read_all(path).empty()) ++refused;
  }
  std::printf("%d of %d damaged files were refused; in the others no byte in use was hit\n", refused, trials);
  EXPECT_GT(refused, 0);
  EXPECT_TRUE(
      test::record_hardening({"recording with one to three random bytes changed", std::to_string(trials) + " mutations",
                              std::to_string(refused) + " refused in one sentence, the others read: no byte "
                                                        "in use was hit"}));
}

}  // namespace
}  // namespace netpocket
