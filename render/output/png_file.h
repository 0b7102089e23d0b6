#pragma once
// PNG pictures. A file appears under its name only when it is whole.

#include <optional>
#include <string>

#include "render/output/image.h"

namespace netpocket {

// Writes pictures one after the other; keeps its memory from one to the next. One thread at a time.
class PngWriter {
 public:
  // Replaces an existing picture. A comment (Latin-1) is kept in the file. Throws FileError.
  void write(const Image& image, const std::string& path, const std::string& comment = {});

 private:
  std::vector<std::uint8_t> pixels_;  // as they are compressed
  std::vector<std::uint8_t> file_;
};

std::string png_bytes(const Image& image);
void write_png(const Image& image, const std::string& path, const std::string& comment = {});

// Reads any PNG as RGB, with alpha when it has it. Throws RenderError with one sentence that names the file.
Image read_png(const std::string& path);

// The comment in a PNG; none when it has none, is no PNG or does not exist.
std::optional<std::string> png_comment(const std::string& path);

}  // namespace netpocket
