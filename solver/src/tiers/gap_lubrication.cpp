#include "tiers/gap_lubrication.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/constants.h"
#include "core/error.h"
#include "particles/contact_rules.h"
#include "particles/unresolved_gap.h"
#include "physics/surface_pair.h"

namespace colloid {

namespace {

constexpr double kMostRatio = 20.0;  // of two radii for which there are functions

void refuse_ratio(double a, double b, std::size_t body) {
  require(
      std::max(a, b) <= kMostRatio * std::min(a, b), "/fidelity/lubrication",
      fmt::format("is full, but beside /geometry/bodies/{}, of radius {:.3g} m, is one "
                  "of radius {:.3g} m; expected a ratio of at most {:g}, or "
                  "\"resolved_only\"",
                  body, a, b, kMostRatio));
}

class Gaps {
 public:
  Gaps(const Scene& scene, const std::vector<Sphere>& fixed, double cell)
      : scene_(scene),
        bodies_(scene.geometry.bodies),
        cell_(cell),
        surfaces_(scene.geometry.box, fixed, kResolvedCells * cell + widest()) {}

  GapLubrication all() {
    const auto n = 6 * static_cast<Eigen::Index>(bodies_.size());
    out_.resistance = Eigen::MatrixXd::Zero(n, n);
    out_.drive = Eigen::VectorXd::Zero(n);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      add_surfaces(b);
      for (std::size_t c = b + 1; c < bodies_.size(); ++c) {
        add_pair(b, c);
      }
    }
    return std::move(out_);
  }

 private:
  double widest() const {
    double widest = 0.0;
    for (const Body& body : bodies_) {
      widest = std::max(widest, body.sphere.radius);
    }
    return widest;
  }

  void add_surfaces(std::size_t b) {
    const double a = bodies_[b].sphere.radius;
    std::vector<NearSurface> near;
    surfaces_.near(bodies_[b].sphere.center, near);
    near.erase(std::remove_if(near.begin(), near.end(),
                              [&](const NearSurface& surface) {
                                return !is_surface(surfaces_.box(), surface.id) ||
                                       surface.distance - a >= kResolvedCells * cell_;
                              }),
               near.end());
    std::vector<double> radii;
    for (const NearSurface& surface : near) {
      if (surface.radius < a) {
        refuse_ratio(a, surface.radius, b);
      }
      if (surface.id.kind != SurfaceId::Kind::face) {
        radii.push_back(surface.radius);
      }
    }
    const SurfaceHindrance hindrance(a, radii);
    Vector6 units;  // from (U, a w) to SI
    units << 1.0, 1.0, 1.0, a, a, a;
    const double drag = 6.0 * kPi * scene_.fluid.viscosity * a;
    const auto at = 6 * static_cast<Eigen::Index>(b);
    for (const NearSurface& surface : near) {
      const Matrix6 beside =
          drag * units.asDiagonal() *
          unresolved_beside(hindrance, surface, a, SurfacePair{}.closest_gap, cell_) *
          units.asDiagonal();
      out_.resistance.block<6, 6>(at, at) += beside;
      if (scene_.drive.shear_rate && surface.id.kind == SurfaceId::Kind::face &&
          surface.id.index == z_plus) {
        out_.drive.segment<6>(at) +=
            beside.col(0) * (*scene_.drive.shear_rate * surfaces_.box().size.z);
      }
    }
  }

  void add_pair(std::size_t b, std::size_t c) {
    const Sphere& one = bodies_[b].sphere;
    const Vec3 e = shortest(surfaces_.box(), bodies_[c].sphere.center, one.center);
    const Sphere two{one.center + e, bodies_[c].sphere.radius};
    if (norm(e) - one.radius - two.radius >= kResolvedCells * cell_) {
      return;
    }
    refuse_ratio(one.radius, two.radius, b);
    const Matrix12 pair = scene_.fluid.viscosity *
                          unresolved_between(TwoSphereResistance(two.radius / one.radius),
                                             one, two, SurfacePair{}.closest_gap, cell_);
    const std::array<Eigen::Index, 2> place{6 * static_cast<Eigen::Index>(b),
                                            6 * static_cast<Eigen::Index>(c)};
    for (Eigen::Index p = 0; p < 2; ++p) {
      for (Eigen::Index q = 0; q < 2; ++q) {
        out_.resistance.block<6, 6>(place[static_cast<std::size_t>(p)],
                                    place[static_cast<std::size_t>(q)]) +=
            pair.block<6, 6>(6 * p, 6 * q);
      }
    }
  }

  const Scene& scene_;
  const std::vector<Body>& bodies_;
  double cell_;
  FixedSurfaces surfaces_;
  GapLubrication out_;
};

}  // namespace

GapLubrication gap_lubrication(const Scene& scene, const std::vector<Sphere>& fixed,
                               double cell) {
  return Gaps(scene, fixed, cell).all();
}

}  // namespace colloid
