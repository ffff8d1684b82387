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

/// The answer as it comes: it may have a row for every realisation of a large campaign.
class Printer {
 public:
  Printer(const std::string& database, const std::string& sql,
          const std::string& campaign)
      : ask_([=](const auto& columns, const auto& row) {
          ask(database, sql, campaign, columns, row);
        }) {}

  void csv() const {
    ask_([](const auto& columns) { csv_row(columns, [](const auto& c) { return c; }); },
         [](const Row& row) { csv_row(row, cell); });
  }

  /// Asks twice: the widths of the columns first.
  void table() const {
    std::vector<std::size_t> widths;
    ask_(
        [&](const auto& columns) {
          widths.reserve(columns.size());
          for (const std::string& name : columns) {
            widths.push_back(name.size());
          }
        },
        [&](const Row& row) {
          for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], cell(row[i]).size());
          }
        });
    ask_(
        [&](const auto& columns) {
          table_row(Row(columns.begin(), columns.end()), widths);
        },
        [&](const Row& row) { table_row(row, widths); });
  }

  void json_value() const {
    std::vector<std::string> names;
    const char* separator = "\n";
    ask_(
        [&](const auto& columns) {
          names = columns;
          std::cout << "{\"schema_version\": 1,\n \"columns\": " << json(names).dump()
                    << ",\n \"rows\": [";
        },
        [&](const Row& row) {
          nlohmann::ordered_json object = nlohmann::ordered_json::object();
          for (std::size_t i = 0; i < row.size(); ++i) {
            object[names[i]] = row[i];
          }
          std::cout << separator
                    << object.dump(-1, ' ', false, json::error_handler_t::replace);
          separator = ",\n";
        });
    std::cout << "]}\n";
  }

 private:
  using TakeColumns = std::function<void(const std::vector<std::string>&)>;
  using TakeRow = std::function<void(Row&)>;

  template <class Values, class TextOf>
  static void csv_row(const Values& values, TextOf text_of) {
    std::string line;
    for (std::size_t i = 0; i < values.size(); ++i) {
      line += (i == 0 ? "" : ",") + csv_field(text_of(values[i]));
    }
    std::cout << line << "\r\n";
  }

  static void table_row(const Row& row, const std::vector<std::size_t>& widths) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string text = cell(row[i]);
      line += i == 0 ? "" : "  ";
      line += row[i].is_number() ? fmt::format("{:>{}}", text, widths[i])
                                 : fmt::format("{:<{}}", text, widths[i]);
    }
    std::cout << line << "\n";
  }

  std::function<void(const TakeColumns&, const TakeRow&)> ask_;
};

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
    const Printer printer(database, statement, campaign);
    common_.json ? printer.json_value() : csv_ ? printer.csv() : printer.table();
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
