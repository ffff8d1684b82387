#include "particles/body_motion.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/error.h"

namespace colloid {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// Singular values of the bonds' rows below this count as zero: three contacts nearly in
// one line still let a body turn about that line.
constexpr double kRank = 1e-6;
constexpr std::size_t kMostExchanges = 10;  // of the active set, per contact

// Bodies that act on each other, and where their unknowns begin.
struct Group {
  std::vector<int> bodies;
  std::vector<int> pairs;
  std::vector<int> contacts;
};

std::size_t z(int i) {
  return static_cast<std::size_t>(i);
}

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[z(i)] != i) {
      parent_[z(i)] = parent_[z(parent_[z(i)])];
      i = parent_[z(i)];
    }
    return i;
  }
  void join(int i, int j) {
    // The smaller root stays, so that groups come in the order of their first body.
    const int a = root(i);
    const int b = root(j);
    parent_[z(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

std::vector<Group> find_groups(std::size_t bodies, const std::vector<PairTerm>& pairs,
                               const std::vector<ContactRow>& contacts) {
  Groups sets(bodies);
  for (const PairTerm& p : pairs) {
    sets.join(p.first, p.second);
  }
  for (const ContactRow& c : contacts) {
    if (c.second >= 0) {
      sets.join(c.first, c.second);
    }
  }
  std::vector<int> index(bodies, -1);
  std::vector<Group> groups;
  for (int b = 0; b < static_cast<int>(bodies); ++b) {
    const int root = sets.root(b);
    if (index[z(root)] < 0) {
      index[z(root)] = static_cast<int>(groups.size());
      groups.emplace_back();
    }
    groups[z(index[z(root)])].bodies.push_back(b);
  }
  for (int p = 0; p < static_cast<int>(pairs.size()); ++p) {
    groups[z(index[z(sets.root(pairs[z(p)].first))])].pairs.push_back(p);
  }
  for (int c = 0; c < static_cast<int>(contacts.size()); ++c) {
    groups[z(index[z(sets.root(contacts[z(c)].first))])].contacts.push_back(c);
  }
  return groups;
}

// One group in the coordinates that its bonds leave.
struct Reduced {
  Matrix resistance;
  Vector drive;
  std::vector<int> first;  // column of each body of the group
  std::vector<int> place;  // of a body in the group, by body; -1 elsewhere
};

// row' N of a two-body row, spread over the group's coordinates.
Vector spread(const std::vector<BodySystem>& bodies, const Reduced& r, int first,
              const Vector6& row_first, int second, const Vector6& row_second) {
  Vector row = Vector::Zero(r.drive.size());
  const auto put = [&](int body, const Vector6& part) {
    const auto& n = bodies[z(body)].freedom;
    row.segment(r.first[z(r.place[z(body)])], n.cols()) += n.transpose() * part;
  };
  put(first, row_first);
  if (second >= 0) {
    put(second, row_second);
  }
  return row;
}

Reduced reduce(const std::vector<BodySystem>& bodies, const std::vector<PairTerm>& pairs,
               const Group& group) {
  Reduced r;
  r.place.assign(bodies.size(), -1);
  int columns = 0;
  for (int b : group.bodies) {
    r.place[z(b)] = static_cast<int>(r.first.size());
    r.first.push_back(columns);
    columns += static_cast<int>(bodies[z(b)].freedom.cols());
  }
  r.resistance = Matrix::Zero(columns, columns);
  r.drive = Vector::Zero(columns);
  for (int b : group.bodies) {
    const BodySystem& body = bodies[z(b)];
    const auto& n = body.freedom;
    const int at = r.first[z(r.place[z(b)])];
    r.resistance.block(at, at, n.cols(), n.cols()) = n.transpose() * body.resistance * n;
    r.drive.segment(at, n.cols()) = n.transpose() * body.drive;
  }
  for (int p : group.pairs) {
    const PairTerm& pair = pairs[z(p)];
    // Only the blocks of its two bodies: a group may have hundreds of them.
    const std::array<Vector, 2> row{
        bodies[z(pair.first)].freedom.transpose() * pair.row_first,
        bodies[z(pair.second)].freedom.transpose() * pair.row_second};
    const std::array<int, 2> at{r.first[z(r.place[z(pair.first)])],
                                r.first[z(r.place[z(pair.second)])]};
    for (std::size_t i = 0; i < 2; ++i) {
      r.drive.segment(at[i], row[i].size()) += pair.drive * row[i];
      for (std::size_t j = 0; j < 2; ++j) {
        r.resistance.block(at[i], at[j], row[i].size(), row[j].size()) +=
            pair.strength * row[i] * row[j].transpose();
      }
    }
  }
  return r;
}

// A single free body without contacts: the common case, without the heap.
bool solve_alone(const BodySystem& body, Vector6& motion) {
  if (body.freedom.cols() != 6) {
    return false;
  }
  motion = body.resistance.llt().solve(body.drive);
  return true;
}

// Contacts in play and what is needed to find their forces.
struct ContactProblem {
  const Matrix& rows;  // C
  const Vector& free;  // motion without contacts
  Matrix response;     // R^-1 C'
  Matrix delassus;     // C R^-1 C'
};

// Forces on the active contacts that bring them to rest; of least norm, since contacts
// may be redundant (four grains hold three translations).
Vector forces_at_rest(const ContactProblem& problem,
                      const std::vector<Eigen::Index>& active) {
  const auto k = static_cast<Eigen::Index>(active.size());
  Matrix a(k, k);
  Vector b(k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index row = active[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < k; ++j) {
      a(i, j) = problem.delassus(row, active[static_cast<std::size_t>(j)]);
    }
    b[i] = -problem.rows.row(row).dot(problem.free);
  }
  return a.completeOrthogonalDecomposition().solve(b);
}

// The contact, neither active nor idle, that is violated most; -1: none is.
Eigen::Index worst_contact(const Vector& speed, const std::vector<char>& out_of_play,
                           double scale) {
  constexpr double kRounding = 1e-10;
  Eigen::Index worst = -1;
  double least = -kRounding * scale;
  for (Eigen::Index c = 0; c < speed.size(); ++c) {
    if (speed[c] < least && out_of_play[static_cast<std::size_t>(c)] == 0) {
      least = speed[c];
      worst = c;
    }
  }
  return worst;
}

// Moves the forces of the active contacts to those that bring them to rest, as far as
// none of them pulls; contacts that would are left out, one after the other.
void press(const ContactProblem& problem, std::vector<Eigen::Index>& active,
           Vector& force) {
  while (!active.empty()) {
    const Vector rest = forces_at_rest(problem, active);
    double part = 1.0;
    std::size_t first = active.size();
    for (std::size_t i = 0; i < active.size(); ++i) {
      const double now = force[active[i]];
      const double then = rest[static_cast<Eigen::Index>(i)];
      if (then < 0.0 && now / (now - then) < part) {
        part = now / (now - then);
        first = i;
      }
    }
    for (std::size_t i = 0; i < active.size(); ++i) {
      double& now = force[active[i]];
      now += part * (rest[static_cast<Eigen::Index>(i)] - now);
    }
    if (first == active.size()) {
      return;
    }
    force[active[first]] = 0.0;
    active.erase(active.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

// The contacts whose force presses: the active set of Lawson & Hanson (1974, algorithm
// NNLS), on the forces.  Adds the most violated and leaves out those that would pull; the
// dissipation falls at each exchange, so none comes back.
void solve_contacts(const Eigen::LLT<Matrix>& resistance, const Vector& free,
                    const Matrix& rows, Vector& q, Vector& force) {
  ContactProblem problem{rows, free, resistance.solve(rows.transpose()), {}};
  problem.delassus = rows * problem.response;
  const double scale = std::max(free.cwiseAbs().maxCoeff(), 1e-300);
  const auto contacts = static_cast<std::size_t>(rows.rows());
  std::vector<Eigen::Index> active;
  std::vector<char> idle(contacts, 0);  // violated by rounding alone
  force = Vector::Zero(rows.rows());
  q = free;
  for (std::size_t exchange = 0; exchange < kMostExchanges * (contacts + 1); ++exchange) {
    std::vector<char> out_of_play = idle;
    for (Eigen::Index c : active) {
      out_of_play[static_cast<std::size_t>(c)] = 1;
    }
    const Eigen::Index worst = worst_contact(rows * q, out_of_play, scale);
    if (worst < 0) {
      return;
    }
    active.push_back(worst);
    press(problem, active, force);
    if (force[worst] > 0.0) {
      std::fill(idle.begin(), idle.end(), 0);
    } else {
      idle[static_cast<std::size_t>(worst)] = 1;
    }
    q = free + problem.response * force;
  }
  throw ConvergenceError("contacts of a body: the active set does not settle");
}

void solve_group(const std::vector<BodySystem>& bodies,
                 const std::vector<PairTerm>& pairs,
                 const std::vector<ContactRow>& contacts, const Group& group,
                 BodyMotions& out) {
  const int only = group.bodies.front();
  if (group.bodies.size() == 1 && group.contacts.empty() &&
      solve_alone(bodies[z(only)], out.motion[z(only)])) {
    return;
  }
  const Reduced r = reduce(bodies, pairs, group);
  if (r.drive.size() == 0) {
    return;  // all held
  }
  const Eigen::LLT<Matrix> factor(r.resistance);
  Vector q = factor.solve(r.drive);
  if (!group.contacts.empty()) {
    Matrix rows(static_cast<Eigen::Index>(group.contacts.size()), r.drive.size());
    for (std::size_t i = 0; i < group.contacts.size(); ++i) {
      const ContactRow& c = contacts[z(group.contacts[i])];
      rows.row(static_cast<Eigen::Index>(i)) =
          spread(bodies, r, c.first, c.row_first, c.second, c.row_second).transpose();
    }
    const Vector free = q;
    Vector force;
    solve_contacts(factor, free, rows, q, force);
    for (std::size_t i = 0; i < group.contacts.size(); ++i) {
      out.contact_force[z(group.contacts[i])] = force[static_cast<Eigen::Index>(i)];
    }
  }
  for (int b : group.bodies) {
    const auto& n = bodies[z(b)].freedom;
    out.motion[z(b)] = n * q.segment(r.first[z(r.place[z(b)])], n.cols());
  }
}

// What is left of the balance of a bonded body is carried by its bonds.
void find_bond_wrenches(const std::vector<BodySystem>& bodies,
                        const std::vector<PairTerm>& pairs,
                        const std::vector<ContactRow>& contacts, BodyMotions& out) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    out.bond_wrench[b] = bodies[b].resistance * out.motion[b] - bodies[b].drive;
  }
  for (const PairTerm& p : pairs) {
    const double approach = p.row_first.dot(out.motion[z(p.first)]) +
                            p.row_second.dot(out.motion[z(p.second)]);
    const double force = p.strength * approach - p.drive;
    out.bond_wrench[z(p.first)] += force * p.row_first;
    out.bond_wrench[z(p.second)] += force * p.row_second;
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactRow& row = contacts[c];
    out.bond_wrench[z(row.first)] -= out.contact_force[c] * row.row_first;
    if (row.second >= 0) {
      out.bond_wrench[z(row.second)] -= out.contact_force[c] * row.row_second;
    }
  }
}

Matrix rows_at_rest(const std::vector<Vector3>& contacts) {
  Matrix rows(3 * static_cast<Eigen::Index>(contacts.size()), 6);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(i);
    rows.block<3, 3>(at, 0) = Matrix3::Identity();
    rows.block<3, 3>(at, 3) = -skew(contacts[i]);
  }
  return rows;
}

}  // namespace

BodyMotions solve_motion(const std::vector<BodySystem>& bodies,
                         const std::vector<PairTerm>& pairs,
                         const std::vector<ContactRow>& contacts) {
  BodyMotions out;
  out.motion.assign(bodies.size(), Vector6::Zero());
  out.contact_force.assign(contacts.size(), 0.0);
  out.bond_wrench.assign(bodies.size(), Vector6::Zero());
  for (const Group& group : find_groups(bodies.size(), pairs, contacts)) {
    solve_group(bodies, pairs, contacts, group, out);
  }
  find_bond_wrenches(bodies, pairs, contacts, out);
  for (const Vector6& motion : out.motion) {
    if (!motion.allFinite()) {
      throw ConvergenceError("velocity of a colloid: not a finite number");
    }
  }
  return out;
}

std::vector<Vector6> correlated_wrenches(const std::vector<BodySystem>& bodies,
                                         const std::vector<PairTerm>& pairs,
                                         const std::vector<Vector6>& normals) {
  std::vector<BodySystem> unbound = bodies;  // the bonds' forces come with the solve
  for (BodySystem& body : unbound) {
    body.freedom = Matrix6::Identity();
  }
  std::vector<Vector6> wrenches(bodies.size(), Vector6::Zero());
  for (const Group& group : find_groups(bodies.size(), pairs, {})) {
    const Reduced r = reduce(unbound, pairs, group);
    Vector draws(r.drive.size());
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
      draws.segment<6>(r.first[i]) = normals[z(group.bodies[i])];
    }
    const Vector wrench = r.resistance.llt().matrixL() * draws;
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
      wrenches[z(group.bodies[i])] = wrench.segment<6>(r.first[i]);
    }
  }
  return wrenches;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> motions_at_rest(
    const std::vector<Vector3>& contacts) {
  if (contacts.empty()) {
    return Matrix6::Identity();
  }
  if (contacts.size() == 1) {
    // U = -w x c: three rotations about the contact.
    Eigen::Matrix<double, 6, Eigen::Dynamic> motions(6, 3);
    motions.topRows<3>() = skew(contacts.front());
    motions.bottomRows<3>() = Matrix3::Identity();
    return motions;
  }
  const Eigen::JacobiSVD<Matrix> svd(rows_at_rest(contacts), Eigen::ComputeFullV);
  const Vector& values = svd.singularValues();
  const auto rank = (values.array() > kRank * values[0]).count();
  return svd.matrixV().rightCols(6 - rank);
}

std::vector<Vector3> contact_loads(const std::vector<Vector3>& contacts,
                                   const Vector6& load) {
  const Vector forces =
      rows_at_rest(contacts).transpose().completeOrthogonalDecomposition().solve(load);
  std::vector<Vector3> out;
  out.reserve(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    out.push_back(forces.segment<3>(3 * static_cast<Eigen::Index>(i)));
  }
  return out;
}

}  // namespace colloid
