// The schema of the results database, schemas/results.sql, and its version.
#pragma once

#include "store/database.h"

namespace colloid {

constexpr int kSchemaVersion = 1;

/// Makes the tables in an empty database, migrates an older one, refuses a newer one and
/// one that is not ours (InputError).
void prepare_schema(Database& database);

/// Refuses a database that this version cannot read (InputError).
void check_schema(const Database& database);

/// The text of schemas/results.sql.
const char* schema_sql();

}  // namespace colloid
