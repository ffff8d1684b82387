#include "tiers/transient/foam_momentum.h"

#include <cmath>
#include <memory>
#include <vector>

#include "tiers/transient/foam_vector_matrix.h"
#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

using Foam::label;
using Foam::scalarField;
using Foam::vectorField;

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
        boundary_coefficients_(matrix.boundaryCoeffs().component(0)) {
    weights_.reserve(entries.size());
    for (const ImmersedEntry& entry : entries) {
      weights_.push_back(entry.strength * mesh_.V()[entry.cell]);
    }
    eliminate_bodies();
    add_boundaries();
    add_entries();
    prepare_coarse();
    scale_ = mesh_.V() / Foam::sqr(matrix_.diag());
    links_ = std::make_unique<VectorMatrix>(matrix_, boundary_coefficients_, interfaces_);
  }

  const vectorField& source() const { return source_; }

  // y = A x, the bodies eliminated.
  void apply(const vectorField& x, vectorField& y) const {
    links_->multiply(x, y);
    forAll(extra_diagonal_, cell) {
      y[cell] += Foam::cmptMultiply(extra_diagonal_[cell], x[cell]);
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

  void precondition(const vectorField& r, vectorField& z) const {
    links_->precondition(r, z);
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
  void find_motions(const vectorField& u) {
    const std::vector<Six> sums = moments(u);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].free) {
        bodies_[b].motion = inverse_[b] * (sums[b] + bodies_[b].source);
      }
    }
  }

  // Cells inside bodies move with them from the start: where a body has just come, the
  // strong lambda would make of the old velocity nearly all of the residual.
  vectorField start() const {
    vectorField x = field_.primitiveField();
    for (const ImmersedEntry& entry : entries_) {
      if (entry.solid) {
        x[entry.cell] = foam(rigid_velocity(bodies_[at(entry.body)].motion, entry.arm));
      }
    }
    return x;
  }
  // Of a residual, over the diagonal: by how much velocities are off, had cells no
  // neighbours.  Cells inside bodies, with their strong lambda, would hide all others.
  double size(const vectorField& r) const {
    double sum = 0.0;
    forAll(r, cell) {
      sum += scale_[cell] * Foam::magSqr(r[cell]);
    }
    sum_over_ranks(&sum, 1);
    return std::sqrt(sum);
  }
  void finish(const vectorField& x) {
    field_.primitiveFieldRef() = x;
    field_.correctBoundaryConditions();
    matrix_.diag() = saved_diagonal_;
  }

 private:
  static Vec3 value(const vectorField& x, int cell) {
    return {x[cell].x(), x[cell].y(), x[cell].z()};
  }
  static void add(vectorField& x, int cell, const Vec3& v) {
    x[cell] += Foam::vector(v.x, v.y, v.z);
  }
  static void sum(std::vector<Six>& values) {
    sum_over_ranks(values.empty() ? nullptr : values.front().data(), 6 * values.size());
  }

  // Per free body: sum of lambda V^T u.
  std::vector<Six> moments(const vectorField& x) const {
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
    source_ = matrix_.source();
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
            if (extra_diagonal_.empty()) {
              extra_diagonal_ = vectorField(diagonal.size(), Foam::Zero);
            }
            extra_diagonal_[cells[i]][c] += more;
          }
        }
        if (!coupled) {
          source_[cells[i]] += matrix_.boundaryCoeffs()[patch][i];
        }
      }
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
  std::vector<double> weights_;    // lambda times volume, per entry
  std::vector<SixBySix> inverse_;  // of inertia + sum of lambda V^T V, per free body
  std::vector<Coarse> coarse_;
  vectorField source_;
  vectorField extra_diagonal_;  // of components y, z beyond that of x; empty: none
  scalarField saved_diagonal_;
  scalarField scale_;
  std::unique_ptr<VectorMatrix> links_;
};

double product(const vectorField& x, const vectorField& y) {
  Foam::vector sums = Foam::Zero;
  forAll(x, cell) {
    sums += Foam::cmptMultiply(x[cell], y[cell]);
  }
  double sum = sums.x() + sums.y() + sums.z();
  sum_over_ranks(&sum, 1);
  return sum;
}

void add_scaled(vectorField& y, double s, const vectorField& x) {
  forAll(y, cell) {
    y[cell] += s * x[cell];
  }
}

}  // namespace

SolveReport solve_momentum(Foam::fvVectorMatrix& matrix,
                           const std::vector<ImmersedEntry>& entries,
                           std::vector<MomentumBody>& bodies, double tolerance,
                           int most_iterations) {
  MomentumSystem system(matrix, entries, bodies);
  vectorField x = system.start();
  vectorField r = x;
  system.apply(x, r);
  forAll(r, cell) {
    r[cell] = system.source()[cell] - r[cell];
  }
  SolveReport report;
  report.initial = system.size(r);
  report.final = report.initial;
  const double target =
      std::max(tolerance * report.initial, 1e-12 * system.size(system.source()));
  const vectorField shadow = r;
  vectorField p = r;
  vectorField v = r;
  vectorField s = r;
  vectorField t = r;
  vectorField z = r;
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
    report.final = system.size(r);
    const double next = product(shadow, r);
    const double beta = next / rho * (alpha / omega);
    rho = next;
    forAll(p, cell) {
      p[cell] = r[cell] + beta * (p[cell] - omega * v[cell]);
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
