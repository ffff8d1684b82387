// Second differences along one axis, faces of the box included.
//
// With a neighbour at distance D- below and D+ above (Shortley & Weller 1938),
//
//     u'' = p [ (u+ - u)/D+ - (u - u-)/D- ],      p = 2/(D- + D+).                MODEL
//     (F5)
//
// A face of the box with a given velocity is a neighbour whose value is known; a face
// without shear drops its term, and p is then one over the cell width.
#pragma once

#include <vector>

#include "flow/boundary.h"
#include "flow/grid.h"

namespace colloid {

/// What lies on one side of an unknown, along one axis.
enum class Side { neighbour, given_velocity, no_shear };

/// One unknown's second difference; grid units.
struct SecondDifference {
  double prefactor = 0.0;  ///< p
  double below = 1.0;      ///< D-
  double above = 1.0;      ///< D+
  Side side_below = Side::neighbour;
  Side side_above = Side::neighbour;

  /// Weight of the unknown itself, sign reversed.
  double diagonal() const {
    return prefactor * ((side_below == Side::no_shear ? 0.0 : 1.0 / below) +
                        (side_above == Side::no_shear ? 0.0 : 1.0 / above));
  }
};

/// Weights along one axis, ready for the kernels.  Arrays start at index -1 and are
/// zero beyond the box.
struct AxisStencil {
  std::vector<SecondDifference> at_face;    ///< component along the axis, faces 0 .. n
  std::vector<SecondDifference> at_centre;  ///< other components, cells 0 .. n - 1

  std::vector<float> face_below, face_above;      ///< weights of the face neighbours
  std::vector<float> centre_below, centre_above;  ///< weights of the centre neighbours
  std::vector<float> gradient;    ///< one over the distance of the pressures at a face
  std::vector<float> divergence;  ///< one over the cell width
};

/// `lower` and `upper` are the kinds of the two faces of the box on this axis.
AxisStencil make_axis_stencil(const Grid& grid, int axis, FlowFace::Kind lower,
                              FlowFace::Kind upper);

}  // namespace colloid
