#include "store/database.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"

namespace colloid {

namespace {

constexpr int kPatience = 60'000;  // [ms] for another writer, or a reader in our way

[[noreturn]] void fail(sqlite3* connection, const std::string& what) {
  throw StorageError(fmt::format("database {}: {}", what, sqlite3_errmsg(connection)));
}

}  // namespace

Statement::Statement(sqlite3* connection, std::string_view sql)
    : handle_(nullptr, &sqlite3_finalize) {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v3(connection, sql.data(), static_cast<int>(sql.size()),
                         SQLITE_PREPARE_PERSISTENT, &raw, nullptr) != SQLITE_OK) {
    fail(connection, "statement");
  }
  handle_.reset(raw);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) {
    fail(sqlite3_db_handle(handle_.get()), "statement");
  }
}

Statement& Statement::reset() {
  sqlite3_reset(handle_.get());
  return *this;
}

Statement& Statement::bind(int at, std::int64_t value) {
  check(sqlite3_bind_int64(handle_.get(), at, value));
  return *this;
}

Statement& Statement::bind(int at, std::string_view value) {
  check(sqlite3_bind_text(handle_.get(), at, value.data(), static_cast<int>(value.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(int at, double value) {
  check(std::isfinite(value) ? sqlite3_bind_double(handle_.get(), at, value)
                             : sqlite3_bind_null(handle_.get(), at));
  return *this;
}

Statement& Statement::bind_null(int at) {
  check(sqlite3_bind_null(handle_.get(), at));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    fail(sqlite3_db_handle(handle_.get()), "write");
  }
  return code == SQLITE_ROW;
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(handle_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

double Statement::real(int column) const {
  return is_null(column) ? std::nan("") : sqlite3_column_double(handle_.get(), column);
}

std::string Statement::text(int column) const {
  const unsigned char* begin = sqlite3_column_text(handle_.get(), column);
  const int length = sqlite3_column_bytes(handle_.get(), column);
  return begin == nullptr ? ""
                          : std::string(reinterpret_cast<const char*>(begin),
                                        static_cast<std::size_t>(length));
}

Database::Database(const std::string& path, Access access)
    : path_(path), handle_(nullptr, &sqlite3_close) {
  // Nobody asks how much memory SQLite has taken: counting costs at every allocation.
  // Refused (and harmless) once the library is in use, by an earlier connection.
  sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
  sqlite3* raw = nullptr;
  // One thread uses a connection: its locks would only cost time.
  const int flags =
      SQLITE_OPEN_NOMUTEX |
      (access == Access::read_only ? SQLITE_OPEN_READONLY
                                   : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  const int code = sqlite3_open_v2(path.c_str(), &raw, flags, nullptr);
  handle_.reset(raw);
  if (code != SQLITE_OK) {
    fail(raw, path);
  }
  sqlite3_busy_timeout(raw, kPatience);
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(connection(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail(connection(), path_);
  }
}

Transaction::Transaction(Database& database) : database_(database) {
  if (!database_.begin_) {
    database_.begin_ = database_.prepare("BEGIN IMMEDIATE");
    database_.commit_ = database_.prepare("COMMIT");
  }
  database_.begin_->reset().run();
}

Transaction::~Transaction() {
  if (open_) {
    sqlite3_exec(database_.connection(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  database_.commit_->reset().run();
  open_ = false;
}

}  // namespace colloid
