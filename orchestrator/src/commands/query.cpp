#include "commands/query.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "commands/open_campaign.h"
#include "store/query.h"

namespace colloid {

namespace {

using nlohmann::json;

const CannedQuery* canned(const std::string& name) {
  const auto& all = canned_queries();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const CannedQuery& q) { return q.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// A statement has words; names of questions and campaigns have none.
bool is_statement(const std::string& word) {
  return word.find_first_of(" \t\n(") != std::string::npos;
}

std::string cell(const json& value) {
  if (value.is_null()) {
    return "";
  }
  if (value.is_number_float()) {
    return fmt::format("{}", value.get<double>());
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// RFC 4180.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string out = "\"";
  for (const char c : text) {
    out += c == '"' ? "\"\"" : std::string(1, c);
  }
  return out + "\"";
}

std::string csv(const QueryResult& result) {
  std::string out;
  const auto add_row = [&](const auto& row, const auto& text_of) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += (i == 0 ? "" : ",") + csv_field(text_of(row[i]));
    }
    out += "\r\n";
  };
  add_row(result.columns, [](const std::string& name) { return name; });
  for (const auto& row : result.rows) {
    add_row(row, cell);
  }
  return out;
}

std::string table(const QueryResult& result) {
  std::vector<std::size_t> widths;
  widths.reserve(result.columns.size());
  for (const std::string& name : result.columns) {
    widths.push_back(name.size());
  }
  for (const auto& row : result.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], cell(row[i]).size());
    }
  }
  std::string out;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    out += fmt::format("{}{:<{}}", i == 0 ? "" : "  ", result.columns[i], widths[i]);
  }
  out += "\n";
  for (const auto& row : result.rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string text = cell(row[i]);
      out += i == 0 ? "" : "  ";
      out += row[i].is_number() ? fmt::format("{:>{}}", text, widths[i])
                                : fmt::format("{:<{}}", text, widths[i]);
    }
    out += "\n";
  }
  return out;
}

std::string json_text(const QueryResult& result) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& row : result.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      object[result.columns[i]] = row[i];
    }
    rows.push_back(std::move(object));
  }
  const nlohmann::ordered_json out{
      {"schema_version", 1}, {"columns", result.columns}, {"rows", rows}};
  return out.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string list_of_questions() {
  std::string out = "Questions by name (poreclog query CAMPAIGN NAME):\n";
  for (const CannedQuery& query : canned_queries()) {
    out += fmt::format("  {:<14}{}\n", query.name, query.summary);
  }
  return out;
}

class Query : public Command {
 public:
  void declare_options(CLI::App& app) override {
    common_.declare(app);
    app.add_option("words", words_,
                   "[CAMPAIGN] and a SELECT or the name of a question; :campaign in the "
                   "SELECT stands for the campaign")
        ->expected(0, 2);
    auto* list = app.add_flag("--list", list_, "List the questions that have names");
    app.add_flag("--csv", csv_, "Comma-separated values (RFC 4180)");
    app.add_flag("--sql", sql_, "Print the SELECT of a question instead of asking it");
    list->excludes("--csv");
  }

  int run() override {
    if (list_ || words_.empty()) {
      std::cout << list_of_questions();
      return exit_done;
    }
    std::string statement = words_.back();
    if (!is_statement(statement)) {
      std::vector<std::string> names;
      for (const CannedQuery& query : canned_queries()) {
        names.emplace_back(query.name);
      }
      const CannedQuery* known = canned(statement);
      require(
          known != nullptr, "query",
          fmt::format("{} is neither a SELECT nor the name of a question; the nearest "
                      "is \"{}\"",
                      in_quotes(statement), nearest(statement, names)));
      statement = known->sql;
    }
    if (sql_) {
      std::cout << statement << "\n";
      return exit_done;
    }
    const std::string campaign = words_.size() > 1 ? campaign_name(words_[0]) : "";
    const std::string database = absolute(common_.database);
    require(is_file(database), "--database",
            fmt::format("there is no {}", common_.database));
    const QueryResult result = ask(database, statement, campaign);
    std::cout << (common_.json ? json_text(result) : csv_ ? csv(result) : table(result));
    return exit_done;
  }

 private:
  CommonOptions common_;
  std::vector<std::string> words_;
  bool list_ = false;
  bool csv_ = false;
  bool sql_ = false;
};

}  // namespace

std::unique_ptr<Command> make_query() {
  return std::make_unique<Query>();
}

}  // namespace colloid
