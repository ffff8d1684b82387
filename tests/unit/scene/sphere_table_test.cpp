#include "scene/sphere_table.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

std::vector<Sphere> read(const std::string& text) {
  const std::string path = testing::TempDir() + "table.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_sphere_table(path, {{1.0, 1.0, 1.0}, {}});
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SphereTable, FindsItsColumnsByNameAndIgnoresOthers) {
  const auto spheres = read(
      "order, diameter_m ,z_m,layer,y_m,x_m\r\n"
      "1,0.2,0.3,first,0.4,+0.5\r\n"
      "\r\n"
      "2,2e-1,-.05,wall,4E-1,5e-1");
  ASSERT_EQ(spheres.size(), 2U);
  EXPECT_EQ(spheres[0].center, (Vec3{0.5, 0.4, 0.3}));
  EXPECT_EQ(spheres[0].radius, 0.1);
  EXPECT_EQ(spheres[1].center.z, -0.05);
}

TEST(SphereTable, MayBeEmptyButForItsHeader) {
  EXPECT_TRUE(read("x_m,y_m,z_m,diameter_m\n").empty());
}

TEST(SphereTable, RefusesTheFirstBadLineByNumber) {
  const std::string header = "x_m,y_m,z_m,diameter_m\n0,0,0,0.1\n";
  const std::pair<std::string, const char*> cases[] = {
      {"0,0,0\n", "has 3 columns, expected the 4 of the header"},
      {"0,0,0,0.1,9\n", "has 5 columns"},
      {"0,0,zero,0.1\n", "z_m is \"zero\", expected a finite number"},
      {"0,,0,0.1\n", "y_m is \"\", expected a finite number"},
      {"nan,0,0,0.1\n", "x_m is \"nan\", expected a finite number"},
      {"0,0,0,inf\n", "diameter_m is \"inf\", expected a finite number"},
      {"0,0,0,1e999\n", "diameter_m is \"1e999\", expected a finite number"},
      {"0,0,0,0.1 m\n", "diameter_m is \"0.1 m\", expected a finite number"},
      {"0,0,0,0\n", "diameter_m is 0, must be in (0, 100] m"},
      {"0,0,0,-1\n", "diameter_m is -1, must be in (0, 100] m"},
      {"1e9,0,0,0.1\n", "x_m is 1e9, must be in [-100, 100] m"},
      {"0,0,\"0\",0.1\n", "has a quoted cell"},
      {"5,0,0,0.1\n", "the sphere is entirely outside the box"},
  };
  for (const auto& [row, why] : cases) {
    EXPECT_THAT(refusal(header + row), HasSubstr(why)) << row;
    EXPECT_THAT(refusal(header + row), HasSubstr("table.csv line 3: ")) << row;
  }
}

TEST(SphereTable, RefusesAHeaderWithoutItsColumns) {
  EXPECT_THAT(refusal("0,0,0,1\n"), HasSubstr("line 1: the header has no column x_m"));
  EXPECT_THAT(
      refusal("x_m,y_m,z_m,diameter\n"),
      HasSubstr("no column diameter_m, expected x_m,y_m,z_m,diameter_m; the nearest "
                "is \"diameter\""));
  EXPECT_THAT(refusal("x_m,x_m,y_m,z_m,diameter_m\n"),
              HasSubstr("names the column x_m 2"));
}

}  // namespace
}  // namespace colloid
