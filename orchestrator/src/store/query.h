// Questions to the database, asked through a connection that cannot write.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace colloid {

struct QueryResult {
  std::vector<std::string> columns;
  std::vector<std::vector<nlohmann::json>> rows;  ///< null, number or text
};

/// One statement that reads.  `:campaign` in it stands for `campaign`.  InputError if it
/// is no such statement, StorageError if there is no such database.
QueryResult ask(const std::string& database, const std::string& sql,
                const std::string& campaign);

/// A question with a name.
struct CannedQuery {
  const char* name;
  const char* summary;
  const char* sql;
};

/// All of them; each takes `:campaign`.
const std::vector<CannedQuery>& canned_queries();

}  // namespace colloid
