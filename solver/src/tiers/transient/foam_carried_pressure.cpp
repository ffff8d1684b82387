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
  Vec3 background;  ///< gradient that does not move with it
};

}  // namespace

void CarriedPressure::carry(const Box& box, const std::vector<Sphere>& bodies,
                            double cell, Foam::volScalarField& pressure) {
  std::vector<Moved> moved;
  for (const Sphere& body : bodies) {
    for (const Sphere& before : last_) {
      const Vec3 by = shortest(box, body.center, before.center);
      if (norm(by) > 0.0 && norm(by) < cell) {
        moved.push_back({body, by, {}});
        break;
      }
    }
  }
  last_ = bodies;
  if (moved.empty()) {
    return;
  }
  const Foam::volVectorField gradient(Foam::fvc::grad(pressure));
  const Foam::vectorField& places = pressure.mesh().C();
  const Foam::scalarField& volumes = pressure.mesh().V();
  const auto radii = [&](Foam::label i, const Sphere& sphere) {
    return norm(shortest(box, vec3(places[i]), sphere.center)) / sphere.radius;
  };
  // What is there without the body: the mean around it, to which its own disturbance,
  // harmonic and falling, adds nothing.
  for (Moved& body : moved) {
    std::array<double, 4> sums{};
    forAll(places, i) {
      const double from_centre = radii(i, body.sphere);
      const double weight =
          from_centre < kOutside ? 0.0 : share(from_centre) * volumes[i];
      const Vec3 slope = weight * vec3(gradient[i]);
      sums[0] += weight;
      sums[1] += slope.x;
      sums[2] += slope.y;
      sums[3] += slope.z;
    }
    sum_over_ranks(sums.data(), sums.size());
    if (sums[0] > 0.0) {
      body.background = (1.0 / sums[0]) * Vec3{sums[1], sums[2], sums[3]};
    }
  }
  Foam::scalarField& p = pressure.primitiveFieldRef();
  forAll(p, i) {
    double change = 0.0;
    double shares = 0.0;
    for (const Moved& body : moved) {
      const double own = share(radii(i, body.sphere));
      change += own * dot(body.by, vec3(gradient[i]) - body.background);
      shares += own;
    }
    p[i] -= change / std::max(1.0, shares);
  }
  pressure.correctBoundaryConditions();
}

}  // namespace colloid
