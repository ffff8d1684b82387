#include "tiers/transient/foam_vector_matrix.h"

#include "DILUPreconditioner.H"

namespace colloid {

using Foam::label;
using Foam::scalarField;
using Foam::vectorField;

VectorMatrix::VectorMatrix(const Foam::lduMatrix& matrix,
                           const Foam::FieldField<Foam::Field, Foam::scalar>& boundary,
                           const Foam::lduInterfaceFieldPtrsList& interfaces)
    : matrix_(matrix),
      boundary_(boundary),
      interfaces_(interfaces),
      reciprocal_(matrix.diag()) {
  forAll(interfaces, i) {
    coupled_ = coupled_ || interfaces.set(i);
  }
  Foam::DILUPreconditioner::calcReciprocalD(reciprocal_, matrix);
  const Foam::labelUList& upper = matrix.lduAddr().upperAddr();
  const Foam::labelUList& lower = matrix.lduAddr().lowerAddr();
  forward_.reserve(static_cast<std::size_t>(upper.size()));
  backward_.reserve(static_cast<std::size_t>(upper.size()));
  for (const label face : matrix.lduAddr().losortAddr()) {
    forward_.push_back(
        {reciprocal_[upper[face]] * matrix.lower()[face], lower[face], upper[face]});
  }
  for (label face = upper.size() - 1; face >= 0; --face) {
    backward_.push_back(
        {reciprocal_[lower[face]] * matrix.upper()[face], upper[face], lower[face]});
  }
}

void VectorMatrix::multiply(const vectorField& x, vectorField& y) const {
  const scalarField& diagonal = matrix_.diag();
  forAll(y, cell) {
    y[cell] = diagonal[cell] * x[cell];
  }
  const Foam::labelUList& upper_cell = matrix_.lduAddr().upperAddr();
  const Foam::labelUList& lower_cell = matrix_.lduAddr().lowerAddr();
  const double* const upper = matrix_.upper().begin();
  const double* const lower = matrix_.lower().begin();
  forAll(upper_cell, face) {
    const label u = upper_cell[face];
    const label l = lower_cell[face];
    y[u] += lower[face] * x[l];
    y[l] += upper[face] * x[u];
  }
  if (coupled_) {
    add_interfaces(x, y);
  }
}

void VectorMatrix::precondition(const vectorField& r, vectorField& z) const {
  forAll(z, cell) {
    z[cell] = reciprocal_[cell] * r[cell];
  }
  for (const std::vector<Link>* const sweep : {&forward_, &backward_}) {
    for (const Link& link : *sweep) {
      z[link.to] -= link.weight * z[link.from];
    }
  }
}

// OpenFOAM's interfaces know scalars alone.
void VectorMatrix::add_interfaces(const vectorField& x, vectorField& y) const {
  for (Foam::direction c = 0; c < 3; ++c) {
    const scalarField from(x.component(c));
    scalarField to(y.component(c));
    matrix_.initMatrixInterfaces(true, boundary_, interfaces_, from, to, c);
    matrix_.updateMatrixInterfaces(true, boundary_, interfaces_, from, to, c);
    y.replace(c, to);
  }
}

}  // namespace colloid
