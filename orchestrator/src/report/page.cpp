#include "report/page.h"

#include <array>
#include <utility>

// Written by cmake/EmbedText.cmake from the files in page/.
#include "d3_js.h"
#include "page_css.h"
#include "page_figures_js.h"
#include "page_html.h"
#include "page_js.h"
#include "plot_js.h"

namespace colloid {

namespace {

/// The content as JSON inside a script element: with every < written as \u003c no text
/// in it can end the element or begin a comment.
std::string embedded(const nlohmann::ordered_json& content) {
  const std::string json =
      content.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string html_escaped(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string report_page(const nlohmann::ordered_json& content) {
  const std::string campaign = content.value("campaign", std::string());
  const std::array<std::pair<std::string, std::string>, 7> parts{{
      {"TITLE", html_escaped(campaign)},
      {"STYLE", kPageCss},
      {"CONTENT", embedded(content)},
      {"D3", kD3Js},
      {"PLOT", kPlotJs},
      {"FIGURES", kPageFiguresJs},
      {"SCRIPT", kPageJs},
  }};
  // One pass over the frame: what is put in is never looked at again.
  const std::string frame = kPageHtml;
  std::string page;
  for (std::size_t at = 0; at < frame.size();) {
    const std::size_t mark = frame.find("@@", at);
    page += frame.substr(at, mark - at);
    if (mark == std::string::npos) {
      break;
    }
    const std::size_t end = frame.find("@@", mark + 2);
    const std::string name = frame.substr(mark + 2, end - mark - 2);
    for (const auto& [key, text] : parts) {
      page += key == name ? text : "";
    }
    at = end + 2;
  }
  return page;
}

}  // namespace colloid
