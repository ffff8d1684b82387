// The tables of reference values in this folder: rows "case,quantity,value" and, for
// samples, "case,x,y,event".
#pragma once

#include <cstddef>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace colloid::statistics {

class ReferenceTable {
 public:
  explicit ReferenceTable(const std::string& name) {
    const std::string path = PORECLOG_SOURCE_DIR "/tests/verification/statistics/" + name;
    std::ifstream file(path);
    if (!file) {
      throw std::runtime_error("cannot read " + path);
    }
    std::string line;
    std::getline(file, line);  // header
    while (std::getline(file, line)) {
      std::vector<std::string> fields;
      std::istringstream stream(line);
      for (std::string field; std::getline(stream, field, ',');) {
        fields.push_back(field);
      }
      rows_.push_back(fields);
    }
  }

  /// Column `column` of the rows whose first fields are `key`; NaN where R wrote NA.
  /// Refuses an empty answer: a misspelt key must not pass a test.
  std::vector<double> column(const std::vector<std::string>& key,
                             std::size_t column) const {
    std::vector<double> values;
    for (const std::vector<std::string>& row : rows_) {
      bool matches = row.size() > column;
      for (std::size_t i = 0; matches && i < key.size(); ++i) {
        matches = row[i] == key[i];
      }
      if (matches) {
        values.push_back(row[column] == "NA" ? std::numeric_limits<double>::quiet_NaN()
                                             : std::stod(row[column]));
      }
    }
    if (values.empty()) {
      throw std::runtime_error("no reference for " + key.front());
    }
    return values;
  }

  double value(const std::string& name, const std::string& quantity) const {
    return column({name, quantity}, 2).front();
  }
  std::vector<double> values(const std::string& name, const std::string& quantity) const {
    return column({name, quantity}, 2);
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace colloid::statistics
