#include "report/read_sample.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"

namespace colloid {

namespace {

const std::vector<std::string> kColumns{"idx", "t1_s", "tc_s", "censored", "alpha_deg"};

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r\"";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos
             ? ""
             : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = line.find(',', begin);
    fields.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string::npos) {
      return fields;
    }
    begin = comma + 1;
  }
}

/// One line of the table, with its place for messages.
class Row {
 public:
  Row(const std::vector<std::string>& header, std::vector<std::string> fields,
      std::string where)
      : header_(header), fields_(std::move(fields)), where_(std::move(where)) {
    require(fields_.size() == header_.size(), where_,
            fmt::format("has {} fields, expected {}", fields_.size(), header_.size()));
  }

  const std::string& where() const { return where_; }

  /// None if there is no such column or the field holds no value.
  std::optional<double> number(const std::string& column) const {
    const auto at = std::find(header_.begin(), header_.end(), column);
    if (at == header_.end()) {
      return std::nullopt;
    }
    const std::string& text = fields_[static_cast<std::size_t>(at - header_.begin())];
    if (text.empty() || text == "NA" || text == "NaN" || text == "nan") {
      return std::nullopt;
    }
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    require(
        error == std::errc() && end == text.data() + text.size() && std::isfinite(value),
        where_, fmt::format("{} is {}, expected a number", column, in_quotes(text)));
    return value;
  }

 private:
  const std::vector<std::string>& header_;
  std::vector<std::string> fields_;
  std::string where_;
};

void check_header(const std::vector<std::string>& header, const std::string& path) {
  for (const char* needed : {"tc_s", "censored"}) {
    require(std::find(header.begin(), header.end(), needed) != header.end(), path,
            fmt::format("has no column {}; expected the header {}", needed,
                        fmt::join(kColumns, ",")));
  }
  for (const std::string& name : kColumns) {
    require(std::count(header.begin(), header.end(), name) <= 1, path,
            fmt::format("has the column {} twice", name));
  }
}

statistics::RealisationOutcome outcome_of(const Row& row, std::size_t number) {
  statistics::RealisationOutcome outcome;
  const double index = row.number("idx").value_or(static_cast<double>(number));
  require(index >= 0.0 && index == std::floor(index) && index < 9e15, row.where(),
          fmt::format("idx is {}, expected a whole number from 0", index));
  outcome.index = static_cast<std::uint64_t>(index);
  const auto censored = row.number("censored");
  require(censored && (*censored == 0.0 || *censored == 1.0), row.where(),
          "censored is neither 0 nor 1");
  const auto time = row.number("tc_s");
  require(time.has_value(), row.where(),
          *censored == 1.0
              ? "tc_s is missing; of a censored realisation it is the time it reached"
              : "tc_s is missing");
  outcome.end = *time;
  outcome.t1 = row.number("t1_s");
  outcome.alpha_deg = row.number("alpha_deg");
  if (*censored == 0.0) {
    outcome.tc = *time;
  }
  require(*time >= 0.0 && outcome.t1.value_or(0.0) >= 0.0, row.where(),
          "has a negative time");
  require(
      outcome.t1.value_or(0.0) <= *time, row.where(),
      fmt::format("t1_s is {}, later than tc_s, {}", outcome.t1.value_or(0.0), *time));
  return outcome;
}

}  // namespace

std::vector<statistics::RealisationOutcome> read_sample(const std::string& text,
                                                        const std::string& path) {
  std::vector<std::string> header;
  std::vector<statistics::RealisationOutcome> outcomes;
  std::set<std::uint64_t> seen;
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++line_number;
    if (trimmed(line).empty()) {
      continue;
    }
    if (header.empty()) {
      header = fields_of(line);
      check_header(header, path);
      continue;
    }
    const Row row(header, fields_of(line), fmt::format("{} line {}", path, line_number));
    outcomes.push_back(outcome_of(row, outcomes.size()));
    require(seen.insert(outcomes.back().index).second, row.where(),
            fmt::format("idx {} stands there twice", outcomes.back().index));
  }
  require(!outcomes.empty(), path, "holds no realisation");
  return outcomes;
}

}  // namespace colloid
