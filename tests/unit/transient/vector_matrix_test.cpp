// The matrix for three components against OpenFOAM's own operators for one.
#include <random>

#include <gtest/gtest.h>

#include "lduPrimitiveMesh.H"
#include "tiers/transient/foam_vector_matrix.h"

namespace colloid {
namespace {

using Foam::label;
using Foam::scalarField;
using Foam::vectorField;

// An unsymmetric matrix over the faces between the cells of a box, dominated by its
// diagonal.
class VectorMatrixTest : public testing::Test {
 protected:
  static constexpr int kX = 7, kY = 5, kZ = 6;
  static constexpr int kCells = kX * kY * kZ;

  VectorMatrixTest()
      : mesh_(kCells, lower_, upper_, Foam::UPstream::worldComm, true), matrix_(mesh_) {
    matrix_.diag() = scalarField(kCells, 0.0);
    matrix_.upper() = scalarField(mesh_.upperAddr().size(), 0.0);
    matrix_.lower() = scalarField(mesh_.upperAddr().size(), 0.0);
    for (double& value : matrix_.diag()) {
      value = 7.0 + uniform_(random_);
    }
    forAll(matrix_.upper(), face) {
      matrix_.upper()[face] = -uniform_(random_);
      matrix_.lower()[face] = -uniform_(random_);
    }
    x_.resize(kCells);
    for (Foam::vector& value : x_) {
      value = Foam::vector(uniform_(random_), uniform_(random_), uniform_(random_));
    }
  }

  static Foam::labelList ends(bool upper) {
    Foam::labelList out;
    for (int cell = 0; cell < kCells; ++cell) {
      const bool more[] = {cell % kX + 1 < kX, cell / kX % kY + 1 < kY,
                           cell / (kX * kY) + 1 < kZ};
      const int step[] = {1, kX, kX * kY};
      for (int axis = 0; axis < 3; ++axis) {
        if (more[axis]) {
          out.append(upper ? cell + step[axis] : cell);
        }
      }
    }
    return out;
  }

  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{0.1, 1.0};
  Foam::labelList lower_ = ends(false);
  Foam::labelList upper_ = ends(true);
  Foam::lduPrimitiveMesh mesh_;
  Foam::lduMatrix matrix_;
  Foam::FieldField<Foam::Field, Foam::scalar> no_coefficients_{0};
  Foam::lduInterfaceFieldPtrsList no_interfaces_{0};
  vectorField x_;
};

TEST_F(VectorMatrixTest, MultipliesAsOpenFoamDoesToTheLastBit) {
  vectorField y(kCells);
  VectorMatrix(matrix_, no_coefficients_, no_interfaces_).multiply(x_, y);
  for (Foam::direction c = 0; c < 3; ++c) {
    scalarField expected(kCells);
    matrix_.Amul(expected, scalarField(x_.component(c)), no_coefficients_, no_interfaces_,
                 c);
    EXPECT_EQ(expected, scalarField(y.component(c)));
  }
}

TEST_F(VectorMatrixTest, PreconditionsAsOpenFoamDoesToTheLastBit) {
  Foam::dictionary controls;
  controls.add("solver", "PBiCGStab");
  controls.add("preconditioner", "DILU");
  const auto solver = Foam::lduMatrix::solver::New(
      "x", matrix_, no_coefficients_, no_coefficients_, no_interfaces_, controls);
  const auto theirs = Foam::lduMatrix::preconditioner::New(*solver, controls);
  vectorField z(kCells);
  VectorMatrix(matrix_, no_coefficients_, no_interfaces_).precondition(x_, z);
  for (Foam::direction c = 0; c < 3; ++c) {
    scalarField expected(kCells);
    theirs->precondition(expected, scalarField(x_.component(c)), c);
    EXPECT_EQ(expected, scalarField(z.component(c)));
  }
}

}  // namespace
}  // namespace colloid
