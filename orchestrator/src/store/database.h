// SQLite behind RAII: a connection, a statement, a transaction.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <sqlite3.h>

namespace colloid {

/// A prepared statement.  Parameters and columns count from 1 and 0, as in SQLite.
class Statement {
 public:
  Statement(sqlite3* connection, std::string_view sql);

  /// Makes ready for other parameters.
  Statement& reset();
  Statement& bind(int at, std::int64_t value);
  Statement& bind(int at, int value) { return bind(at, std::int64_t{value}); }
  Statement& bind(int at, std::string_view value);
  Statement& bind(int at, const char* value) { return bind(at, std::string_view(value)); }
  /// NaN and infinity become NULL.
  Statement& bind(int at, double value);
  template <class Value>
  Statement& bind(int at, const std::optional<Value>& value) {
    return value ? bind(at, *value) : bind_null(at);
  }
  Statement& bind_null(int at);

  /// Advances to the next row; false at the end.
  bool step();
  /// reset() after stepping to the end: for statements that give no rows.
  void run();

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;  ///< NaN for NULL
  std::string text(int column) const;

  sqlite3_stmt* handle() const { return handle_.get(); }

 private:
  void check(int code) const;

  std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> handle_;
};

class Transaction;

class Database {
 public:
  enum class Access { read_only, read_write };

  /// StorageError if it cannot be opened.  read_write makes the file, and waits as long
  /// as a minute for others.
  Database(const std::string& path, Access access);

  void execute(const std::string& sql);
  Statement prepare(std::string_view sql) const { return {connection(), sql}; }
  std::int64_t last_row() const { return sqlite3_last_insert_rowid(connection()); }
  sqlite3* connection() const { return handle_.get(); }
  const std::string& path() const { return path_; }

 private:
  friend class Transaction;

  std::string path_;
  std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle_;
  std::optional<Statement> begin_;  ///< prepared at the first transaction
  std::optional<Statement> commit_;
};

/// Everything between construction and commit(), or nothing.
class Transaction {
 public:
  /// Takes the write lock at once, so that no other writer makes it fail half way.
  explicit Transaction(Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace colloid
