#include "tiers/transient/foam_carried_pressure.h"

#include <algorithm>
#include <utility>

#include "particles/surfaces.h"

namespace colloid {

namespace {

// How much of it moves with a body: all nearer than the one distance from its centre,
// nothing beyond the other, in radii.
constexpr double kWhole = 1.5;
constexpr double kNothing = 4.0;

double share(double radii) {
  return std::clamp((kNothing - radii) / (kNothing - kWhole), 0.0, 1.0);
}

struct Moved {
  Sphere sphere;
  Vec3 by;
};

}  // namespace

void CarriedPressure::carry(const Box& box, const std::vector<Sphere>& bodies,
                            double cell, Foam::volScalarField& pressure) {
  std::vector<Moved> moved;
  for (const Sphere& body : bodies) {
    for (const Sphere& before : last_) {
      const Vec3 by = shortest(box, body.center, before.center);
      if (norm(by) > 0.0 && norm(by) < cell) {
        moved.push_back({body, by});
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
  Foam::scalarField& p = pressure.primitiveFieldRef();
  forAll(p, i) {
    Vec3 way;
    double shares = 0.0;
    for (const Moved& body : moved) {
      const double from_centre = norm(shortest(box, vec3(places[i]), body.sphere.center));
      const double own = share(from_centre / body.sphere.radius);
      way += own * body.by;
      shares += own;
    }
    p[i] -= dot(way, vec3(gradient[i])) / std::max(1.0, shares);
  }
  pressure.correctBoundaryConditions();
}

}  // namespace colloid
