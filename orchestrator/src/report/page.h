// The report: one HTML file that needs no other file and no network.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace colloid {

/// Style, scripts, library and content in one file.  No text of the content can end the
/// element that holds it or become markup: the scripts set text, never HTML.
std::string report_page(const nlohmann::ordered_json& content);

/// `text` with the characters that HTML reserves escaped.
std::string html_escaped(const std::string& text);

}  // namespace colloid
