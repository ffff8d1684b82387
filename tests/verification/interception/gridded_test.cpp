// Interception by one sphere from the solver's own flow: see README.md beside this file.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "flow/interpolation.h"
#include "motion_cases.h"

namespace colloid {
namespace {

constexpr double kCollector = 20e-6;  // radius of the collector R_c [m]
constexpr double kSpeed = 1e-3;       // U [m/s], downwards
constexpr double kWidth = 4.0 * kCollector;
constexpr double kHeight = 6.0 * kCollector;
constexpr double kStepTolerance = 1e-5;

// One sphere in the middle of a box that its mirror images fill the plane with.  With
// `quarter`, only the part between two planes of symmetry through the sphere's centre.
StokesSolver past_sphere(int cells_per_diameter, bool quarter) {
  const double width = quarter ? 0.5 * kWidth : kWidth;
  const int across =
      static_cast<int>(std::lround(width / (2.0 * kCollector) * cells_per_diameter));
  StokesProblem problem;
  problem.box.size = {width, width, kHeight};
  problem.box.faces.fill(FaceCondition::symmetry);
  problem.box.faces[z_minus] = FaceCondition::outlet;
  problem.box.faces[z_plus] = FaceCondition::inlet;
  const double axis = quarter ? 0.0 : 0.5 * kWidth;
  problem.spheres = {{{axis, axis, 0.5 * kHeight}, kCollector}};
  problem.viscosity = cases::kMu;
  problem.drive.kind = FlowDrive::Kind::inlet_velocity;
  problem.drive.inlet_velocity = kSpeed;
  problem.cells = {across, across, 3 * cells_per_diameter};
  StokesOptions options;
  options.tolerance = 1e-8;
  StokesSolver solver(problem, options);
  solver.solve();
  return solver;
}

constexpr int kPoints = 96;  // of the midpoint rule, per radius and per quarter turn

// Flux through the equator between the sphere and contact, over U R_c^2, from the quarter
// of a solution.
double flux_through_equator(const StokesSolver& quarter, double interception) {
  const Vec3 centre = quarter.problem().spheres.front().center;
  double sum = 0.0;
  for (int j = 0; j < kPoints; ++j) {
    const double theta = 0.5 * kPi * (j + 0.5) / kPoints;
    const Vec3 aside{std::cos(theta), std::sin(theta), 0.0};
    for (int i = 0; i < kPoints; ++i) {
      const double r = 1.0 + interception * (i + 0.5) / kPoints;
      sum -= r * velocity_at(quarter, centre + aside * (r * kCollector)).z / kSpeed;
    }
  }
  return 2.0 * kPi * interception * sum / (kPoints * kPoints);
}

// Flux into the sphere of contact where it goes inwards, over U R_c^2.
double inflow_at_contact(const StokesSolver& quarter, double interception) {
  const Vec3 centre = quarter.problem().spheres.front().center;
  const double reach = 1.0 + interception;
  constexpr int kRings = 2 * kPoints;  // of equal area: n_z is uniform on a sphere
  double sum = 0.0;
  for (int j = 0; j < kPoints; ++j) {
    const double theta = 0.5 * kPi * (j + 0.5) / kPoints;
    const Vec3 aside{std::cos(theta), std::sin(theta), 0.0};
    for (int i = 0; i < kRings; ++i) {
      const double nz = -1.0 + 2.0 * (i + 0.5) / kRings;
      const Vec3 n = aside * std::sqrt(1.0 - nz * nz) + Vec3{0.0, 0.0, nz};
      const Vec3 u = velocity_at(quarter, centre + n * (reach * kCollector));
      sum += std::max(0.0, -dot(u, n)) / kSpeed;
    }
  }
  return 4.0 * kPi * reach * reach * sum / (kPoints * kRings);
}

// Whether a colloid from `start` on the inlet touches the collector on its way past it.
bool touches(const cases::Setting& setting, const Vec3& start) {
  std::vector<RigidBody> bodies{cases::colloid_at(start)};
  Integrator integrator = setting.integrator(kStepTolerance);
  while (bodies[0].centre.z > 0.5 * kHeight - 0.3 * kCollector) {
    integrator.advance(bodies, 1.0, std::nullopt);
    if (!find_touches(bodies, setting.surfaces, setting.options.rules,
                      setting.options.radius)
             .empty()) {
      return true;
    }
  }
  return false;
}

// The flux of the stream tube that is caught, over U R_c^2: half the integral of b^2 over
// the directions, U the same all over the inlet.
double collected_by_tracking(const StokesSolver& solver, double interception) {
  OneWayOptions options = cases::free_of_hindrance(0.0);
  constexpr double kGap = 0.01;  // of contact, over a: a + gap = N_R R_c
  options.radius = interception * kCollector / (1.0 + kGap);
  options.rules.grain_gap = kGap * options.radius;
  const auto flow = [&](const Vec3& x, double) {
    return AmbientMotion{velocity_at(solver, x), {}};
  };
  // The flow's box, but no face holds a colloid back.
  Box box = solver.problem().box;
  box.faces.fill(FaceCondition::periodic);
  const cases::Setting setting(options, flow, box, solver.problem().spheres);
  // b^2 is even and has the period pi/2: the trapezoidal rule on an eighth is exact for
  // its harmonics below the 24th.
  constexpr int kIntervals = 3;
  double mean = 0.0;
  for (int n = 0; n <= kIntervals; ++n) {
    const double theta = 0.25 * kPi * n / kIntervals;
    const Vec3 aside{std::cos(theta), std::sin(theta), 0.0};
    const Vec3 top{0.5 * kWidth, 0.5 * kWidth, kHeight};
    double inside = 0.0;
    double outside = 1.0;
    while (outside - inside > 1e-7) {
      const double middle = 0.5 * (inside + outside);
      if (touches(setting, top + aside * (middle * kCollector))) {
        inside = middle;
      } else {
        outside = middle;
      }
    }
    mean += inside * inside * (n == 0 || n == kIntervals ? 0.5 : 1.0) / kIntervals;
  }
  return kPi * mean;
}

TEST(GriddedInterception, CollectsTheFluxThroughTheEquator) {
  constexpr int kCoarse = 12;
  constexpr int kMedium = 24;
  constexpr int kFine = 48;
  const StokesSolver coarse = past_sphere(kCoarse, false);
  const StokesSolver medium = past_sphere(kMedium, false);
  const StokesSolver fine = past_sphere(kFine, true);
  for (double interception : {0.2, 0.3}) {
    const double exact = flux_through_equator(fine, interception);
    const double on_coarse = collected_by_tracking(coarse, interception);
    const double on_medium = collected_by_tracking(medium, interception);
    const double limit = (4.0 * on_medium - on_coarse) / 3.0;
    const double coarse_error = on_coarse / exact - 1.0;
    const double medium_error = on_medium / exact - 1.0;
    std::printf(
        "N_R %g: flux %.5f, collected %.5f (%+.1e), %.5f (%+.1e), ratio %.2f, "
        "extrapolated %.5f (%+.1e)\n",
        interception, exact, on_coarse, coarse_error, on_medium, medium_error,
        coarse_error / medium_error, limit, limit / exact - 1.0);
    // README: of the normal velocity at contact, which grows like the squared distance.
    const auto bound = [&](int cells) {
      const double h = 2.0 / cells;
      return 0.25 * h * h * (1.0 / (interception * interception) + 1.0);
    };
    EXPECT_LT(std::abs(coarse_error), bound(kCoarse));
    EXPECT_LT(std::abs(medium_error), bound(kMedium));
    // Four at second order; 3 to 5: order 1.6 to 2.3.
    EXPECT_GT(coarse_error / medium_error, 3.0);
    EXPECT_LT(coarse_error / medium_error, 5.0);
    // What the reference's own interpolation errs by.
    const double h = 2.0 / kFine;
    EXPECT_LT(std::abs(limit / exact - 1.0), 2.0 / 3.0 * h * h / interception);
  }
}

// On one and the same grid: paths end where the field leads them.
TEST(GriddedInterception, IsTheInflowAtContactOnTheSameGrid) {
  for (int cells : {12, 24}) {
    const StokesSolver whole = past_sphere(cells, false);
    const StokesSolver quarter = past_sphere(cells, true);
    const double h = 2.0 / cells;
    for (double interception : {0.2, 0.3}) {
      const double tracked = collected_by_tracking(whole, interception);
      const double inflow = inflow_at_contact(quarter, interception);
      std::printf("N_R %g, %d cells: collected %.5f, inflow %.5f, difference %+.1e\n",
                  interception, cells, tracked, inflow, tracked / inflow - 1.0);
      // README: sources between the points of the grid.
      EXPECT_LT(std::abs(tracked / inflow - 1.0), 13.0 / 12.0 * h * h);
    }
  }
}

}  // namespace
}  // namespace colloid
