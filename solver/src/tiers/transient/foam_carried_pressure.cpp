#include "tiers/transient/foam_carried_pressure.h"

#include <algorithm>
#include <array>
#include <utility>

#include "particles/surfaces.h"
#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

// How much of it moves with a body: all nearer than the one distance from its centre,
// nothing beyond the other, in radii.
constexpr double kWhole = 1.5;
constexpr double kNothing = 4.0;
constexpr double kOutside = 1.2;  // from here on cells are in the liquid

double share(double radii) {
  return std::clamp((kNothing - radii) / (kNothing - kWhole), 0.0, 1.0);
}

struct Moved {
  Sphere sphere;
  Vec3 by;
  std::vector<int> cells;     ///< of this rank, nearer than kNothing
  std::vector<double> radii;  ///< how far they are from its centre
};

Moved moved(const OctreeLevels& levels, const OctreeMesh& mesh, const Sphere& body,
            const Vec3& by) {
  Moved out{body, by, {}, {}};
  const double reach = kNothing * body.radius;
  for (const int cell : cells_around(levels, mesh, body.center, reach)) {
    const Vec3& x = mesh.centres[static_cast<std::size_t>(cell)];
    const double distance = norm(shortest(levels.box, x, body.center));
    if (distance < reach) {
      out.cells.push_back(cell);
      out.radii.push_back(distance / body.radius);
    }
  }
  return out;
}

// The gradient that is there without the body: the mean around it, to which its own
// disturbance, harmonic and falling, adds nothing.
Vec3 background(const Moved& body, const Foam::volVectorField& gradient) {
  std::array<double, 4> sums{};
  for (std::size_t n = 0; n < body.cells.size(); ++n) {
    if (body.radii[n] >= kOutside) {
      const Foam::label cell = body.cells[n];
      const double weight = share(body.radii[n]) * gradient.mesh().V()[cell];
      const Vec3 slope = weight * vec3(gradient[cell]);
      sums[0] += weight;
      sums[1] += slope.x;
      sums[2] += slope.y;
      sums[3] += slope.z;
    }
  }
  sum_over_ranks(sums.data(), sums.size());
  return sums[0] > 0.0 ? (1.0 / sums[0]) * Vec3{sums[1], sums[2], sums[3]} : Vec3{};
}

}  // namespace

void CarriedPressure::carry(const OctreeLevels& levels, const OctreeMesh& mesh,
                            const std::vector<Sphere>& bodies, double cell,
                            Foam::volScalarField& pressure) {
  std::vector<Moved> all;
  for (const Sphere& body : bodies) {
    for (const Sphere& before : last_) {
      const Vec3 by = shortest(levels.box, body.center, before.center);
      if (norm(by) > 0.0 && norm(by) < cell) {
        all.push_back(moved(levels, mesh, body, by));
        break;
      }
    }
  }
  last_ = bodies;
  if (all.empty()) {
    return;
  }
  const Foam::volVectorField gradient(Foam::fvc::grad(pressure));
  std::vector<double> change(mesh.centres.size(), 0.0);
  std::vector<double> shares(mesh.centres.size(), 0.0);
  for (const Moved& body : all) {
    const Vec3 stays = background(body, gradient);
    for (std::size_t n = 0; n < body.cells.size(); ++n) {
      const auto at = static_cast<std::size_t>(body.cells[n]);
      const double own = share(body.radii[n]);
      change[at] += own * dot(body.by, vec3(gradient[body.cells[n]]) - stays);
      shares[at] += own;
    }
  }
  Foam::scalarField& p = pressure.primitiveFieldRef();
  for (std::size_t i = 0; i < change.size(); ++i) {
    p[static_cast<Foam::label>(i)] -= change[i] / std::max(1.0, shares[i]);
  }
  pressure.correctBoundaryConditions();
}

}  // namespace colloid
