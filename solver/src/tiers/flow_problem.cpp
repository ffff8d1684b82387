#include "tiers/flow_problem.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "core/error.h"

namespace colloid {

namespace {

constexpr double kDefaultPerDiameter = 24.0;
constexpr double kDefaultPerBodyDiameter = 12.0;  // a mobility within 1 %
constexpr double kDefaultAlongEdge = 48.0;
constexpr double kMostAlongEdge = 1e6;

// Bytes a cell needs: coefficients and coarse levels 150, five vectors in double
// precision, ten Krylov iterations of 32 each (measured: 700).
constexpr double kBytesPerCell = 750.0;

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

// Fixed ones and those that move.
std::vector<Sphere> all_spheres(const Scene& scene) {
  std::vector<Sphere> spheres = scene.geometry.spheres;
  for (const Body& body : scene.geometry.bodies) {
    spheres.push_back(body.sphere);
  }
  return spheres;
}

double smallest_diameter(const std::vector<Sphere>& spheres) {
  double diameter = spheres.front().radius * 2.0;
  for (const Sphere& s : spheres) {
    diameter = std::min(diameter, 2.0 * s.radius);
  }
  return diameter;
}

double wanted_spacing(const Scene& scene, const GridChoice& choice) {
  const std::vector<Sphere> spheres = all_spheres(scene);
  if (choice.cells_per_diameter) {
    require(!spheres.empty(), "--cells-per-diameter",
            "the scene has no spheres; expected --cells NX NY NZ");
    return smallest_diameter(spheres) / *choice.cells_per_diameter;
  }
  if (choice.cells_per_colloid) {
    require(
        scene.colloids.has_value(), "--cells-per-colloid",
        "the scene has no colloids; expected --cells-per-diameter N or --cells NX NY NZ");
    return scene.colloids->diameter / *choice.cells_per_colloid;
  }
  if (scene.colloids) {
    return scene.colloids->diameter / scene.fidelity.cells_per_colloid;
  }
  const Vec3 size = scene.geometry.box.size;
  if (spheres.empty()) {
    return std::min({size.x, size.y, size.z}) / kDefaultAlongEdge;
  }
  const bool bodies = !scene.geometry.bodies.empty();
  return smallest_diameter(spheres) /
         (bodies ? kDefaultPerBodyDiameter : kDefaultPerDiameter);
}

FlowDrive make_drive(const Drive& drive) {
  FlowDrive out;
  if (drive.inlet_velocity) {
    out.kind = FlowDrive::Kind::inlet_velocity;
    out.inlet_velocity = *drive.inlet_velocity;
  } else if (drive.pressure_drop) {
    out.kind = FlowDrive::Kind::pressure_drop;
    out.pressure_drop = *drive.pressure_drop;
  } else if (drive.body_force) {
    out.kind = FlowDrive::Kind::body_force;
    out.body_force = *drive.body_force;
  } else if (drive.mean_velocity) {
    out.kind = FlowDrive::Kind::mean_velocity;
    out.mean_velocity = *drive.mean_velocity;
  } else if (drive.shear_rate) {
    out.kind = FlowDrive::Kind::shear_rate;
    out.shear_rate = *drive.shear_rate;
  }
  return out;
}

}  // namespace

std::array<int, 3> choose_cells(const Scene& scene, const GridChoice& choice) {
  std::array<double, 3> wanted{};
  double total = 1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    wanted[a] = choice.cells ? (*choice.cells)[a] : 0.0;
  }
  if (!choice.cells) {
    const double spacing = wanted_spacing(scene, choice);
    for (std::size_t a = 0; a < 3; ++a) {
      wanted[a] = std::max(
          1.0, std::round(scene.geometry.box.size[static_cast<int>(a)] / spacing));
    }
  }
  std::array<int, 3> cells{};
  for (std::size_t a = 0; a < 3; ++a) {
    total *= wanted[a];
    cells[a] = static_cast<int>(std::min(wanted[a], kMostAlongEdge));
  }
  require(
      *std::max_element(wanted.begin(), wanted.end()) <= kMostAlongEdge, "grid",
      fmt::format("has {:.3g} x {:.3g} x {:.3g} cells, at most {:g} fit along an edge; "
                  "expected a coarser grid",
                  wanted[0], wanted[1], wanted[2], kMostAlongEdge));
  require(
      total * kBytesPerCell < physical_memory() && total < 1e9, "grid",
      fmt::format(
          "{:.3g} cells need about {:.3g} GiB of memory, this machine has {:.3g}; "
          "expected a coarser grid (--cells-per-colloid, --cells-per-diameter, --cells)",
          total, total * kBytesPerCell / std::pow(2.0, 30),
          physical_memory() / std::pow(2.0, 30)));
  return cells;
}

StokesProblem make_flow_problem(const Scene& scene, const std::vector<Sphere>& deposit,
                                const std::array<int, 3>& cells) {
  StokesProblem problem;
  problem.box = scene.geometry.box;
  problem.spheres = scene.geometry.spheres;
  problem.spheres.insert(problem.spheres.end(), deposit.begin(), deposit.end());
  problem.viscosity = scene.fluid.viscosity;
  problem.drive = make_drive(scene.drive);
  problem.cells = cells;
  return problem;
}

}  // namespace colloid
