#include "physics/regime_numbers.h"

#include <cmath>
#include <cstdio>

#include "core/constants.h"
#include "physics/electrolyte.h"

namespace colloid {

namespace {

// MODEL (D11).
constexpr double kInertiaReynolds = 1.0;
constexpr double kInertiaStokes = 0.1;
constexpr double kBrownianPeclet = 100.0;
constexpr double kEscapeBarrierLowest = 5.0;    // [kT] below: no obstacle
constexpr double kEscapeBarrierHighest = 30.0;  // [kT] above: no escape in a run's time
constexpr double kGravityNumber = 1e-3;
constexpr double kDlvoRangeOverRadius = 0.01;

// "name = value > limit", with the sign that holds.
std::string compared(const char* name, double value, double limit, const char* unit) {
  char text[120];
  const char* sign = value > limit ? ">" : (value < limit ? "<" : "=");
  std::snprintf(text, sizeof(text), "%s = %.3g%s %s %g%s", name, value, unit, sign, limit,
                unit);
  return text;
}

ModelDecision decide_brownian(const RegimeNumbers& n) {
  const std::string peclet = compared("Pe(a)", n.peclet, kBrownianPeclet, "");
  if (n.peclet < kBrownianPeclet) {
    return {true, peclet};
  }
  const double barrier = n.grain_barrier_kT;
  const bool escape = barrier >= kEscapeBarrierLowest && barrier <= kEscapeBarrierHighest;
  char text[120];
  std::snprintf(text, sizeof(text), "colloid-grain barrier %.3g kT, %s %g-%g kT", barrier,
                escape ? "within" : "outside", kEscapeBarrierLowest,
                kEscapeBarrierHighest);
  return {escape, escape ? text : peclet + ", " + text};
}

ModelDecision decide_inertia(const RegimeNumbers& n) {
  const std::string reynolds =
      compared("Re_throat", n.reynolds_throat, kInertiaReynolds, "");
  const std::string stokes = compared("Stokes", n.stokes, kInertiaStokes, "");
  const bool by_reynolds = n.reynolds_throat > kInertiaReynolds;
  const bool by_stokes = n.stokes > kInertiaStokes;
  if (by_reynolds == by_stokes) {
    return {by_reynolds, reynolds + ", " + stokes};
  }
  return {true, by_reynolds ? reynolds : stokes};
}

ModelDecision decide_long_range_dlvo(const RegimeNumbers& n) {
  const std::string range =
      compared("DLVO range/a", n.dlvo_range_over_radius, kDlvoRangeOverRadius, "");
  if (n.dlvo_range_over_radius > kDlvoRangeOverRadius) {
    return {true, range};
  }
  if (n.grain_barrier_kT > 0.0) {
    return {true, compared("colloid-grain barrier", n.grain_barrier_kT, 0.0, " kT")};
  }
  return {false, range + ", no colloid-grain barrier"};
}

}  // namespace

double stokes_drag(double viscosity, double radius, double speed) {
  return 6.0 * kPi * viscosity * radius * speed;
}

double particle_reynolds(double fluid_density, double speed, double diameter,
                         double viscosity) {
  return fluid_density * speed * diameter / viscosity;
}

double throat_reynolds(double fluid_density, double throat_speed, double throat_diameter,
                       double viscosity) {
  return fluid_density * throat_speed * throat_diameter / viscosity;
}

double relaxation_time(double particle_density, double radius, double viscosity) {
  return 2.0 * particle_density * radius * radius / (9.0 * viscosity);
}

double viscous_time(double radius, double fluid_density, double viscosity) {
  return radius * radius * fluid_density / viscosity;
}

double stokes_number(double particle_density, double radius, double speed,
                     double viscosity) {
  return 2.0 * particle_density * radius * speed / (9.0 * viscosity);
}

double diffusivity(double temperature, double viscosity, double radius) {
  return thermal_energy(temperature) / (6.0 * kPi * viscosity * radius);
}

double peclet_number(double speed, double radius, double diffusivity) {
  return speed * radius / diffusivity;
}

double settling_speed(double particle_density, double fluid_density, double gravity,
                      double radius, double viscosity) {
  return 2.0 * (particle_density - fluid_density) * gravity * radius * radius /
         (9.0 * viscosity);
}

double gravity_number(double settling_speed, double speed) {
  return std::abs(settling_speed) / speed;
}

ModelDecisions decide_models(const RegimeNumbers& numbers) {
  ModelDecisions decisions;
  decisions.brownian = decide_brownian(numbers);
  decisions.gravity = {numbers.gravity > kGravityNumber,
                       compared("settling/U", numbers.gravity, kGravityNumber, "")};
  decisions.inertia = decide_inertia(numbers);
  decisions.lubrication = {!numbers.flow_resolves_gaps,
                           numbers.flow_resolves_gaps
                               ? "the flow solver resolves every gap"
                               : "the flow solver does not resolve gaps below its cells"};
  decisions.long_range_dlvo = decide_long_range_dlvo(numbers);
  return decisions;
}

}  // namespace colloid
