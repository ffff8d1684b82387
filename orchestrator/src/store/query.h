// Questions to the database, asked through a connection that cannot write.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace colloid {

using Row = std::vector<nlohmann::json>;  ///< null, number or text

struct QueryResult {
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// One statement that reads.  `:campaign` in it stands for `campaign`.  InputError if it
/// is no such statement, StorageError if there is no such database.
QueryResult ask(const std::string& database, const std::string& sql,
                const std::string& campaign);

/// The same, row by row: an answer may be larger than memory.
void ask(const std::string& database, const std::string& sql, const std::string& campaign,
         const std::function<void(const std::vector<std::string>&)>& take_columns,
         const std::function<void(Row&)>& take_row);

/// A question with a name.
struct CannedQuery {
  const char* name;
  const char* summary;
  const char* sql;
};

/// All of them; each takes `:campaign`.
const std::vector<CannedQuery>& canned_queries();

}  // namespace colloid
