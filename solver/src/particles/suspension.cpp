#include "particles/suspension.h"

#include <algorithm>
#include <cmath>

namespace colloid {

bool RigidBody::bonded_to(std::size_t member, const SurfaceId& fixed) const {
  return std::any_of(bonds.begin(), bonds.end(), [&](const Bond& bond) {
    return bond.member == static_cast<int>(member) && bond.fixed == fixed;
  });
}

RigidBody single(const MobileColloid& colloid, const Vec3& position) {
  RigidBody body;
  body.members = {colloid};
  body.centre = position;
  body.arms = {Vec3{}};
  return body;
}

namespace {

// Centre and arms for members at these places.
void place(RigidBody& body, const std::vector<Vec3>& positions) {
  Vec3 sum;
  for (const Vec3& x : positions) {
    sum += x;
  }
  body.centre = sum * (1.0 / static_cast<double>(positions.size()));
  body.arms.clear();
  for (const Vec3& x : positions) {
    body.arms.push_back(x - body.centre);
  }
}

}  // namespace

RigidBody joined(const RigidBody& a, const RigidBody& b, const Vec3& shift) {
  RigidBody body;
  body.members = a.members;
  body.members.insert(body.members.end(), b.members.begin(), b.members.end());
  std::vector<Vec3> positions;
  positions.reserve(body.size());
  for (std::size_t m = 0; m < a.size(); ++m) {
    positions.push_back(a.position(m));
  }
  for (std::size_t m = 0; m < b.size(); ++m) {
    positions.push_back(b.position(m) + shift);
  }
  place(body, positions);
  body.bonds = a.bonds;
  for (Bond bond : b.bonds) {
    bond.member += static_cast<int>(a.size());
    bond.anchor += shift;
    body.bonds.push_back(bond);
  }
  return body;
}

RigidBody without(const RigidBody& body, std::size_t member) {
  RigidBody rest;
  std::vector<Vec3> positions;
  for (std::size_t m = 0; m < body.size(); ++m) {
    if (m != member) {
      rest.members.push_back(body.members[m]);
      positions.push_back(body.position(m));
    }
  }
  place(rest, positions);
  for (Bond bond : body.bonds) {
    if (bond.member != static_cast<int>(member)) {
      bond.member -= bond.member > static_cast<int>(member) ? 1 : 0;
      rest.bonds.push_back(bond);
    }
  }
  return rest;
}

Vec3 turned(const Vec3& v, const Vec3& turn) {
  const double angle = norm(turn);
  if (angle == 0.0) {
    return v;
  }
  const Vec3 axis = turn * (1.0 / angle);
  // 1 - cos = 2 sin^2(angle/2) keeps its digits for small angles.
  const double half = std::sin(0.5 * angle);
  return v + std::sin(angle) * cross(axis, v) +
         2.0 * half * half * cross(axis, cross(axis, v));
}

Vec3 bond_contact(const RigidBody& body, const Bond& bond, const Box& box,
                  double radius) {
  const auto m = static_cast<std::size_t>(bond.member);
  const Vec3 e = shortest(box, bond.anchor, body.position(m));
  // Half of the gap is the colloid's.
  const double lever = 0.5 * (bond.distance - 2.0 * radius) + radius;
  return body.arms[m] + e * (lever / norm(e));
}

Vector6 normal_row(const RigidBody& body, std::size_t member, const Vec3& n,
                   double radius) {
  Vector6 row;
  row << eigen(n), eigen(cross(body.arms[member], n)) / radius;
  return row;
}

std::vector<Vector3> bond_contacts(const RigidBody& body, const Box& box, double radius) {
  std::vector<Vector3> points;
  points.reserve(body.bonds.size());
  for (const Bond& bond : body.bonds) {
    points.push_back(eigen(bond_contact(body, bond, box, radius)) / radius);
  }
  return points;
}

void displace(RigidBody& body, const Vec3& step, const Vec3& turn) {
  body.centre += step;
  for (Vec3& arm : body.arms) {
    arm = turned(arm, turn);
  }
}

}  // namespace colloid
