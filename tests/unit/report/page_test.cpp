// No text of a campaign can become markup of its report.
#include "report/page.h"

#include <string>

#include <gtest/gtest.h>

namespace colloid {
namespace {

using Json = nlohmann::ordered_json;

std::string embedded_json(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="content">)";
  const std::size_t begin = page.find(open) + open.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

TEST(ReportPage, HoldsTheContentUnchanged) {
  const Json content{{"campaign", "c"},
                     {"description", "</script><script>alert(1)</script> <!-- & \" '"},
                     {"points", Json::array({1.25, nullptr})}};
  const std::string page = report_page(content);
  EXPECT_EQ(Json::parse(embedded_json(page)), content);
  EXPECT_EQ(page.find("<script>alert(1)"), std::string::npos);
}

TEST(ReportPage, LeavesMarksInTheContentAlone) {
  const std::string page = report_page({{"campaign", "@@D3@@"}, {"description", "@@"}});
  EXPECT_NE(page.find("<title>@@D3@@ - poreclog report</title>"), std::string::npos);
  EXPECT_EQ(Json::parse(embedded_json(page))["campaign"], "@@D3@@");
}

TEST(ReportPage, EscapesTheTitle) {
  const std::string page = report_page({{"campaign", "</title><b>\"x'&"}});
  EXPECT_NE(page.find("<title>&lt;/title&gt;&lt;b&gt;&quot;x&#39;&amp; - "),
            std::string::npos);
}

TEST(ReportPage, ReplacesWhatIsNotUtf8) {
  const std::string page = report_page({{"campaign", "c"}, {"description", "a\xff"}});
  EXPECT_EQ(Json::parse(embedded_json(page))["description"], "a\xEF\xBF\xBD");
}

TEST(ReportPage, NeedsNoOtherFile) {
  const std::string page = report_page({{"campaign", "c"}});
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("<link rel=\"stylesheet"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"),
            std::string::npos);  // nor may it ask for one
}

}  // namespace
}  // namespace colloid
