#include "core/quantity.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/constants.h"
#include "core/error.h"

namespace colloid {
namespace {

using testing::HasSubstr;

constexpr double kTemperature = 298.0;  // [K]

double si(const std::string& text, const std::string& unit) {
  return parse_quantity(text, unit, kTemperature, "/here");
}

std::string refusal(const std::string& text, const std::string& unit) {
  try {
    parse_quantity(text, unit, kTemperature, "/here");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

struct Accepted {
  std::string text;
  std::string unit;
  double value;
};

// The literals on the right are rounded once by the compiler, so equality means that
// reading rounds once too.
TEST(Quantity, IsTheDoubleNearestToWhatIsWritten) {
  const Accepted cases[] = {
      {"13.3 um", "m", 13.3e-6},
      {"13.3um", "m", 13.3e-6},
      {"  13.3   um ", "m", 13.3e-6},
      {"13.3 \xC2\xB5m", "m", 13.3e-6},
      {"13.3 \xCE\xBCm", "m", 13.3e-6},
      {"96.6 um", "m", 96.6e-6},
      {"3 \xC3\x85", "m", 3e-10},
      {"+.5 m", "m", 0.5},
      {"5. m", "m", 5.0},
      {"1.5E+3 nm", "m", 1.5e-6},
      {"0.5 mm/s", "m/s", 0.5e-3},
      {"300 mM", "mol/m^3", 300.0},
      {"0.1 mol/L", "mol/m^3", 100.0},
      {"-27.9 mV", "V", -27.9e-3},
      {"1 mPa s", "Pa s", 1e-3},
      {"1 mPa*s", "Pa s", 1e-3},
      {"1 mPa.s", "Pa s", 1e-3},
      {"1 cP", "Pa s", 1e-3},
      {"1 kg/(m s)", "Pa s", 1.0},
      {"1000 kg/m^3", "kg/m^3", 1000.0},
      {"1 g/cm3", "kg/m^3", 1000.0},
      {"1 kg m^-3", "kg/m^3", 1.0},
      {"0 N m", "N m", 0.0},
      {"1e-20 J", "J", 1e-20},
      {"10 zJ", "J", 1e-20},
      {"70 MPa", "Pa", 70e6},
      {"298 K", "K", 298.0},
      {"9.81 m/s^2", "m/s^2", 9.81},
      {"9.81 m s-2", "m/s^2", 9.81},
      {"9.81 m/s/s", "m/s^2", 9.81},
      {"1 kPa/m", "N/m^3", 1e3},
      {"-1 N/m^3", "N/m^3", -1.0},
      {"7 1/s", "1/s", 7.0},
      {"7 s^-1", "1/s", 7.0},
      {"7 Hz", "1/s", 7.0},
      {"2 min", "s", 120.0},
      {"2 h", "s", 7200.0},
      {"2 ms", "s", 2e-3},
      {"1e-3 pN", "N", 1e-15},
  };
  for (const Accepted& c : cases) {
    EXPECT_EQ(si(c.text, c.unit), c.value) << c.text;
  }
}

TEST(Quantity, TakesTheSizeOfKTFromTheTemperature) {
  EXPECT_DOUBLE_EQ(si("-3042 kT", "J"), -3042.0 * kBoltzmann * kTemperature);
  EXPECT_DOUBLE_EQ(parse_quantity("1 kT", "J", 400.0, ""), kBoltzmann * 400.0);
  EXPECT_DOUBLE_EQ(si("2 kT/nm", "N"), 2.0 * kBoltzmann * kTemperature / 1e-9);
}

TEST(Quantity, KnowsUnitsThatAreNoPowersOfTen) {
  EXPECT_DOUBLE_EQ(si("5eV", "J"), 5.0 * kElementaryCharge);
  EXPECT_DOUBLE_EQ(si("2 atm", "Pa"), 202650.0);
}

TEST(Quantity, IsWrittenSoThatReadingGivesTheSameBits) {
  for (const double value : {13.3e-6, 1.0 / 3.0, -0.0279, 6.02214076e23, 5e-324,
                             1.7976931348623157e308, -0.0}) {
    const double back = si(format_quantity(value, "Pa s"), "Pa s");
    EXPECT_EQ(back, value);
    EXPECT_EQ(std::signbit(back), std::signbit(value));
  }
}

TEST(Quantity, RefusesWhatHasNoUnitOrTheWrongOne) {
  EXPECT_THAT(refusal("13.3", "m"), HasSubstr("\"13.3\" has no unit; expected a number "
                                              "with a unit of length, such as"));
  EXPECT_THAT(refusal("0", "m"), HasSubstr("has no unit"));
  EXPECT_THAT(refusal("5 s", "m"), HasSubstr("wrong dimension (time)"));
  EXPECT_THAT(refusal("5 kT", "m"), HasSubstr("wrong dimension (energy or torque)"));
  EXPECT_THAT(refusal("5 m/m", "m"), HasSubstr("wrong dimension (a pure number)"));
  EXPECT_THAT(refusal("5 m A", "m"), HasSubstr("wrong dimension (m A)"));
}

TEST(Quantity, RefusesWhatIsNotAFiniteNumber) {
  for (const char* text : {"", " ", "um", "nan m", "NaN m", "inf m", "-inf m", ". m",
                           "- m", "e5 m", "--5 m", "one m"}) {
    EXPECT_THAT(refusal(text, "m"), HasSubstr("does not begin with a finite number"))
        << text;
  }
  for (const char* text : {"1e999 m", "-1e999 m", "1e308 km", "1e-999 m",
                           "1e99999999999999999999 m", "1e-99999999999999999999 m"}) {
    EXPECT_THAT(refusal(text, "m"), HasSubstr("beyond the range of a double")) << text;
  }
  EXPECT_THAT(refusal("0x10 m", "m"), HasSubstr("\"x10 m\" is not a unit"));
  EXPECT_THAT(refusal("13,3 um", "m"), HasSubstr("\",3 um\" is not a unit"));
}

TEST(Quantity, RefusesWhatIsNotAUnit) {
  const std::pair<const char*, const char*> cases[] = {
      {"5 parsec", "unknown symbol \"parsec\""},
      {"5 kmin", "unknown symbol \"kmin\""},
      {"5 mkT", "unknown symbol \"mkT\""},
      {"5 J/kg K", "needs parentheses"},
      {"5 m/", "a symbol is missing at the end"},
      {"5 /s", "unexpected \"/\""},
      {"5 m^", "an integer is missing"},
      {"5 m^x", "an integer is missing"},
      {"5 m^0.5", "unexpected \"5\""},
      {"5 m^99", "powers go up to 9"},
      {"5 (m", "a \")\" is missing"},
      {"5 m)", "unexpected \")\""},
      {"5 ((((((((((m))))))))))", "too many parentheses"},
      {"5 m 3", "unexpected \"3\""},
  };
  for (const auto& [text, why] : cases) {
    const std::string message = refusal(text, "m");
    EXPECT_THAT(message, HasSubstr(why)) << text;
    EXPECT_THAT(message, HasSubstr("/here: ")) << text;
    EXPECT_THAT(message, HasSubstr("unit of length")) << text;
  }
}

TEST(Quantity, ShowsExamplesThatItWouldAccept) {
  for (const char* unit : {"m", "s", "K", "V", "Pa", "Pa s", "kg/m^3", "m/s", "m/s^2",
                           "1/s", "mol/m^3", "J", "N", "N m", "N/m^3", "m^2"}) {
    EXPECT_NO_THROW(si(example_quantity(unit), unit)) << unit;
  }
}

}  // namespace
}  // namespace colloid
