// Files that are whole or absent, and folders that are there.
#pragma once

#include <optional>
#include <string>

namespace colloid {

/// The text of a file that a user named.  InputError if it cannot be read.
std::string read_text_file(const std::string& path);

/// The content of one of our own files; none if there is no such file.
std::optional<std::string> read_if_there(const std::string& path);

/// Is there a file of that name?
bool is_file(const std::string& path);

/// Writes `text` to a temporary name, then renames it over `path`: a reader sees the old
/// content or the new.  `durable` waits for the disk.  StorageError if it fails.
void write_whole(const std::string& path, const std::string& text, bool durable);

/// Writes a file that is not there yet and that nobody looks for before it is whole.
void write_new(const std::string& path, const std::string& text);

/// Makes the folder and those above it.  StorageError naming it and the reason.
void make_folder(const std::string& path);

/// Makes one folder; false if it is there already.
bool claim_folder(const std::string& path);

/// `path`, absolute, without "." and "..".
std::string absolute(const std::string& path);

}  // namespace colloid
