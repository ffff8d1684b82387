// The dimensionless numbers of a scene, and which physics they make necessary.
//
// Speeds: U is the inlet's mean speed for a colloid's numbers, and the mean speed at the
// narrowest plane for the throat's.  A decision takes the largest value over the scene
// (the smallest for Pe), which the caller finds.
#pragma once

#include <string>

namespace colloid {

/// (D1) 6 pi mu a U [N], of a sphere in an unbounded liquid.
double stokes_drag(double viscosity, double radius, double speed);

/// (D2) Re_p = rho U d / mu, d = 2a.
double particle_reynolds(double fluid_density, double speed, double diameter,
                         double viscosity);

/// (D3) Re_throat = rho u_throat d_throat / mu.
double throat_reynolds(double fluid_density, double throat_speed, double throat_diameter,
                       double viscosity);

/// (D4) tau_p = 2 rho_p a^2 / (9 mu) [s].  With half the displaced liquid's mass in place
/// of nothing: `particle_density` = rho_p + rho_f / 2.
double relaxation_time(double particle_density, double radius, double viscosity);

/// (D5) a^2 rho_f / mu [s]: how fast the flow about a sphere becomes steady.
double viscous_time(double radius, double fluid_density, double viscosity);

/// (D6) St = 2 rho_p a U / (9 mu) = tau_p U / a.
double stokes_number(double particle_density, double radius, double speed,
                     double viscosity);

/// (D7) D = k_B T / (6 pi mu a) [m^2/s], Stokes & Einstein.
double diffusivity(double temperature, double viscosity, double radius);

/// (D8) Pe = U a / D.
double peclet_number(double speed, double radius, double diffusivity);

/// (D9) 2 (rho_p - rho_f) g a^2 / (9 mu) [m/s], positive = sinks, negative = rises.
double settling_speed(double particle_density, double fluid_density, double gravity,
                      double radius, double viscosity);

/// (D10) |settling speed| / U.
double gravity_number(double settling_speed, double speed);

/// What decide_models() needs to know of a scene.
struct RegimeNumbers {
  double reynolds_throat = 0.0;
  double stokes = 0.0;
  double peclet = 0.0;   ///< the smallest over the scene
  double gravity = 0.0;  ///< (D10)
  double dlvo_range_over_radius =
      0.0;                          ///< interaction_range() at the Stokes drag, over a
  double grain_barrier_kT = 0.0;    ///< colloid and grain, from the secondary minimum
  bool flow_resolves_gaps = false;  ///< down to contact: no flow solver here does
};

struct ModelDecision {
  bool needed = false;
  std::string reason;  ///< the number and the limit, e.g. "Pe(a) = 1.01e+05 >= 100"
};

/// Which physics a scene needs, by the limits of MODEL (D11).
struct ModelDecisions {
  ModelDecision brownian;
  ModelDecision gravity;
  ModelDecision inertia;
  ModelDecision lubrication;
  ModelDecision long_range_dlvo;
};

ModelDecisions decide_models(const RegimeNumbers& numbers);

}  // namespace colloid
