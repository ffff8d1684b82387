#include "tiers/transient/foam_momentum.h"

#include <array>
#include <cmath>

#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

using Foam::label;
using Foam::scalarField;
using Components = std::array<scalarField, 3>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// The system of one step: OpenFOAM's matrix with what its own segregated solver would
// add, the entries, and the bodies.
class MomentumSystem {
 public:
  MomentumSystem(Foam::fvVectorMatrix& matrix, const std::vector<ImmersedEntry>& entries,
                 std::vector<MomentumBody>& bodies)
      : matrix_(matrix),
        field_(const_cast<Foam::volVectorField&>(matrix.psi())),
        mesh_(field_.mesh()),
        entries_(entries),
        bodies_(bodies),
        interfaces_(field_.boundaryField().scalarInterfaces()),
        boundary_coefficients_(matrix.boundaryCoeffs().component(0)),
        internal_coefficients_(matrix.internalCoeffs().component(0)) {
    weights_.reserve(entries.size());
    for (const ImmersedEntry& entry : entries) {
      weights_.push_back(entry.strength * mesh_.V()[entry.cell]);
    }
    eliminate_bodies();
    add_boundaries();
    add_entries();
    prepare_coarse();
    Foam::dictionary controls = mesh_.solverDict("U");
    solver_ = Foam::lduMatrix::solver::New("U", matrix_, boundary_coefficients_,
                                           internal_coefficients_, interfaces_, controls);
    preconditioner_ = Foam::lduMatrix::preconditioner::New(*solver_, controls);
  }

  const Components& source() const { return source_; }

  // y = A x, the bodies eliminated.
  void apply(const Components& x, Components& y) const {
    for (Foam::direction c = 0; c < 3; ++c) {
      matrix_.Amul(y[c], x[c], boundary_coefficients_, interfaces_, c);
      if (!extra_diagonal_[c].empty()) {
        y[c] += extra_diagonal_[c] * x[c];
      }
    }
    std::vector<Six> sums = moments(x);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].free) {
        sums[b] = inverse_[b] * sums[b];
      }
    }
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const ImmersedEntry& entry = entries_[e];
      if (bodies_[at(entry.body)].free) {
        add(y, entry.cell,
            rigid_velocity(sums[at(entry.body)], entry.arm) * -weights_[e]);
      }
    }
  }

  void precondition(const Components& r, Components& z) const {
    for (Foam::direction c = 0; c < 3; ++c) {
      preconditioner_->precondition(z[c], r[c], c);
    }
    std::vector<Six> sums(bodies_.size(), Six::Zero());
    for (const ImmersedEntry& entry : entries_) {
      if (entry.solid && bodies_[at(entry.body)].free) {
        sums[at(entry.body)] += wrench(value(r, entry.cell), entry.arm);
      }
    }
    sum(sums);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].free) {
        sums[b] = coarse_[b].solve(sums[b]);
      }
    }
    for (const ImmersedEntry& entry : entries_) {
      if (entry.solid && bodies_[at(entry.body)].free) {
        add(z, entry.cell, rigid_velocity(sums[at(entry.body)], entry.arm));
      }
    }
  }

  // The motions of free bodies that belong to u.
  void find_motions(const Components& u) {
    const std::vector<Six> sums = moments(u);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].free) {
        bodies_[b].motion = inverse_[b] * (sums[b] + bodies_[b].source);
      }
    }
  }

  Components start() const {
    Components x;
    for (Foam::direction c = 0; c < 3; ++c) {
      x[c] = field_.primitiveField().component(c);
    }
    return x;
  }
  void finish(const Components& x) {
    for (Foam::direction c = 0; c < 3; ++c) {
      field_.primitiveFieldRef().replace(c, x[c]);
    }
    field_.correctBoundaryConditions();
    matrix_.diag() = saved_diagonal_;
  }

 private:
  static Vec3 value(const Components& x, int cell) {
    return {x[0][cell], x[1][cell], x[2][cell]};
  }
  static void add(Components& x, int cell, const Vec3& v) {
    x[0][cell] += v.x;
    x[1][cell] += v.y;
    x[2][cell] += v.z;
  }
  static void sum(std::vector<Six>& values) {
    sum_over_ranks(values.empty() ? nullptr : values.front().data(), 6 * values.size());
  }

  // Per free body: sum of lambda V^T u.
  std::vector<Six> moments(const Components& x) const {
    std::vector<Six> sums(bodies_.size(), Six::Zero());
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const ImmersedEntry& entry = entries_[e];
      if (bodies_[at(entry.body)].free) {
        sums[at(entry.body)] += wrench(value(x, entry.cell) * weights_[e], entry.arm);
      }
    }
    sum(sums);
    return sums;
  }

  void eliminate_bodies() {
    std::vector<SixBySix> products(bodies_.size(), SixBySix::Zero());
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      products[at(entries_[e].body)] += weights_[e] * motion_products(entries_[e].arm);
    }
    sum_over_ranks(products.empty() ? nullptr : products.front().data(),
                   36 * products.size());
    inverse_.assign(bodies_.size(), SixBySix::Zero());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].free) {
        inverse_[b] = scaled_inverse(products[b] + bodies_[b].inertia);
      }
    }
  }

  // Of a symmetric matrix whose rows have different units.
  static SixBySix scaled_inverse(const SixBySix& m) {
    const Six scale = m.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    const SixBySix scaled = scale.asDiagonal() * m * scale.asDiagonal();
    return scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
  }

  void add_boundaries() {
    saved_diagonal_ = matrix_.diag();
    Foam::vectorField source(matrix_.source());
    scalarField& diagonal = matrix_.diag();
    forAll(field_.boundaryField(), patch) {
      const Foam::labelUList& cells = mesh_.lduAddr().patchAddr(patch);
      const Foam::vectorField& internal = matrix_.internalCoeffs()[patch];
      const bool coupled = field_.boundaryField()[patch].coupled();
      forAll(cells, i) {
        diagonal[cells[i]] += internal[i].x();
        for (Foam::direction c = 1; c < 3; ++c) {
          const double more = internal[i][c] - internal[i].x();
          if (more != 0.0) {
            if (extra_diagonal_[c].empty()) {
              extra_diagonal_[c] = scalarField(diagonal.size(), 0.0);
            }
            extra_diagonal_[c][cells[i]] += more;
          }
        }
        if (!coupled) {
          source[cells[i]] += matrix_.boundaryCoeffs()[patch][i];
        }
      }
    }
    for (Foam::direction c = 0; c < 3; ++c) {
      source_[c] = source.component(c);
    }
  }

  void add_entries() {
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const ImmersedEntry& entry = entries_[e];
      const MomentumBody& body = bodies_[at(entry.body)];
      matrix_.diag()[entry.cell] += weights_[e];
      const Six motion =
          body.free ? Six(inverse_[at(entry.body)] * body.source) : body.motion;
      add(source_, entry.cell, rigid_velocity(motion, entry.arm) * weights_[e]);
    }
  }

  // Z^T A Z, Z the rigid motion in the cells inside: the links to cells outside, what the
  // entries outside hold, and the inertia of the whole body.
  void prepare_coarse() {
    std::vector<int> inside(at(mesh_.nCells()), -1);  // entry by cell
    std::vector<SixBySix> blocks(bodies_.size(), SixBySix::Zero());
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const ImmersedEntry& entry = entries_[e];
      if (!bodies_[at(entry.body)].free) {
        continue;
      }
      if (entry.solid) {
        inside[at(entry.cell)] = static_cast<int>(e);
      } else {
        blocks[at(entry.body)] += weights_[e] * motion_products(entry.arm);
      }
    }
    const Foam::labelUList& owner = mesh_.owner();
    const Foam::labelUList& neighbour = mesh_.neighbour();
    forAll(neighbour, face) {
      const int p = inside[at(owner[face])];
      const int n = inside[at(neighbour[face])];
      const int body_p = p < 0 ? -1 : entries_[at(p)].body;
      const int body_n = n < 0 ? -1 : entries_[at(n)].body;
      if (body_p == body_n) {
        continue;
      }
      const double link = -0.5 * (matrix_.upper()[face] + matrix_.lower()[face]);
      for (const int e : {p, n}) {
        if (e >= 0) {
          blocks[at(entries_[at(e)].body)] += link * motion_products(entries_[at(e)].arm);
        }
      }
    }
    sum_over_ranks(blocks.empty() ? nullptr : blocks.front().data(), 36 * blocks.size());
    coarse_.resize(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].free) {
        coarse_[b].inverse = scaled_inverse(blocks[b] + bodies_[b].whole_inertia);
      }
    }
  }

  struct Coarse {
    SixBySix inverse = SixBySix::Zero();
    Six solve(const Six& r) const { return inverse * r; }
  };

  Foam::fvVectorMatrix& matrix_;
  Foam::volVectorField& field_;
  const Foam::fvMesh& mesh_;
  const std::vector<ImmersedEntry>& entries_;
  std::vector<MomentumBody>& bodies_;
  Foam::lduInterfaceFieldPtrsList interfaces_;
  Foam::FieldField<Foam::Field, Foam::scalar> boundary_coefficients_;
  Foam::FieldField<Foam::Field, Foam::scalar> internal_coefficients_;
  std::vector<double> weights_;    // lambda times volume, per entry
  std::vector<SixBySix> inverse_;  // of inertia + sum of lambda V^T V, per free body
  std::vector<Coarse> coarse_;
  Components source_;
  std::array<scalarField, 3> extra_diagonal_;  // of components y, z beyond that of x
  scalarField saved_diagonal_;
  Foam::autoPtr<Foam::lduMatrix::solver> solver_;
  Foam::autoPtr<Foam::lduMatrix::preconditioner> preconditioner_;
};

double product(const Components& x, const Components& y) {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    sum += Foam::sumProd(x[c], y[c]);
  }
  sum_over_ranks(&sum, 1);
  return sum;
}

void add_scaled(Components& y, double s, const Components& x) {
  for (std::size_t c = 0; c < 3; ++c) {
    double* const to = y[c].begin();
    const double* const from = x[c].begin();
    const label n = y[c].size();
    for (label i = 0; i < n; ++i) {
      to[i] += s * from[i];
    }
  }
}

}  // namespace

SolveReport solve_momentum(Foam::fvVectorMatrix& matrix,
                           const std::vector<ImmersedEntry>& entries,
                           std::vector<MomentumBody>& bodies, double tolerance,
                           int most_iterations) {
  MomentumSystem system(matrix, entries, bodies);
  Components x = system.start();
  Components r = x;
  system.apply(x, r);
  for (std::size_t c = 0; c < 3; ++c) {
    r[c] = system.source()[c] - r[c];
  }
  SolveReport report;
  report.initial = std::sqrt(product(r, r));
  report.final = report.initial;
  const double scale = std::sqrt(product(system.source(), system.source()));
  const double target = std::max(tolerance * report.initial, 1e-12 * scale);
  const Components shadow = r;
  Components p = r;
  Components v = r;
  Components s = r;
  Components t = r;
  Components z = r;
  double rho = product(shadow, r);
  while (report.final > target && report.iterations < most_iterations) {
    ++report.iterations;
    system.precondition(p, z);
    system.apply(z, v);
    const double alpha = rho / product(shadow, v);
    add_scaled(x, alpha, z);
    s = r;
    add_scaled(s, -alpha, v);
    system.precondition(s, z);
    system.apply(z, t);
    const double omega = product(t, s) / product(t, t);
    add_scaled(x, omega, z);
    r = s;
    add_scaled(r, -omega, t);
    report.final = std::sqrt(product(r, r));
    const double next = product(shadow, r);
    const double beta = next / rho * (alpha / omega);
    rho = next;
    // p = r + beta (p - omega v)
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = r[c] + beta * (p[c] - omega * v[c]);
    }
    if (!std::isfinite(report.final)) {
      break;
    }
  }
  system.find_motions(x);
  system.finish(x);
  return report;
}

}  // namespace colloid
