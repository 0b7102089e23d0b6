#include "render/output/whole_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "render/render_error.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

std::string temporary_name(const fs::path& path) {
  const std::string name = fmt::format(".{}.{}.part{}", path.stem().string(), getpid(), path.extension().string());
  return (path.parent_path() / name).string();
}

}  // namespace

WholeFile::WholeFile(std::string path) : path_(std::move(path)), temporary_path_(temporary_name(path_)) {}

WholeFile::~WholeFile() {
  std::error_code ignored;
  fs::remove(temporary_path_, ignored);
}

void WholeFile::commit() {
  std::error_code error;
  fs::rename(temporary_path_, path_, error);
  if (error) throw RenderError(fmt::format("cannot write {}: {}", path_, error.message()));
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw RenderError(fmt::format("cannot make the folder {}: {}", path, error.message()));
}

}  // namespace netpocket
