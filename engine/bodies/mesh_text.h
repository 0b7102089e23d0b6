#pragma once
// Mesh files that are texts, word by word.

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <string_view>

namespace netpocket {

// Ends the reading of a mesh file; read_mesh_file() and its like turn it into a value.
class MeshFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws MeshFileError when a mesh has more triangles than are allowed.
void require_room_for_triangles(std::size_t count);

std::string lower_case(std::string_view text);

// The text without the mark that some programs put before UTF-8. Throws MeshFileError for UTF-16 and UTF-32, and for
// bytes that no text has.
std::string_view plain_text(std::string_view bytes);

// Goes through a text line by line and word by word. Lines end with LF, CR or both; a line that ends with a backslash
// goes on in the next one; from `comment` on, a line is not read.
class MeshWords {
 public:
  MeshWords(std::string_view text, char comment) : rest_(text), comment_(comment) {}

  // Goes to the next line; false at the end.
  bool next_line();
  // The next word of the line; empty at its end.
  std::string_view next();
  // The next word, which next() will give again.
  std::string_view peek();
  int line() const { return number_; }

  // Throws MeshFileError with the number of the line, or of an earlier one.
  [[noreturn]] void fail(const std::string& problem) const { fail(problem, number_); }
  [[noreturn]] static void fail(const std::string& problem, int line);
  double number();
  Eigen::Vector3d vector();

 private:
  void take_line();  // up to its end, into line_

  std::string_view rest_, line_;
  char comment_;
  int number_ = 0;  // of the line in the file
};

}  // namespace netpocket
