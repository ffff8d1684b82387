#include "particles/shielding.h"

#include <algorithm>
#include <cmath>

namespace colloid {

namespace {

constexpr double kStep = 1e-3;  // of differences, over the distance

// In narrow clefts point forces leave no mobility at all; there surfaces do not shield
// each other, and their resistances add up.
constexpr double kLeastMobility = 0.1;

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

// Mobility that the surface alone takes: no more than of a point force, for lubrication
// is no business of other surfaces.
struct Taken {
  double along, across;
};
Taken taken_by(const WideSurface& s) {
  return {std::min(1.0 - 1.0 / s.along, taken_along(s.height)),
          std::min(1.0 - 1.0 / s.across, taken_across(s.height))};
}

Matrix3 axial(const Vector3& n, double along, double across) {
  return across * Matrix3::Identity() + (along - across) * n * n.transpose();
}

// Velocity at x by the image behind B of a force at x, as if it lay beside A: Blake's
// (1971) force, force doublet and source doublet; over 1/(8 pi mu a).
Matrix3 flow_of_image(const Vector3& x, const WideSurface& b, const Vector3& n) {
  const double c = b.height;
  const Vector3 y = x - 2.0 * c * b.normal;
  const double step = kStep * c;
  const auto at = [&](const Vector3& place) {
    return velocity_by_force_at_plane(x, place, n);
  };
  const Matrix3 here = at(y);
  Matrix3 laplacian = Matrix3::Zero();
  Matrix3 doublet;  // column k: d/dy_k of the flow of a force along B's normal
  for (int k = 0; k < 3; ++k) {
    const Vector3 shift = step * Vector3::Unit(k);
    const Matrix3 up = at(y + shift);
    const Matrix3 down = at(y - shift);
    laplacian += (up + down - 2.0 * here) / (step * step);
    doublet.col(k) = (up - down) * b.normal / (2.0 * step);
  }
  const Matrix3 mirrored = Matrix3::Identity() - 2.0 * b.normal * b.normal.transpose();
  return -here + 2.0 * c * (0.5 * c * laplacian + doublet) * mirrored;
}

// What B takes beside A: the image in B, 2 h behind the colloid, is a force beside A.
Matrix3 taken_beside(const WideSurface& b, const WideSurface& a) {
  const Taken taken = taken_by(b);
  // Square roots, over those of the image's flow in the bulk.
  const Matrix3 q = axial(b.normal, std::sqrt(taken.along * b.height / 1.5),
                          std::sqrt(taken.across * b.height / 0.75));
  const Vector3 x = a.height * a.normal;
  const Matrix3 flow = -flow_of_image(x, b, a.normal);
  // Reciprocity makes it symmetric.  The image's flow vanishes at A as it should, most
  // along the normal: of what mixes normal and tangents that part is the better one.
  const Matrix3 normal = a.normal * a.normal.transpose();
  const Matrix3 tangents = Matrix3::Identity() - normal;
  const Matrix3 mixed = normal * flow * tangents;
  const Matrix3 pure = normal * flow * normal + tangents * flow * tangents;
  return q * (0.5 * (pure + pure.transpose()) + mixed + mixed.transpose()) * q;
}

}  // namespace

Matrix3 velocity_by_force_at_plane(const Vector3& x, const Vector3& y, const Vector3& n) {
  const double c = y.dot(n);
  if (c <= 0.0) {
    return Matrix3::Zero();
  }
  const Matrix3 one = Matrix3::Identity();
  const Vector3 d = x - y;
  const Vector3 big = d + 2.0 * c * n;
  const double r = d.norm();
  const double s = big.norm();
  const double s3 = s * s * s;
  const double up = big.dot(n);
  const Matrix3 dyad = big * big.transpose();
  const Matrix3 doublets = c * (one - 3.0 / (s * s) * dyad) + n * big.transpose() -
                           up * one - big * n.transpose() + 3.0 * up / (s * s) * dyad;
  return one / r + d * d.transpose() / (r * r * r) - one / s - dyad / s3 +
         2.0 * c / s3 * doublets * (one - 2.0 * n * n.transpose());
}

Matrix3 shielding(const std::vector<WideSurface>& surfaces) {
  if (surfaces.size() < 2) {
    return Matrix3::Zero();
  }
  const Matrix3 one = Matrix3::Identity();
  Matrix3 together = Matrix3::Zero();
  Matrix3 added = one;
  double weights = 0.0;
  for (const WideSurface& a : surfaces) {
    // Any of them may be taken for the first one; near one that is the right choice.
    const Taken taken = taken_by(a);
    const double weight = std::pow(taken.along, 4);
    Matrix3 beside = axial(a.normal, taken.along, taken.across);
    for (const WideSurface& b : surfaces) {
      if (&b != &a) {
        beside += taken_beside(b, a);
      }
    }
    together += weight * beside;
    weights += weight;
    added += axial(a.normal, 1.0 / (1.0 - taken.along), 1.0 / (1.0 - taken.across)) - one;
  }
  if (weights == 0.0) {
    return Matrix3::Zero();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> modes(together / weights);
  const Vector3 mobility = (1.0 - modes.eigenvalues().array()).max(kLeastMobility);
  const Matrix3 resistance = modes.eigenvectors() * mobility.cwiseInverse().asDiagonal() *
                             modes.eigenvectors().transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3> change(resistance - added);
  const Vector3 less = change.eigenvalues().cwiseMin(0.0);
  return change.eigenvectors() * less.asDiagonal() * change.eigenvectors().transpose();
}

}  // namespace colloid
