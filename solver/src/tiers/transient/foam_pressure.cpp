#include "tiers/transient/foam_pressure.h"

#include <algorithm>
#include <cmath>

#include "particles/surfaces.h"
#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// OpenFOAM chooses solvers by name and hands them a matrix alone; the bodies of the solve
// under way are left here for it.
const PressureCorrection* active = nullptr;
int active_iterations = 0;
double active_initial = 0.0;
double active_final = 0.0;

// Conjugate gradients (Hestenes & Stiefel 1952) on the Laplacian plus the bodies' terms,
// preconditioned by multigrid on the Laplacian alone: the terms are of low rank.
class RigidPCG : public Foam::lduMatrix::solver {
 public:
  TypeName("rigidPCG");

  RigidPCG(const Foam::word& name, const Foam::lduMatrix& matrix,
           const Foam::FieldField<Foam::Field, Foam::scalar>& boundary,
           const Foam::FieldField<Foam::Field, Foam::scalar>& internal,
           const Foam::lduInterfaceFieldPtrsList& interfaces,
           const Foam::dictionary& controls)
      : Foam::lduMatrix::solver(name, matrix, boundary, internal, interfaces, controls) {}

  Foam::solverPerformance solve(Foam::scalarField& psi, const Foam::scalarField& source,
                                const Foam::direction component) const override {
    Foam::solverPerformance report(typeName, fieldName_);
    Foam::scalarField w(psi.size());
    apply(psi, w, component);
    Foam::scalarField r(source - w);
    // Relative to starting from zero, which a bad guess does not beat.
    active_initial = std::sqrt(Foam::gSumSqr(source));
    active_final = std::sqrt(Foam::gSumSqr(r));
    if (!(active_final < active_initial)) {
      psi = 0.0;
      r = source;
      active_final = active_initial;
    }
    active_iterations = 0;
    const double target = relTol_ * active_initial;
    if (active_final > target) {
      auto preconditioner = Foam::lduMatrix::preconditioner::New(*this, controlDict_);
      Foam::scalarField p(psi.size(), 0.0);
      double rho = 0.0;
      do {
        preconditioner->precondition(w, r, component);
        const double next = Foam::gSumProd(w, r);
        const double beta = active_iterations == 0 ? 0.0 : next / rho;
        rho = next;
        p = w + beta * p;
        apply(p, w, component);
        const double alpha = rho / Foam::gSumProd(p, w);
        psi += alpha * p;
        r -= alpha * w;
        active_final = std::sqrt(Foam::gSumSqr(r));
      } while (++active_iterations < maxIter_ && active_final > target &&
               std::isfinite(active_final));
    }
    return report;
  }

 private:
  void apply(const Foam::scalarField& x, Foam::scalarField& y,
             const Foam::direction component) const {
    matrix_.Amul(y, x, interfaceBouCoeffs_, interfaces_, component);
    active->add_bodies(x, y);
  }
};

defineTypeNameAndDebug(RigidPCG, 0);
const Foam::lduMatrix::solver::addsymMatrixConstructorToTable<RigidPCG> kAdded;

Foam::IOobject unregistered(const char* name, const Foam::fvMesh& mesh) {
  return Foam::IOobject(name, mesh.time().timeName(), mesh, Foam::IOobject::NO_READ,
                        Foam::IOobject::NO_WRITE, false);
}

}  // namespace

PressureCorrection::PressureCorrection(const Foam::fvMesh& mesh, const Box& box,
                                       const std::vector<Sphere>& spheres,
                                       const std::vector<ImmersedEntry>& entries,
                                       const std::vector<MomentumBody>& bodies, double dt)
    : mesh_(mesh),
      box_(box),
      spheres_(spheres),
      entries_(entries),
      rate_(unregistered("rate", mesh), mesh,
            Foam::dimensionedScalar("dt", Foam::dimTime, dt)),
      beta_(unregistered("beta", mesh), mesh,
            Foam::dimensionedScalar("b", Foam::dimless, 0.0)),
      body_of_(unregistered("bodyOf", mesh), mesh,
               Foam::dimensionedScalar("n", Foam::dimless, -1.0)) {
  std::vector<SixBySix> products(bodies.size(), SixBySix::Zero());
  for (const ImmersedEntry& entry : entries) {
    if (!entry.solid) {
      continue;
    }
    double& rate = rate_.primitiveFieldRef()[entry.cell];
    rate = std::min(rate, 1.0 / (1.0 / dt + entry.strength));
    if (bodies[at(entry.body)].free) {
      const double beta = entry.strength / (1.0 / dt + entry.strength);
      beta_.primitiveFieldRef()[entry.cell] = beta;
      body_of_.primitiveFieldRef()[entry.cell] = entry.body;
      products[at(entry.body)] +=
          mesh.V()[entry.cell] * beta / dt * motion_products(entry.arm);
    }
  }
  rate_.correctBoundaryConditions();
  beta_.correctBoundaryConditions();
  body_of_.correctBoundaryConditions();
  sum_over_ranks(products.empty() ? nullptr : products.front().data(),
                 36 * products.size());
  inverse_.assign(bodies.size(), SixBySix::Zero());
  free_.resize(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    free_[b] = bodies[b].free;
    if (free_[b]) {
      const SixBySix m = products[b] + bodies[b].inertia;
      const Six scale = m.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
      inverse_[b] = scale.asDiagonal() *
                    SixBySix(scale.asDiagonal() * m * scale.asDiagonal()).inverse() *
                    scale.asDiagonal();
    }
  }
  find_terms();
}

// Fluxes of each body's rigid motions through the faces of its cells.
void PressureCorrection::find_terms() {
  std::vector<const ImmersedEntry*> inside(at(mesh_.nCells()), nullptr);
  for (const ImmersedEntry& entry : entries_) {
    if (entry.solid && free_[at(entry.body)]) {
      inside[at(entry.cell)] = &entry;
    }
  }
  find_internal_terms(inside);
  find_coupled_terms(inside);
  // One term per cell and body.
  std::vector<CellTerm> terms;
  std::swap(terms, cells_);
  std::stable_sort(terms.begin(), terms.end(), [](const CellTerm& a, const CellTerm& b) {
    return a.body != b.body ? a.body < b.body : a.cell < b.cell;
  });
  for (const CellTerm& term : terms) {
    if (!cells_.empty() && cells_.back().cell == term.cell &&
        cells_.back().body == term.body) {
      cells_.back().divergence += term.divergence;
    } else {
      cells_.push_back(term);
    }
  }
}

// A face of area `area`, and the share of it that a cell at `arm` of the body has; `from`
// and `to`: its cells, -1 for one of another rank.
void PressureCorrection::add_term(const FaceTerm& face, double share, const Vec3& arm,
                                  const Foam::vector& area, int from, int to) {
  FaceTerm term = face;
  term.flux = share * wrench(vec3(area), arm);
  faces_.push_back(term);
  cells_.push_back({from, term.body, term.flux});
  if (to >= 0) {
    cells_.push_back({to, term.body, -term.flux});
  }
}

void PressureCorrection::find_internal_terms(
    const std::vector<const ImmersedEntry*>& inside) {
  const Foam::labelUList& owner = mesh_.owner();
  const Foam::labelUList& neighbour = mesh_.neighbour();
  const Foam::surfaceScalarField& weights = mesh_.weights();
  forAll(neighbour, face) {
    for (const bool first : {true, false}) {
      const int cell = first ? owner[face] : neighbour[face];
      if (const ImmersedEntry* entry = inside[at(cell)]) {
        const double weight = first ? weights[face] : 1.0 - weights[face];
        add_term({face, -1, entry->body, {}}, weight * beta_[cell], entry->arm,
                 mesh_.Sf()[face], owner[face], neighbour[face]);
      }
    }
  }
}

void PressureCorrection::find_coupled_terms(
    const std::vector<const ImmersedEntry*>& inside) {
  forAll(mesh_.boundary(), patch) {
    const Foam::fvPatch& faces = mesh_.boundary()[patch];
    if (!faces.coupled()) {
      continue;
    }
    const Foam::scalarField other_beta(
        beta_.boundaryField()[patch].patchNeighbourField());
    const Foam::scalarField other_body(
        body_of_.boundaryField()[patch].patchNeighbourField());
    const Foam::vectorField delta(faces.delta());
    forAll(faces, i) {
      const int cell = faces.faceCells()[i];
      const double weight = mesh_.weights().boundaryField()[patch][i];
      const Foam::vector& area = mesh_.Sf().boundaryField()[patch][i];
      if (const ImmersedEntry* entry = inside[at(cell)]) {
        add_term({i, patch, entry->body, {}}, weight * beta_[cell], entry->arm, area,
                 cell, -1);
      }
      const int other = static_cast<int>(std::lround(other_body[i]));
      if (other >= 0) {
        const Vec3 there = vec3(mesh_.C()[cell] + delta[i]);
        add_term({i, patch, other, {}}, (1.0 - weight) * other_beta[i],
                 shortest(box_, there, spheres_[at(other)].center), area, cell, -1);
      }
    }
  }
}

void PressureCorrection::add_bodies(const Foam::scalarField& x,
                                    Foam::scalarField& y) const {
  const std::vector<Six> motions = motions_of(x);
  for (const CellTerm& term : cells_) {
    y[term.cell] -= term.divergence.dot(motions[at(term.body)]);
  }
}

// B^-1 g^T dp.
std::vector<Six> PressureCorrection::motions_of(const Foam::scalarField& dp) const {
  std::vector<Six> sums(free_.size(), Six::Zero());
  for (const CellTerm& term : cells_) {
    sums[at(term.body)] += term.divergence * dp[term.cell];
  }
  sum_over_ranks(sums.empty() ? nullptr : sums.front().data(), 6 * sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b) {
    sums[b] = inverse_[b] * sums[b];
  }
  return sums;
}

SolveReport PressureCorrection::solve(Foam::volScalarField& dp,
                                      Foam::surfaceScalarField& flux, double tolerance) {
  Foam::dictionary controls = mesh_.solverDict("p");
  controls.set("relTol", tolerance);
  Foam::fvScalarMatrix equation(Foam::fvm::laplacian(rate_, dp) == Foam::fvc::div(flux));
  if (dp.needReference()) {
    equation.setReference(this_rank() == 0 ? 0 : -1, 0.0);
  }
  active = this;
  equation.solve(controls);
  active = nullptr;
  flux -= equation.flux();
  const std::vector<Six> motions = motions_of(dp.primitiveField());
  for (const FaceTerm& term : faces_) {
    double& face = term.patch < 0 ? flux.primitiveFieldRef()[term.face]
                                  : flux.boundaryFieldRef()[term.patch][term.face];
    face += term.flux.dot(motions[at(term.body)]);
  }
  return {active_iterations, active_initial, active_final};
}

void PressureCorrection::correct(const Foam::volScalarField& dp,
                                 const Foam::volVectorField& gradient,
                                 Foam::volVectorField& velocity,
                                 std::vector<MomentumBody>& bodies) const {
  const std::vector<Six> motions = motions_of(dp.primitiveField());
  velocity -= rate_ * gradient;
  for (const ImmersedEntry& entry : entries_) {
    if (entry.solid && free_[at(entry.body)]) {
      velocity.primitiveFieldRef()[entry.cell] +=
          beta_[entry.cell] * foam(rigid_velocity(motions[at(entry.body)], entry.arm));
    }
  }
  velocity.correctBoundaryConditions();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].free) {
      bodies[b].motion += motions[b];
    }
  }
}

}  // namespace colloid
