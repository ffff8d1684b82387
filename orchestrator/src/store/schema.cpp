#include "store/schema.h"

#include <array>

#include <fmt/format.h>

#include "base/error.h"
#include "results_sql.h"  // written by CMake from schemas/results.sql

namespace colloid {

namespace {

constexpr std::int64_t kApplication = 0x706f7265;  // "pore", in the file's header

/// Statements that bring a database from version i + 1 to i + 2.
constexpr std::array<const char*, kSchemaVersion - 1> kMigrations{};

std::int64_t pragma(const Database& database, const char* name) {
  Statement statement = database.prepare(fmt::format("PRAGMA {}", name));
  statement.step();
  return statement.integer(0);
}

bool is_empty(const Database& database) {
  Statement count = database.prepare("SELECT count(*) FROM sqlite_schema");
  count.step();
  return count.integer(0) == 0;
}

}  // namespace

const char* schema_sql() {
  return kResultsSql;
}

void check_schema(const Database& database) {
  require(pragma(database, "application_id") == kApplication, database.path(),
          "is not a results database of poreclog");
  const std::int64_t version = pragma(database, "user_version");
  require(version <= kSchemaVersion, database.path(),
          fmt::format("has schema version {}, this program knows {} and older: use the "
                      "program that wrote it, or another --database",
                      version, kSchemaVersion));
}

void prepare_schema(Database& database) {
  Transaction transaction(database);
  if (is_empty(database)) {
    database.execute(schema_sql());
    database.execute(fmt::format("PRAGMA application_id = {}", kApplication));
    database.execute(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
  }
  check_schema(database);
  for (auto version = static_cast<std::size_t>(pragma(database, "user_version"));
       version < kSchemaVersion; ++version) {
    database.execute(kMigrations.at(version - 1));
    database.execute(fmt::format("PRAGMA user_version = {}", version + 1));
  }
  transaction.commit();
}

}  // namespace colloid
