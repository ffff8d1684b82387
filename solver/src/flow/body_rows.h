// How moving bodies enter the rows of the flow, and the flow the balances of the bodies.
//
// With the spheres of the bodies among the walls, M acts on the velocity relative to a
// wall.  What the rigid motions V (U and length unit times w, per body) add is linear:
//
//     M x - G V = f,        H = D x + R V + w                                  MODEL
//     (F18)
//
// x is zero on closed faces; there the velocity is that of the body.  H are the wrenches
// by the control volumes of (F16).  Grid units: velocities, forces over viscosity times
// length, torques over viscosity times length squared.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "flow/level.h"
#include "flow/wall_rows.h"

namespace colloid {

using RigidMotion = Eigen::Matrix<double, 6, 1>;

class BodyRows {
 public:
  struct Body {
    Vec3 centre;
    std::vector<Sphere> spheres;  ///< in the order in which they are in the rows
  };

  BodyRows(const WallRows& rows, const std::vector<Body>& bodies);

  std::size_t size() const { return 6 * bodies_; }  ///< of V

  /// w += G V on the plane k.
  template <class Real>
  void add_columns(const Eigen::VectorXd& v, StokesVector<Real>& w, int k) const;
  /// D x; halos of x are filled.
  template <class Real>
  Eigen::VectorXd apply_rows(const StokesVector<Real>& x) const;
  const Eigen::MatrixXd& self() const { return self_; }  ///< R
  /// w: of a force per volume, and of given velocities and pressures.
  Eigen::VectorXd constant(const Vec3& force, const StokesVector<double>& lift) const;
  /// Sets the closed faces of the bodies to their velocities.
  void fill_bodies(const Eigen::VectorXd& v, StokesVector<double>& x) const;
  /// Zero on what is closed in `rows`, of all that the last two set.
  void clear(const WallRows& rows, StokesVector<double>& x) const;
  /// Sets closed cells in bodies to the mean pressure of their open neighbours, inwards.
  void fill_pressure(StokesVector<double>& x) const;

 private:
  struct Term {
    std::size_t component;
    std::size_t at;
    std::size_t body;
    RigidMotion coefficient;
  };
  struct Forms;
  void make_columns(const WallRows& rows);
  void add_open_row(int component, std::size_t q,
                    const std::vector<WallRows::SurfaceTerm>& terms);
  void add_closed_face(const WallRows& rows, int component, const std::array<int, 3>& at);
  void sort_columns(const Grid& grid);
  void make_rows(const WallRows& rows);
  void sort_out(const WallRows& rows, const Term& term);
  std::size_t body_of(int sphere) const {
    return body_of_sphere_[static_cast<std::size_t>(sphere - first_sphere_)];
  }
  RigidMotion velocity_of(int component, int sphere, const Vec3& from_center) const;

  std::size_t bodies_ = 0;
  int first_sphere_ = 0;
  std::vector<std::size_t> body_of_sphere_;
  std::vector<Vec3> arm_of_sphere_;
  std::vector<Term> columns_;        ///< by plane
  std::vector<std::size_t> planes_;  ///< where each plane begins in columns_
  std::vector<Term> rows_;           ///< D
  std::vector<Term> given_;          ///< as D, for halos and given faces
  std::vector<Term> closed_;         ///< velocity of closed faces
  std::vector<std::size_t> closed_cells_;
  std::vector<std::vector<std::size_t>> cell_neighbours_;
  Eigen::MatrixXd self_;
  Eigen::MatrixXd volumes_;  ///< 6 n x 3: wrench of a unit force per volume
};

}  // namespace colloid
