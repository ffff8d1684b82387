// Physical quantities as people write them, "13.3 um" or "300 mM", turned into SI.
//
// A quantity is a decimal number and a unit expression: symbols with an optional SI
// prefix and an integer power ("s^-1", "m2"), multiplied by a space, "*" or "." and
// divided by
// "/".  After a division only further divisions may follow unless there are parentheses:
// "J/kg K" is ambiguous and refused, "J/(kg K)" is not.
//
// The thermal energy kT is a unit whose size depends on the temperature of the fluid.  It
// counts as an energy, and a text that contains it needs that temperature.
#pragma once

#include <string>
#include <string_view>

namespace colloid {

/// The value of `text` in SI.  Refuses with `where` what is no finite number with a unit
/// of the dimension of `si_unit`.  `temperature` [K] gives kT its size.
double parse_quantity(std::string_view text, std::string_view si_unit, double temperature,
                      const std::string& where);

/// `value` in SI with as many digits as reading it back exactly needs.
std::string format_quantity(double value, std::string_view si_unit);

/// A well-formed quantity of that unit to show in a message: for "m", "13.3 um".
std::string example_quantity(std::string_view si_unit);

}  // namespace colloid
