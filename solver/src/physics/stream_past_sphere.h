// What a uniform stream does to a held sphere 1 beside a held sphere 2, relative to
// Faxen's laws in the flow past sphere 2 ALONE.
//
// Sphere 1 of radius a, sphere 2 of radius b = ratio a, d = unit vector from 1 to 2,
// centres r apart, xi = 2r/(a + b) - 2 as in pair_resistance.h.  With U_n the stream's
// component along d and U_t the one across it, force and torque on sphere 1 are,
// MODEL (R9), (R10),
//
//     F_1 = 6 pi mu a (n u_n U_n + t u_t U_t),    T_1 = 8 pi mu a^3 r_factor omega
//     u_n = 1 - 3b/(2r) + (b^3 + a^2 b)/(2 r^3)   u + (a^2/6) lap u of the flow past 2
//     u_t = 1 - 3b/(4r) - (b^3 + a^2 b)/(4 r^3)     alone at the centre of 1, over U
//     omega = 3b/(4 r^2) U_t x d                  half its vorticity there
//
// So a force or a rotation that was computed from the flow without sphere 1 becomes the
// right one after multiplication.  All factors are 1 far away and finite at contact; n
// tends to f_e, t to f_s and r to t_s of wall_resistance.h as the ratio grows.
//
// From the series of two_sphere_series.h, in which lubrication cancels.  Relative error
// at contact: n, t, r 5e-5, 1e-6, 1e-6 for a ratio of 1; 4e-4, 6e-5, 2e-4 at 7; 1e-3,
// 2e-4, 7e-4 at 20; a tenth of that from xi = 0.03 on.
#pragma once

#include "physics/chebyshev.h"

namespace colloid {

struct StreamDrive {
  double n = 1.0;  ///< force along d
  double t = 1.0;  ///< force across d
  double r = 1.0;  ///< torque about an axis across d
};

/// That flow past sphere 2 alone, averaged over the surface of sphere 1 (Faxen 1922), per
/// velocity U_t of the stream across d; lengths over a.
struct FaxenPastSphere {
  double velocity;  ///< u_t
  double spin;      ///< omega
  double strain;    ///< E_nt, n = -d
};
/// `distance` = r/a of the centres.
FaxenPastSphere faxen_past_sphere(double ratio, double distance);

class StreamPastSphere {
 public:
  /// `ratio` = b/a, from 0.05 to 20; beyond, sphere 2 is a plane (wall_resistance.h).
  explicit StreamPastSphere(double ratio);

  /// `gap` = xi >= 0; infinity gives the bulk.
  StreamDrive at(double gap) const;

 private:
  ChebyshevSeries<3> drive_;  // n, t, r against u = 2/(2 + xi)
};

}  // namespace colloid
