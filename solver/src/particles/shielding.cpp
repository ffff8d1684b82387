#include "particles/shielding.h"

#include <algorithm>
#include <cmath>

#include "particles/two_planes.h"

namespace colloid {

namespace {

// In narrow clefts point forces leave little mobility or none at all, and say nothing any
// more: from the second of these on downwards what they say counts less, below the first
// surfaces act as if each were alone.
constexpr double kLeastMobility = 0.1;
constexpr double kTrustedMobility = 0.2;

// Drift along the normal by the image of a stresslet, over strain, at height 1.
constexpr double kStressletDrift = -15.0 / 16.0;

// Of the point force with Faxen's correction, at height h over a: what a plane takes off
// the mobility (Lorentz 1907, to the third order).
double taken_along(double height) {
  const double x = 1.0 / height;
  return 9.0 / 8.0 * x - 0.5 * x * x * x;
}
double taken_across(double height) {
  const double x = 1.0 / height;
  return 9.0 / 16.0 * x - 0.125 * x * x * x;
}

Matrix3 axial(const Vector3& n, double along, double across) {
  return across * Matrix3::Identity() + (along - across) * n * n.transpose();
}

// A surface alone at the level of the point force.
struct Alone {
  explicit Alone(const WideSurface& s)
      // No more than of a point force, for lubrication is no business of other surfaces.
      : along(std::min(1.0 - 1.0 / s.along, taken_along(s.height))),
        across(std::min(1.0 - 1.0 / s.across, taken_across(s.height))),
        taken(axial(s.normal, along, across)),
        resistance(axial(s.normal, 1.0 / (1.0 - along), 1.0 / (1.0 - across))),
        flow_part(
            std::min(along / taken_along(s.height), across / taken_across(s.height))),
        strain_part(s.drift_along * s.height * s.height / kStressletDrift) {}
  double along, across;  // mobility that it takes
  Matrix3 taken, resistance;
  double flow_part, strain_part;  // of what a plane does to a point force, a stresslet
};

// Drift in the surface's own flow with that velocity along the normal.
Vector3 own_drift(const WideSurface& s, const Matrix3& strain, const Vector3& velocity) {
  const Vector3 of_normal = strain * s.normal;
  const double along = s.strain_by_velocity * velocity.dot(s.normal);
  return s.weight * (s.drift_along * along * s.normal +
                     s.drift_across * (of_normal - of_normal.dot(s.normal) * s.normal));
}

// What the strain along the normal exerts beyond.
Vector3 excess_force(const WideSurface& s, const Matrix3& strain,
                     const Vector3& velocity) {
  const double excess =
      s.normal.dot(strain * s.normal) - s.strain_by_velocity * velocity.dot(s.normal);
  return s.weight * s.excess_coefficient * excess * s.normal;
}

// Mobility that two surfaces take, and drift that they give, together less alone.
struct Both {
  Matrix3 taken;
  Vector3 drift;
};
Both both(const WideSurface& a, const Alone& alone_a, const WideSurface& b,
          const Alone& alone_b, const Matrix3& strain) {
  const SentBackByBoth sent = sent_back_by_both(a.normal, a.height, b.normal, b.height);
  const double flow = std::sqrt(alone_a.flow_part * alone_b.flow_part);
  const double drifts = std::sqrt(alone_a.strain_part * alone_b.strain_part);
  Both found;
  // Faxen's law where the force acts and where its flow is felt.
  found.taken = -0.75 * flow * (sent.flow + sent.laplacian / 3.0);
  // By reciprocity, the stresslet -20/3 pi mu a^3 E of a sphere drives itself with what a
  // force would strain it.
  for (int j = 0; j < 3; ++j) {
    found.drift[j] = -5.0 / 6.0 * drifts *
                     sent.strain[static_cast<std::size_t>(j)].cwiseProduct(strain).sum();
  }
  return found;
}

struct Together {
  Matrix3 resistance;
  double trust;  // 0 to 1
};
Together resistance_to(const Matrix3& taken) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> modes(taken);
  const Vector3 mobility = 1.0 - modes.eigenvalues().array();
  const Vector3 bounded = mobility.cwiseMax(kLeastMobility);
  const double t = std::clamp(
      (mobility.minCoeff() - kLeastMobility) / (kTrustedMobility - kLeastMobility), 0.0,
      1.0);
  return {modes.eigenvectors() * bounded.cwiseInverse().asDiagonal() *
              modes.eigenvectors().transpose(),
          t * t * (3.0 - 2.0 * t)};
}

}  // namespace

Shielding shielding(const std::vector<WideSurface>& surfaces, const Matrix3& strain,
                    const Vector3& velocity) {
  if (surfaces.empty()) {
    return {};
  }
  std::vector<Alone> alone;
  double fourth_powers = 0.0;
  for (const WideSurface& s : surfaces) {
    fourth_powers += std::pow(alone.emplace_back(s).along, 4);
  }
  if (fourth_powers == 0.0) {
    return {};
  }
  Matrix3 taken = Matrix3::Zero();
  Vector3 drifts = Vector3::Zero();
  Shielding less;  // the sum of each alone
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const WideSurface& a = surfaces[i];
    taken += alone[i].taken;
    const Vector3 own = own_drift(a, strain, velocity);
    // Resisted by this surface at the level of point forces, as the excess itself is.
    drifts +=
        own + (Matrix3::Identity() - alone[i].taken) * excess_force(a, strain, velocity);
    less.resistance += alone[i].resistance - Matrix3::Identity();
    less.drive += alone[i].resistance * own;
    for (std::size_t j = 0; j < i; ++j) {
      // A third surface close by hides two from each other.
      const double open =
          (std::pow(alone[i].along, 4) + std::pow(alone[j].along, 4)) / fourth_powers;
      const Both pair = both(a, alone[i], surfaces[j], alone[j], strain);
      taken += open * pair.taken;
      drifts += open * pair.drift;
    }
  }
  const auto [resistance, trust] = resistance_to(taken);
  return {trust * (resistance - Matrix3::Identity() - less.resistance),
          trust * (resistance * drifts - less.drive)};
}

}  // namespace colloid
