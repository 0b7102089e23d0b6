#pragma once
// Reads the tables that studies write. Pure functions: any thread may call them.

#include <string>
#include <vector>

namespace netpocket {

// Cells of a line of RFC 4180.
std::vector<std::string> csv_cells(const std::string& line);

// The number that a cell consists of; NaN if it is none.
double csv_number(const std::string& cell);

}  // namespace netpocket
