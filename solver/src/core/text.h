// Words for messages: the user's text made printable, and the nearest known word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace colloid {

/// `text` on one line: control characters escaped, a long text cut short.
std::string printable(std::string_view text);

/// The same in double quotes.
std::string in_quotes(std::string_view text);

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& words);

/// Edits (insert, delete, replace, swap of neighbours; case ignored) from `a` to `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the fewest edits from `word`, the first of equals.
/// Precondition: there is a candidate.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `number` with as many digits as tell it from its neighbours, and no more.
std::string shortest(double number);

}  // namespace colloid
