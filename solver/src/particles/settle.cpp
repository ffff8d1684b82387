#include "particles/settle.h"

#include <cmath>

namespace colloid {

namespace {

constexpr int kIterations = 3;  // Newton's: errors fall from 1e-6 to rounding in two

struct Row {
  Vector6 row_first;
  Vector6 row_second;
  double excess;  // distance too large by this [m]
  int first;
  int second;
};

void add_bonds(const std::vector<RigidBody>& bodies, const Box& box, double radius,
               std::vector<Row>& rows) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const Bond& bond : bodies[b].bonds) {
      const auto m = static_cast<std::size_t>(bond.member);
      const Vec3 e = shortest(box, bodies[b].position(m), bond.anchor);
      const double r = norm(e);
      rows.push_back({normal_row(bodies[b], m, e * (1.0 / r), radius), Vector6::Zero(),
                      r - bond.distance, static_cast<int>(b), -1});
    }
  }
}

void add_contacts(const std::vector<RigidBody>& bodies,
                  const std::vector<Contact>& pressed, const FixedSurfaces& surfaces,
                  const ContactRules& rules, double radius, std::vector<Row>& rows) {
  for (const Contact& contact : pressed) {
    const auto b = static_cast<std::size_t>(contact.body);
    const auto m = static_cast<std::size_t>(contact.member);
    const Vec3 x = bodies[b].position(m);
    if (contact.other_body >= 0) {
      const auto other = static_cast<std::size_t>(contact.other_body);
      const auto om = static_cast<std::size_t>(contact.other_member);
      const Vec3 e = shortest(surfaces.box(), x, bodies[other].position(om));
      const double r = norm(e);
      const Vec3 n = e * (1.0 / r);
      rows.push_back(
          {normal_row(bodies[b], m, n, radius), -normal_row(bodies[other], om, n, radius),
           r - 2.0 * radius - rules.colloid_gap, contact.body, contact.other_body});
      continue;
    }
    const NearSurface surface = surfaces.seen_from(x, contact.fixed);
    rows.push_back(
        {normal_row(bodies[b], m, surface.normal, radius), Vector6::Zero(),
         surface.distance - radius - contact_gap(rules, surfaces.box(), surface.id),
         contact.body, -1});
  }
}

}  // namespace

void keep_distances(std::vector<RigidBody>& bodies, const std::vector<Contact>& pressed,
                    const FixedSurfaces& surfaces, const ContactRules& rules,
                    double radius) {
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    std::vector<Row> rows;
    add_bonds(bodies, surfaces.box(), radius, rows);
    add_contacts(bodies, pressed, surfaces, rules, radius, rows);
    if (rows.empty()) {
      return;
    }
    const auto m = static_cast<Eigen::Index>(rows.size());
    const auto n = static_cast<Eigen::Index>(6 * bodies.size());
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(m, n);
    Eigen::VectorXd excess(m);
    for (Eigen::Index i = 0; i < m; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      jacobian.block<1, 6>(i, 6 * static_cast<Eigen::Index>(row.first)) +=
          row.row_first.transpose();
      if (row.second >= 0) {
        jacobian.block<1, 6>(i, 6 * static_cast<Eigen::Index>(row.second)) +=
            row.row_second.transpose();
      }
      excess[i] = row.excess;
    }
    const Eigen::VectorXd change =
        -(jacobian.transpose() * (jacobian * jacobian.transpose())
                                     .completeOrthogonalDecomposition()
                                     .solve(excess));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const Vector6 six = change.segment<6>(6 * static_cast<Eigen::Index>(b));
      if (six.cwiseAbs().maxCoeff() > 0.0) {
        displace(bodies[b], plain(six.head<3>()), plain(six.tail<3>()) * (1.0 / radius));
      }
    }
  }
}

}  // namespace colloid
