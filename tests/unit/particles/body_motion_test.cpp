// The motion that dissipates least, against the conditions that define it.
#include "particles/body_motion.h"

#include <random>

#include <gtest/gtest.h>

namespace colloid {
namespace {

// Karush, Kuhn & Tucker: R V = D + C' nu, C V >= 0, nu >= 0, nu (C V) = 0.  Unique, so a
// motion that fulfils them is the right one.
void expect_optimal(const BodySystem& body, const std::vector<ContactRow>& rows) {
  const BodyMotions solved = solve_motion({body}, {}, rows);
  const Vector6& v = solved.motion[0];
  Vector6 rest = body.resistance * v - body.drive;
  const double scale = body.drive.norm();
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const double speed = rows[c].row_first.dot(v);
    const double force = solved.contact_force[c];
    rest -= force * rows[c].row_first;
    EXPECT_GE(speed, -1e-9 * scale);
    EXPECT_GE(force, 0.0);
    EXPECT_NEAR(speed * force, 0.0, 1e-9 * scale * scale);
  }
  EXPECT_LT((body.freedom.transpose() * rest).norm(), 1e-9 * scale);
}

class Draws {
 public:
  double uniform() {
    return 2.0 * static_cast<double>(generator_() >> 11) * 0x1p-53 - 1.0;
  }
  Vector3 direction() {
    for (;;) {
      const Vector3 v(uniform(), uniform(), uniform());
      if (v.norm() > 0.1 && v.norm() < 1.0) {
        return v.normalized();
      }
    }
  }
  BodySystem body() {
    Matrix6 m;
    for (int i = 0; i < 36; ++i) {
      m(i / 6, i % 6) = uniform();
    }
    BodySystem out;
    out.resistance = m * m.transpose() + Matrix6::Identity();
    for (int i = 0; i < 6; ++i) {
      out.drive[i] = uniform();
    }
    return out;
  }

 private:
  std::mt19937_64 generator_{7};
};

ContactRow push_along(const Vector3& n) {
  ContactRow row;
  row.first = 0;
  row.row_first << n, Vector3::Zero();
  return row;
}

TEST(Contacts, SolutionIsOptimalForRandomContacts) {
  Draws draws;
  for (int n = 0; n < 2000; ++n) {
    const BodySystem body = draws.body();
    std::vector<ContactRow> rows;
    for (int c = 0; c <= n % 4; ++c) {
      ContactRow row = push_along(draws.direction());
      row.row_first.tail<3>() = draws.direction();
      rows.push_back(row);
    }
    expect_optimal(body, rows);
  }
}

// Up to eight normals on a sphere: more contacts than translations, so that forces are
// not unique and rows depend on each other.
TEST(Contacts, RedundantContactsOfASphereAreOptimalToo) {
  Draws draws;
  for (int n = 0; n < 2000; ++n) {
    BodySystem body = draws.body();
    std::vector<ContactRow> rows;
    const int count = 4 + n % 5;
    for (int c = 0; c < count; ++c) {
      Vector3 normal = draws.direction();
      normal.z() = std::abs(normal.z());
      rows.push_back(push_along(normal));
    }
    expect_optimal(body, rows);
  }
}

// Wedged between four grains of a throat, driven in any direction.
TEST(Contacts, FourGrainsHoldASphereThatIsPushedDown) {
  Draws draws;
  const double low = 0.08;
  std::vector<ContactRow> rows;
  for (const Vector3& n : {Vector3(1, 1, low), Vector3(-1, 1, low), Vector3(1, -1, low),
                           Vector3(-1, -1, low)}) {
    rows.push_back(push_along(n.normalized()));
  }
  for (int n = 0; n < 500; ++n) {
    BodySystem body;
    body.resistance.diagonal() << 1, 1, 1, 4.0 / 3, 4.0 / 3, 4.0 / 3;
    body.drive << draws.direction(), Vector3::Zero();
    body.drive[2] = -std::abs(body.drive[2]);
    expect_optimal(body, rows);
    // Sideways by less than the slope lets: held.
    body.drive[0] *= 0.05;
    body.drive[1] *= 0.05;
    body.drive[2] = -1.0;
    EXPECT_LT(solve_motion({body}, {}, rows).motion[0].norm(), 1e-9);
  }
}

}  // namespace
}  // namespace colloid
