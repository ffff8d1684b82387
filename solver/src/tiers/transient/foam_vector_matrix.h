// A scalar matrix of OpenFOAM that acts on the three components of a vector at once.
//
// Most of the time of a product goes into reading coefficients and addresses, and
// OpenFOAM reads them once for each component.  The results are the same to the last bit.
#pragma once

#include <vector>

#include "tiers/transient/foam.h"

namespace colloid {

/// Keeps references to what it is made from; the matrix must not change meanwhile.
class VectorMatrix {
 public:
  /// `boundary`: coefficients of coupled patches (cyclic ones and those between ranks).
  VectorMatrix(const Foam::lduMatrix& matrix,
               const Foam::FieldField<Foam::Field, Foam::scalar>& boundary,
               const Foam::lduInterfaceFieldPtrsList& interfaces);

  /// y = A x, as Foam::lduMatrix::Amul.
  void multiply(const Foam::vectorField& x, Foam::vectorField& y) const;
  /// Solves M z = r, M the incomplete LU factors of A with its own links, as
  /// Foam::DILUPreconditioner.  Links of coupled patches are left out.
  void precondition(const Foam::vectorField& r, Foam::vectorField& z) const;

 private:
  struct Link {
    double weight;
    Foam::label from, to;
  };

  void add_interfaces(const Foam::vectorField& x, Foam::vectorField& y) const;

  const Foam::lduMatrix& matrix_;
  const Foam::FieldField<Foam::Field, Foam::scalar>& boundary_;
  const Foam::lduInterfaceFieldPtrsList& interfaces_;
  Foam::scalarField reciprocal_;          // of the factors' diagonal
  std::vector<Link> forward_, backward_;  // in the order of the two sweeps
  bool coupled_ = false;
};

}  // namespace colloid
