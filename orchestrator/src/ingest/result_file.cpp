#include "ingest/result_file.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "base/hash.h"
#include "ingest/hdf5_file.h"

namespace colloid {

namespace {

template <class Value>
Value must(std::optional<Value> value, const char* name) {
  if (!value) {
    throw TornResult(fmt::format("{} is missing or cannot be read", name));
  }
  return std::move(*value);
}

H5Handle group_of(hid_t file, const char* name) {
  return must(open_group(file, name), name);
}

/// A column of `rows` rows with `width` numbers in each; rows of NaN if it is left out.
std::vector<double> column(hid_t group, const char* name, std::size_t rows,
                           std::size_t width = 1) {
  auto values = numbers(group, name);
  if (!values) {
    return std::vector<double>(rows * width, kUndefined);
  }
  if (values->size() != rows * width) {
    throw TornResult(fmt::format("{} has {} numbers, expected {}", name, values->size(),
                                 rows * width));
  }
  return std::move(*values);
}

std::vector<std::string> word_column(hid_t group, const char* name, std::size_t rows) {
  auto values = words(group, name);
  if (!values) {
    return std::vector<std::string>(rows);
  }
  if (values->size() != rows) {
    throw TornResult(
        fmt::format("{} has {} rows, expected {}", name, values->size(), rows));
  }
  return std::move(*values);
}

std::uint64_t seed_of_text(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw TornResult("the seed is not an unsigned integer of 64 bits");
  }
  return seed;
}

void read_outcome(hid_t file, ResultRecord& result) {
  const auto complete = number_attribute(file, "complete");
  if (!complete || *complete != 1.0) {
    throw TornResult("it does not say that it is complete");
  }
  auto seed = text_attribute(file, "seed");
  seed = seed ? seed : text_attribute(file, "seed_text");
  result.seed = seed_of_text(must(seed, "seed"));
  result.tier = must(text_attribute(file, "tier"), "tier");
  result.ending = must(text_attribute(file, "ending"), "ending");
  result.t1 = must(number_attribute(file, "t1_s"), "t1_s");
  result.tc = must(number_attribute(file, "tc_s"), "tc_s");
  result.alpha_deg = must(number_attribute(file, "alpha_deg"), "alpha_deg");
  result.last_traversal = number_attribute(file, "last_traversal_s").value_or(kUndefined);
  result.duration = number_attribute(file, "duration_s").value_or(kUndefined);
}

void read_series(hid_t file, ResultRecord& result) {
  const H5Handle group = group_of(file, "series");
  result.times = must(numbers(group.get(), "time_s"), "series/time_s");
  const std::size_t rows = result.times.size();
  if (!std::is_sorted(result.times.begin(), result.times.end())) {
    throw TornResult("series/time_s does not ascend");
  }
  result.critical_diameter = column(group.get(), "critical_diameter_m", rows);
  result.permeability_ratio = column(group.get(), "permeability_ratio", rows);
}

void read_retained(hid_t file, ResultRecord& result) {
  const H5Handle group = group_of(file, "retained");
  const auto time = must(numbers(group.get(), "time_s"), "retained/time_s");
  const std::size_t rows = time.size();
  result.retained.resize(rows);
  if (rows == 0) {
    return;
  }
  const auto read = [&](const char* name, std::size_t width = 1) {
    return column(group.get(), name, rows, width);
  };
  const auto order = read("order");
  const auto colloid = read("colloid");
  const auto contact = read("contact_time_s");
  const auto position = read("position_m", 3);
  const auto injection = read("injection_position_m", 3);
  const auto injection_time = read("injection_time_s");
  const auto alpha = read("alpha_deg");
  const auto load = read("bond_load_N");
  auto layer = word_column(group.get(), "layer", rows);
  auto mechanism = word_column(group.get(), "mechanism", rows);
  for (std::size_t i = 0; i < rows; ++i) {
    RetainedRecord& out = result.retained[i];
    out.order = static_cast<std::int64_t>(i) + 1;
    if (!(order[i] == static_cast<double>(out.order))) {
      throw TornResult("retained/order is not 1, 2, 3, ...");
    }
    out.colloid = colloid[i] >= 0.0 ? static_cast<std::int64_t>(colloid[i]) : -1;
    out.time = time[i];
    out.contact_time = contact[i];
    std::copy_n(&position[3 * i], 3, out.position);
    std::copy_n(&injection[3 * i], 3, out.injection_position);
    out.injection_time = injection_time[i];
    out.layer = std::move(layer[i]);
    out.mechanism = std::move(mechanism[i]);
    out.alpha_deg = alpha[i];
    out.bond_load = load[i];
  }
}

/// A count at the root, else the last row of the series, else -1.
std::int64_t count_of(hid_t file, const char* name) {
  if (const auto count = number_attribute(file, name)) {
    return static_cast<std::int64_t>(*count);
  }
  const H5Handle group = group_of(file, "series");
  const auto rows = numbers(group.get(), name);
  return rows && !rows->empty() ? static_cast<std::int64_t>(rows->back()) : -1;
}

void read_provenance(hid_t file, ResultRecord& result) {
  const auto group = open_group(file, "provenance");
  if (!group) {
    return;
  }
  const auto text = [&](const char* name) {
    return text_attribute(group->get(), name).value_or("");
  };
  result.program = {text("version"),        text("commit"),       text("compiler"),
                    text("compiler_flags"), text("hdf5_version"), text("hostname"),
                    text("cpu_model")};
  const auto scene = words(group->get(), "scene");
  result.scene = scene && scene->size() == 1 ? scene->front() : text("scene");
}

/// Everything the seed determines, as bytes in a fixed order.
std::string digest_of(const ResultRecord& r) {
  std::string bytes = fmt::format("{}\n{}\n{}\n{} {} {}\n", r.seed, r.tier, r.ending,
                                  r.injected, r.retained_count, r.traversed);
  bytes.reserve(bytes.size() + 24 * r.times.size() + 200 * r.retained.size() + 100);
  const auto add = [&](const double* begin, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      // One NaN is as good as another.
      const double value = std::isnan(begin[i]) ? kUndefined : begin[i];
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  };
  for (const double* value :
       {&r.duration, &r.t1, &r.tc, &r.alpha_deg, &r.last_traversal}) {
    add(value, 1);
  }
  for (const auto* values : {&r.times, &r.critical_diameter, &r.permeability_ratio}) {
    add(values->data(), values->size());
  }
  for (const RetainedRecord& c : r.retained) {
    fmt::format_to(std::back_inserter(bytes), "{} {} {} {}\n", c.order, c.colloid,
                   c.layer, c.mechanism);
    for (const double* value :
         {&c.time, &c.contact_time, &c.injection_time, &c.alpha_deg, &c.bond_load}) {
      add(value, 1);
    }
    add(c.position, 3);
    add(c.injection_position, 3);
  }
  return sha256(bytes);
}

}  // namespace

ResultRecord read_result(const std::string& path) {
  const auto file = open_hdf5(path);
  if (!file) {
    throw TornResult("it is not a whole HDF5 file");
  }
  ResultRecord result;
  read_outcome(file->get(), result);
  read_series(file->get(), result);
  read_retained(file->get(), result);
  result.injected = count_of(file->get(), "injected");
  result.retained_count = static_cast<std::int64_t>(result.retained.size());
  result.traversed = count_of(file->get(), "traversed");
  read_provenance(file->get(), result);
  result.digest = digest_of(result);
  return result;
}

}  // namespace colloid
