#pragma once
// The table of a study as an HDF5 file: /table with a dataset for each column, all of the same length. Attributes of a
// column: "unit" ("1" for pure numbers, "" for texts) and "help". Numbers are 64-bit floats, NaN where the table has
// nothing, `point` and `draw` 64-bit integers, everything else is UTF-8 text. Thread contract: any thread may call it.

#include <string>

namespace netpocket {

// Name of the file, in the study's folder.
inline constexpr char kStudyHdf5[] = "study.h5";

// Writes it from study.csv and study_columns.csv of the folder, which must exist. Takes little memory, however long the
// table is. Throws FileError.
void write_study_hdf5(const std::string& folder);

}  // namespace netpocket
