#include "particles/two_planes.h"

#include <algorithm>
#include <cmath>

#include "particles/two_planes_table.h"

namespace colloid {

namespace {

constexpr int kEntries = 16;
constexpr int kNodes = 4;  // of the cubic between nodes of the table
using Entries = std::array<double, kEntries>;

// Lagrange's weights of the nodes around x, and the first of them.
struct Stencil {
  int first;
  std::array<double, kNodes> weight;
};

template <class Node>
Stencil stencil(double x, int count, Node node) {
  Stencil s{0, {}};
  while (s.first < count - kNodes && x > node(s.first + 2)) {
    ++s.first;
  }
  for (int i = 0; i < kNodes; ++i) {
    double w = 1.0;
    for (int j = 0; j < kNodes; ++j) {
      if (j != i) {
        w *= (x - node(s.first + j)) / (node(s.first + i) - node(s.first + j));
      }
    }
    s.weight[static_cast<std::size_t>(i)] = w;
  }
  return s;
}

Entries interpolate(double angle, double ratio) {
  const Stencil of_angle =
      stencil(angle, kPlaneAngles, [](int i) { return i * M_PI / (kPlaneAngles - 1); });
  const Stencil of_ratio =
      stencil(ratio, kPlaneRatios, [](int i) { return kPlaneRatio[i]; });
  Entries found{};
  for (int i = 0; i < kNodes; ++i) {
    for (int j = 0; j < kNodes; ++j) {
      const double w = of_angle.weight[static_cast<std::size_t>(i)] *
                       of_ratio.weight[static_cast<std::size_t>(j)];
      const auto& row = kTwoPlanes[of_angle.first + i][of_ratio.first + j];
      for (std::size_t k = 0; k < kEntries; ++k) {
        found[k] += w * row[k];
      }
    }
  }
  return found;
}

Matrix3 in_plane(double xx, double yy, double zz, double xy) {
  Matrix3 m;
  m << xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, zz;
  return m;
}

}  // namespace

SentBackByBoth sent_back_by_both(const Vector3& a, double to_a, const Vector3& b,
                                 double to_b) {
  if (to_a > to_b) {
    return sent_back_by_both(b, to_b, a, to_a);
  }
  const double cosine = std::clamp(a.dot(b), -1.0, 1.0);
  // x: a; y: in the plane of both normals; z: along the corner.
  Vector3 y = b - cosine * a;
  y = y.norm() > 1e-9 ? y.normalized() : a.unitOrthogonal();
  Matrix3 frame;
  frame << a, y, a.cross(y);
  const Entries v = interpolate(std::acos(cosine), to_a / to_b);
  const auto turned = [&](const Matrix3& m) -> Matrix3 {
    return frame * m * frame.transpose();
  };
  SentBackByBoth sent;
  sent.flow = turned(in_plane(v[0], v[1], v[2], v[3])) / to_b;
  sent.laplacian = turned(in_plane(v[4], v[5], v[6], v[7])) / (to_b * to_b * to_b);
  Matrix3 along_z;
  along_z << 0.0, 0.0, v[14], 0.0, 0.0, v[15], v[14], v[15], 0.0;
  const std::array<Matrix3, 3> strain{
      turned(in_plane(v[8], v[9], -v[8] - v[9], v[10])),
      turned(in_plane(v[11], v[12], -v[11] - v[12], v[13])), turned(along_z)};
  for (int j = 0; j < 3; ++j) {
    sent.strain[static_cast<std::size_t>(j)] =
        (frame(j, 0) * strain[0] + frame(j, 1) * strain[1] + frame(j, 2) * strain[2]) /
        (to_b * to_b);
  }
  return sent;
}

}  // namespace colloid
