#include "scene/sphere_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "core/text_file.h"
#include "scene/solid.h"

namespace colloid {

namespace {

constexpr std::array<const char*, 4> kColumns{"x_m", "y_m", "z_m", "diameter_m"};
constexpr double kLargestLength = 100.0;  // [m] as for lengths in a scene

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split_row(std::string_view row, const std::string& where) {
  require(row.find('"') == std::string_view::npos, where,
          "has a quoted cell, expected plain numbers and names between commas");
  std::vector<std::string> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = row.find(',', begin);
    // substr takes what there is when there is no further comma
    cells.emplace_back(trimmed(row.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) {
      return cells;
    }
    begin = comma + 1;
  }
}

/// The place of each of kColumns in the header.
std::array<std::size_t, 4> find_columns(const std::vector<std::string>& header,
                                        const std::string& where) {
  std::array<std::size_t, 4> places{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const auto count = std::count(header.begin(), header.end(), kColumns[i]);
    require(count > 0, where,
            fmt::format("the header has no column {}, expected {}; the nearest is {}",
                        kColumns[i], fmt::join(kColumns, ","),
                        in_quotes(nearest(kColumns[i], header))));
    require(count == 1, where,
            fmt::format("the header names the column {} {} times", kColumns[i], count));
    places[i] = static_cast<std::size_t>(
        std::find(header.begin(), header.end(), kColumns[i]) - header.begin());
  }
  return places;
}

double read_cell(const std::string& cell, const char* column, const std::string& where) {
  const char* begin = cell.data() + (!cell.empty() && cell[0] == '+' ? 1 : 0);
  const char* end = cell.data() + cell.size();
  double value = 0.0;
  const auto result = std::from_chars(begin, end, value);
  require(
      result.ec == std::errc{} && result.ptr == end && std::isfinite(value), where, [&] {
        return fmt::format("{} is {}, expected a finite number", column, in_quotes(cell));
      });
  require(std::abs(value) <= kLargestLength, where, [&] {
    return fmt::format("{} is {}, must be in [-{:g}, {:g}] m", column, cell,
                       kLargestLength, kLargestLength);
  });
  return value;
}

}  // namespace

std::vector<Sphere> read_sphere_table(const std::string& path, const Box& box) {
  const std::string text = read_text_file(path);
  std::vector<Sphere> spheres;
  std::array<std::size_t, 4> places{};
  std::size_t width = 0;  // columns; 0 before the header
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view row =
        trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    ++line;
    if (row.empty()) {
      continue;
    }
    const std::string where = fmt::format("{} line {}", path, line);
    const std::vector<std::string> cells = split_row(row, where);
    if (width == 0) {
      places = find_columns(cells, where);
      width = cells.size();
      continue;
    }
    require(cells.size() == width, where, [&] {
      return fmt::format("has {} columns, expected the {} of the header", cells.size(),
                         width);
    });
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = read_cell(cells[places[i]], kColumns[i], where);
    }
    require(values[3] > 0.0, where, [&] {
      return fmt::format("diameter_m is {}, must be in (0, {:g}] m", shortest(values[3]),
                         kLargestLength);
    });
    spheres.push_back({{values[0], values[1], values[2]}, 0.5 * values[3]});
    require(reaches_into(box, spheres.back()), where,
            "the sphere is entirely outside the box");
  }
  return spheres;
}

}  // namespace colloid
