// The pressure correction with free bodies in it.                        MODEL section T
#pragma once

#include <vector>

#include "tiers/transient/foam.h"
#include "tiers/transient/foam_momentum.h"
#include "tiers/transient/rigid.h"

namespace colloid {

/// How a correction dp of the (kinematic) pressure moves cells and free bodies:
///
///   (T6)  du = rate (-grad dp) + beta V(dq),  rate = 1/(1/dt + lambda), beta = lambda
///   rate,
///         lambda taken inside bodies alone;   B dq = g^T dp
///
/// where g is the divergence of the bodies' rigid motions in every cell.
class PressureCorrection {
 public:
  PressureCorrection(const Foam::fvMesh& mesh, const Box& box,
                     const std::vector<Sphere>& spheres,
                     const std::vector<ImmersedEntry>& entries,
                     const std::vector<MomentumBody>& bodies, double dt);

  /// dt/(1 + lambda dt) of every cell [s].
  const Foam::volScalarField& rate() const { return rate_; }

  /// Makes `flux` free of divergence: solves for dp (from what it holds, until the
  /// residual is `tolerance` times that of zero), corrects the flux.
  SolveReport solve(Foam::volScalarField& dp, Foam::surfaceScalarField& flux,
                    double tolerance);

  /// Corrects velocity and motions by dp and its gradient.
  void correct(const Foam::volScalarField& dp, const Foam::volVectorField& gradient,
               Foam::volVectorField& velocity, std::vector<MomentumBody>& bodies) const;

  /// y -= sum of g B^-1 g^T x: what free bodies add to the Laplacian.
  void add_bodies(const Foam::scalarField& x, Foam::scalarField& y) const;

 private:
  struct CellTerm {
    int cell = 0;
    int body = 0;
    Six divergence = Six::Zero();
  };
  struct FaceTerm {
    int face = 0;    // of the patch
    int patch = -1;  // -1: internal faces
    int body = 0;
    Six flux = Six::Zero();
  };

  void find_terms();
  // `inside`: by cell, the entry of the free body that it is inside of.
  void find_internal_terms(const std::vector<const ImmersedEntry*>& inside);
  void find_coupled_terms(const std::vector<const ImmersedEntry*>& inside);
  void add_term(const FaceTerm& face, double share, const Vec3& arm,
                const Foam::vector& area, int from, int to);
  std::vector<Six> motions_of(const Foam::scalarField& dp) const;

  const Foam::fvMesh& mesh_;
  const Box& box_;
  const std::vector<Sphere>& spheres_;
  const std::vector<ImmersedEntry>& entries_;
  std::vector<bool> free_;
  Foam::volScalarField rate_;
  Foam::volScalarField beta_;      // zero but inside free bodies
  Foam::volScalarField body_of_;   // number of the free body whose inside it is; -1
  std::vector<SixBySix> inverse_;  // B^-1
  std::vector<CellTerm> cells_;
  std::vector<FaceTerm> faces_;
};

}  // namespace colloid
