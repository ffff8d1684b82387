// Flows and surroundings that the verifications of colloids' motion share.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/constants.h"
#include "particles/integrator.h"
#include "particles/one_way_motion.h"

namespace colloid::cases {

constexpr double kRadius = 1e-6;                     // a [m]
constexpr double kMu = 1e-3;                         // [Pa s]
constexpr double kKelvin = 298.0;                    // [K]
constexpr double kDrag = 6.0 * kPi * kMu * kRadius;  // [N s/m]

/// An ambient flow given by a formula.
class GivenFlow : public AmbientFlow {
 public:
  using Formula = std::function<AmbientMotion(const Vec3& centre, double radius)>;
  explicit GivenFlow(Formula formula) : formula_(std::move(formula)) {}
  AmbientMotion around(const Vec3& centre, double radius) const override {
    return formula_(centre, radius);
  }

 private:
  Formula formula_;
};

inline AmbientMotion at_rest(const Vec3&, double) {
  return {};
}

/// The shear u_x = rate z.
inline AmbientMotion shear_along_x(double rate, double z) {
  AmbientMotion motion;
  motion.velocity = {rate * z, 0.0, 0.0};
  motion.spin = {0.0, 0.5 * rate, 0.0};
  motion.strain(0, 2) = motion.strain(2, 0) = 0.5 * rate;
  return motion;
}

/// The Stokes flow of a stream U past a sphere of radius b at the origin, at x: what
/// Faxen's laws make of it for a sphere of radius a.  Of the strain, its part E.x.
inline AmbientMotion stream_past_sphere(const Vec3& stream, double b, const Vec3& x,
                                        double a) {
  const double r = norm(x);
  const Vector3 n = eigen(x) / r;
  const Vector3 along = n * n.dot(eigen(stream));
  const Vector3 across = eigen(stream) - along;
  const double far = b / r;
  const double near = (b * b * b + a * a * b) / (r * r * r);
  AmbientMotion motion;
  motion.velocity = plain(along * (1.0 - 1.5 * far + 0.5 * near) +
                          across * (1.0 - 0.75 * far - 0.25 * near));
  // Half of the vorticity 3b/(2 r^2) n x U.
  motion.spin = plain(n.cross(across)) * (0.75 * far / r);
  // Slopes of the above, with a^2/10 lap: (b^3 + 3/5 a^2 b) for (b^3 + a^2 b).
  const double dipole = 1.5 * (b * b * b + 0.6 * a * a * b) / (r * r * r * r);
  const Vector3 slope = along * (1.5 * far / r - dipole) + across * (0.5 * dipole);
  motion.strain =
      slope * n.transpose() + n * slope.transpose() - n.dot(slope) * n * n.transpose();
  return motion;
}

/// Periodic everywhere: so large that no image matters.
inline Box wide_box(double edge) {
  Box box;
  box.size = {edge, edge, edge};
  box.faces.fill(FaceCondition::periodic);
  return box;
}

/// Wide, with a wall below; above the face `top`.
inline Box box_on_wall(double edge, double height,
                       FaceCondition top = FaceCondition::outlet) {
  Box box = wide_box(edge);
  box.size.z = height;
  box.faces[z_minus] = FaceCondition::wall;
  box.faces[z_plus] = top;
  return box;
}

/// A colloid at x by itself.
inline RigidBody colloid_at(const Vec3& x, int id = 0) {
  MobileColloid colloid;
  colloid.id = id;
  return single(colloid, x);
}

/// Everything that motion needs, kept together.
struct Setting {
  OneWayOptions options;
  GivenFlow flow;
  FixedSurfaces surfaces;
  std::unique_ptr<OneWayMotion> model;

  Setting(const OneWayOptions& given, GivenFlow::Formula formula, const Box& box,
          const std::vector<Sphere>& grains)
      : options(given),
        flow(std::move(formula)),
        surfaces(box, grains, hindrance_range(given.radius)) {
    std::vector<double> radii;
    for (const Sphere& grain : grains) {
      radii.push_back(grain.radius);
    }
    model = std::make_unique<OneWayMotion>(options, flow, surfaces, radii);
  }

  Integrator integrator(double tolerance, double most_travel = 0.5) const {
    IntegratorOptions steps;
    steps.radius = options.radius;
    steps.tolerance = tolerance;
    steps.most_travel = most_travel;
    steps.rules = options.rules;
    return Integrator(steps, *model, surfaces);
  }
};

/// Without hindrance, touching at `gap` [m].
inline OneWayOptions free_of_hindrance(double gap) {
  OneWayOptions options;
  options.radius = kRadius;
  options.viscosity = kMu;
  options.wall_hindrance = false;
  options.pair_hindrance = false;
  options.rules.grain_gap = gap;
  options.rules.colloid_gap = gap;
  options.rules.wall_gap = gap;
  return options;
}

}  // namespace colloid::cases
