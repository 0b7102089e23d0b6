#pragma once
// Reads mesh files that are texts, word by word.

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <string_view>

namespace netpocket {

// Ends the reading of a mesh file. The functions of mesh_file.h catch it and return its message as a value.
class MeshFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws MeshFileError if `count` exceeds kLargestTriangleCount.
void require_room_for_triangles(std::size_t count);

std::string lower_case(std::string_view text);

// The text without the byte order mark that some programs put before UTF-8. Throws MeshFileError for UTF-16 and UTF-32,
// and for texts that contain a zero byte.
std::string_view plain_text(std::string_view bytes);

// Reads a text line by line and word by word. Lines end with LF, CR or CR LF. A line that ends with a backslash
// continues on the next one. The rest of a line from the character `comment` on is ignored. The text must outlive this.
class MeshWords {
 public:
  MeshWords(std::string_view text, char comment) : rest_(text), comment_(comment) {}

  // Goes to the next line; false at the end of the text.
  bool next_line();
  // The next word of the line; empty at its end.
  std::string_view next();
  // The next word, without consuming it.
  std::string_view peek();
  int line() const { return number_; }

  // Throws MeshFileError with the number of this line, or with the given one.
  [[noreturn]] void fail(const std::string& problem) const { fail(problem, number_); }
  [[noreturn]] static void fail(const std::string& problem, int line);
  // Reads one number, or three. Throws MeshFileError if a word is not a number.
  double number();
  Eigen::Vector3d vector();

 private:
  void take_line();  // moves the next line of the file into line_

  std::string_view rest_, line_;
  char comment_;
  int number_ = 0;  // of the current line in the file, from 1
};

}  // namespace netpocket
