// The numbers of a reference table in this folder; its first line is a header.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace colloid {

/// `name` from tests/verification, e.g. "wall_resistance/series.csv".
inline std::vector<std::vector<double>> csv_rows(const std::string& name) {
  std::ifstream file(PORECLOG_SOURCE_DIR "/tests/verification/" + name);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) {
      rows.back().push_back(std::stod(field));
    }
  }
  return rows;
}

}  // namespace colloid
