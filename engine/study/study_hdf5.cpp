#include "engine/study/study_hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

#include "engine/base/whole_file.h"
#include "engine/recording/hdf5_output.h"
#include "engine/study/csv_cells.h"

namespace netpocket {
namespace {

constexpr hsize_t kRowsPerChunk = 1024;

enum class ColumnKind { count, number, text };

struct ColumnOfFile {
  std::string name, unit, help;
  ColumnKind kind = ColumnKind::number;
  std::size_t longest = 1;  // bytes of a text
};

std::ifstream open_csv(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw FileError(fmt::format("cannot read \"{}\"", path));
  return file;
}

// Calls `use` with the cells of each row after the header, which it returns.
template <typename Use>
std::vector<std::string> read_rows(const std::string& path, const Use& use) {
  std::ifstream file = open_csv(path);
  std::string line;
  std::getline(file, line);
  std::vector<std::string> header = csv_cells(line);
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = csv_cells(line);
    if (cells.size() != header.size()) throw FileError(fmt::format("\"{}\" has a damaged row: {}", path, line));
    use(cells);
  }
  return header;
}

// A column is of texts when a cell of it is no number, or when it has no unit and nothing in it.
std::vector<ColumnOfFile> find_columns(const std::string& folder) {
  std::vector<ColumnOfFile> columns;
  read_rows(folder + "/study_columns.csv", [&](const std::vector<std::string>& cells) {
    columns.push_back({cells.at(0), cells.at(1), cells.at(2)});
  });
  std::vector<bool> has_number(columns.size()), has_text(columns.size());
  read_rows(folder + "/study.csv", [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
      if (cells[i].empty()) continue;
      const bool is_text = std::isnan(csv_number(cells[i]));
      has_text[i] = has_text[i] || is_text;
      has_number[i] = has_number[i] || !is_text;
      columns[i].longest = std::max(columns[i].longest, cells[i].size());
    }
  });
  for (std::size_t i = 0; i < columns.size(); ++i) {
    ColumnOfFile& column = columns[i];
    const bool is_text = has_text[i] || (!has_number[i] && column.unit.empty());
    const bool is_count = column.name == "point" || column.name == "draw";
    column.kind = is_text ? ColumnKind::text : is_count ? ColumnKind::count : ColumnKind::number;
  }
  return columns;
}

class TableFile {
 public:
  TableFile(const std::string& path, const std::vector<ColumnOfFile>& columns) : columns_(columns) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe file access");
    checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V110), "choose the file format");
    file_ = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose, "create the file");
    group_ = create_group(file_.get(), "table");
    for (const ColumnOfFile& column : columns) {
      types_.push_back(column.kind == ColumnKind::text ? text_type(column.longest) : Handle());
      const hid_t type = column.kind == ColumnKind::text    ? types_.back().get()
                         : column.kind == ColumnKind::count ? H5T_NATIVE_INT64
                                                            : H5T_NATIVE_DOUBLE;
      const TableLayout layout{column.name.c_str(), column.unit.c_str(), column.help.c_str(), {}, kRowsPerChunk};
      tables_.push_back(std::make_unique<OutputTable>(group_.get(), type, layout, codec_));
    }
  }

  void append(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < tables_.size(); ++i) append(i, cells[i]);
    if (++rows_ % kRowsPerChunk == 0) store();
  }

  void close() {
    store();
    tables_.clear();
    types_.clear();
    group_.reset();
    if (!file_.reset()) throw Hdf5Error("close the file");
  }

 private:
  void append(std::size_t column, const std::string& cell) {
    OutputTable& table = *tables_[column];
    if (columns_[column].kind == ColumnKind::text) return table.append_text(cell);
    const double number = csv_number(cell);
    const auto count = static_cast<std::int64_t>(std::isnan(number) ? 0 : number);
    if (columns_[column].kind == ColumnKind::count) {
      table.append(std::span<const std::int64_t>(&count, 1));
    } else {
      table.append(std::span<const double>(&number, 1));
    }
  }

  void store() {
    for (const auto& table : tables_) table->store();
  }

  const std::vector<ColumnOfFile>& columns_;
  ChunkCodec codec_;
  Handle file_, group_;
  std::vector<Handle> types_;  // of texts
  std::vector<std::unique_ptr<OutputTable>> tables_;
  std::size_t rows_ = 0;
};

}  // namespace

void write_study_hdf5(const std::string& folder) {
  const std::string path = folder + "/" + kStudyHdf5;
  const std::vector<ColumnOfFile> columns = find_columns(folder);
  WholeFile whole(path, FileKind::recording);
  try {
    silence_hdf5();
    TableFile file(whole.temporary_path(), columns);
    read_rows(folder + "/study.csv", [&file](const std::vector<std::string>& cells) { file.append(cells); });
    file.close();
  } catch (const Hdf5Error& error) {
    throw FileError(fmt::format("cannot write \"{}\": {}", path, error.what()));
  }
  whole.commit();
}

}  // namespace netpocket
