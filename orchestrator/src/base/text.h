// Words for messages and command lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace colloid {

/// `text` in double quotes on one line: control characters escaped, a long text cut.
std::string in_quotes(std::string_view text);

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& words);

/// The candidate with the fewest edits (insert, delete, replace) from `word`, capitals
/// counting less than any edit, the first of equals.  Precondition: there is a candidate.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `word` as one word of a POSIX shell's command line.
std::string shell_quoted(const std::string& word);

/// The words as a command line that a POSIX shell splits into them again.
std::string command_line(const std::vector<std::string>& words);

/// "12 s", "3 min 20 s", "5 h 10 min": what a person wants to know.
std::string duration_text(double seconds);

}  // namespace colloid
