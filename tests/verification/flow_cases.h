// Problems that several flow verifications share.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>

#include "core/constants.h"
#include "flow/stokes_solver.h"

namespace colloid::cases {

constexpr double kLength = 100e-6;   // [m]
constexpr double kViscosity = 1e-3;  // [Pa s]

inline StokesProblem periodic_box(const Vec3& size, const std::array<int, 3>& cells) {
  StokesProblem problem;
  problem.box.size = size;
  problem.box.faces.fill(FaceCondition::periodic);
  problem.viscosity = kViscosity;
  problem.cells = cells;
  return problem;
}

/// Radius of the sphere of a simple-cubic array of solid fraction c in a cube of
/// `length`.
inline double array_radius(double c, double length) {
  return std::cbrt(3.0 * c / (4.0 * kPi)) * length;
}

/// One sphere off every symmetry of the grid in a periodic cube of n cells a side.
inline StokesProblem simple_cubic_array(double c, int n) {
  StokesProblem problem = periodic_box({kLength, kLength, kLength}, {n, n, n});
  problem.spheres = {
      {{0.513 * kLength, 0.471 * kLength, 0.537 * kLength}, array_radius(c, kLength)}};
  problem.drive.kind = FlowDrive::Kind::body_force;
  problem.drive.body_force = {0.0, 0.0, 1e3};
  return problem;
}

/// The reference throat (Liu, Shikhov & Arns 2024), n cells across.
inline StokesProblem throat(int n) {
  constexpr double kCollector = 96.6e-6;
  StokesProblem problem;
  problem.box.size = {kCollector, kCollector, 1.5 * kCollector};
  problem.box.faces = {FaceCondition::wall, FaceCondition::wall,   FaceCondition::wall,
                       FaceCondition::wall, FaceCondition::outlet, FaceCondition::inlet};
  for (int corner = 0; corner < 4; ++corner) {
    problem.spheres.push_back(
        {{(corner % 2) * kCollector, (corner / 2) * kCollector, 0.5 * kCollector},
         0.5 * kCollector});
  }
  problem.viscosity = kViscosity;
  problem.drive.kind = FlowDrive::Kind::inlet_velocity;
  problem.drive.inlet_velocity = 0.5e-3;
  problem.cells = {n, n, 3 * n / 2};
  return problem;
}

/// Colloids of 13.3 um dropped straight down into the throat, each to its first contact:
/// a crowded deposit of touching spheres, made by a specified generator.
inline std::vector<Sphere> dropped_deposit(int count, std::uint64_t seed) {
  const StokesProblem empty = throat(8);
  const double a = 6.65e-6;
  const double step = 1e-8;
  std::vector<Sphere> all = empty.spheres;
  std::vector<Sphere> deposit;
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  for (int tries = 0; static_cast<int>(deposit.size()) < count; ++tries) {
    if (tries > 100000) {
      throw std::runtime_error("the throat does not hold that many colloids");
    }
    const double width = empty.box.size.x;
    Sphere s{{a + uniform() * (width - 2 * a), a + uniform() * (width - 2 * a), 0.0}, a};
    // Highest height at which it touches something below it.
    double height = 0.0;
    for (const Sphere& other : all) {
      const double reach = other.radius + a;
      const double dx = s.center.x - other.center.x;
      const double dy = s.center.y - other.center.y;
      const double rest = reach * reach - dx * dx - dy * dy;
      if (rest > 0.0) {
        height = std::max(height, other.center.z + std::sqrt(rest));
      }
    }
    if (height <= a || height > 1.2 * width) {
      continue;  // fell through, or piled up into the inlet
    }
    s.center.z = height + step;
    all.push_back(s);
    deposit.push_back(s);
  }
  return deposit;
}

}  // namespace colloid::cases
