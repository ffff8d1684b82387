// Steady Stokes flow through a box of fixed spheres.                    MODEL section F
//
//     mu lap u - grad p + f = 0,   div u = 0,   u = 0 on spheres,
//
// from zero or from the last solution.  Everything outside is SI.
#pragma once

#include <memory>
#include <vector>

#include "flow/body_rows.h"
#include "flow/fgmres.h"
#include "flow/moving_bodies.h"
#include "flow/multigrid.h"
#include "flow/stokes_problem.h"

namespace colloid {

class StokesSolver {
 public:
  /// Refuses (InputError) a throat that is blocked while the drive holds a flux.
  StokesSolver(const StokesProblem& problem, const StokesOptions& options);

  /// Solves from the last solution; throws ConvergenceError where it fails.
  const StokesStatistics& solve();

  /// The deposit grew.  The next solve() starts from the flow before.
  void add_spheres(const std::vector<Sphere>& spheres);

  /// Bodies that move, in place of those of the last call.  The flow is carried along.
  void set_bodies(const std::vector<MovingBody>& bodies);
  /// Solves for the flow and the motion of the bodies together, from the last solution.
  const StokesStatistics& solve(const BodyBalance& balance);
  /// V of the bodies, SI.  To be set where a better start than the last V is known.
  const Eigen::VectorXd& body_motion() const { return body_motion_; }
  void set_body_motion(const Eigen::VectorXd& v) { body_motion_ = v; }
  /// H(V): what the fluid does to the bodies, SI.
  Eigen::VectorXd body_wrench() const;

  /// All that the next solve() depends on besides the spheres and the batches in which
  /// they were added.
  std::vector<double> state() const;
  /// Continues where a solver of the same problem and history was when it gave `state`;
  /// refuses (InputError) the state of another grid.
  void restore(const std::vector<double>& state);

  const StokesStatistics& statistics() const { return statistics_; }
  const StokesProblem& problem() const { return problem_; }

  int flow_axis() const { return colloid::flow_axis(problem_); }
  double largest_speed() const;       ///< at cell centres [m/s]
  double pressure_drop() const;       ///< along the flow axis, in flow direction [Pa]
  double flow_rate() const;           ///< through the box along the flow axis [m^3/s]
  Vec3 superficial_velocity() const;  ///< mean over the whole box, solid included [m/s]
  /// k = Q mu L/(A dP) [m^2]; not a number if nothing drives the flow along an axis.
  double permeability() const;
  Vec3 body_force() const;  ///< acting, given or found [N/m^3]

  // Level data for interpolation and forces; grid units (length, velocity and pressure
  // units below).
  const WallRows& rows() const { return *rows_; }
  const StokesVector<double>& fields() const { return flow_; }
  double length_unit() const { return length_; }                         ///< [m]
  double velocity_unit() const { return 1.0; }                           ///< [m/s]
  double pressure_unit() const { return problem_.viscosity / length_; }  ///< [Pa]
  const FlowFaces& flow_faces() const { return faces_; }
  Vec3 grid_body_force() const { return grid_force_; }
  const std::vector<Sphere>& grid_spheres() const { return grid_spheres_; }  ///< fixed
  /// The sphere of that number in the rows, fixed ones first.
  const Sphere& sphere_in_rows(int sphere) const;
  /// Velocity of its surface, or of its inside, at `from_centre` of it; zero if fixed.
  Vec3 surface_velocity(int sphere, const Vec3& from_centre) const;

 private:
  void build();
  void connect();
  void make_lift();
  void make_drive();
  void superpose_flow();
  double pressure_norm(StokesVector<double>& x) const;
  void solve_unit_force(int axis, double tolerance);
  void solve_mean_velocity();
  void solve_system(const StokesVector<double>& b, StokesVector<double>& x,
                    BorderedPart* part, double drive_norm, double tolerance);
  Eigen::VectorXd grid_motion(const Eigen::VectorXd& v) const;
  Eigen::VectorXd grid_wrench(const Eigen::VectorXd& wrench) const;
  Eigen::MatrixXd grid_resistance(const Eigen::MatrixXd& resistance) const;
  void start_statistics();
  Vec3 mean_velocity(const StokesVector<double>& x) const;
  double face_pressure(int face) const;
  double mean_pressure_near(int face, double margin) const;
  double open_fraction(int component, const std::array<int, 3>& at) const;

  StokesProblem problem_;
  StokesOptions options_;
  double length_ = 1.0;
  FlowFaces faces_;
  std::vector<Sphere> grid_spheres_;
  std::unique_ptr<WallRows> rows_;
  std::unique_ptr<Multigrid> multigrid_;
  std::unique_ptr<Fgmres> krylov_;
  bool blocked_ = false;  ///< no way from inlet to outlet, not even below the grid
  std::vector<bool> inlet_open_;  ///< per cell: fed by an inlet that reaches the outlet
  std::vector<Entry> given_;      ///< where boundary values are given
  std::vector<bool> near_given_;  ///< per plane: rows there see given values
  StokesVector<double> lift_;     ///< given boundary values, zero elsewhere
  StokesVector<double> drive_;    ///< right-hand side
  double drive_norm_ = 0.0;
  StokesVector<double> x_;     ///< unknowns
  StokesVector<double> flow_;  ///< x + lift
  std::array<StokesVector<double>, 3>
      unit_;  ///< responses to unit forces (mean_velocity)
  Vec3 grid_force_;
  std::vector<MovingBody> bodies_;
  struct MovingSphere {
    Sphere sphere;  ///< grid units
    Eigen::Index body = 0;
    Vec3 arm;  ///< from the body's centre
  };
  std::vector<MovingSphere> moving_spheres_;  ///< in the order of the rows
  std::unique_ptr<BodyRows> body_rows_;
  Eigen::VectorXd body_motion_;
  StokesStatistics statistics_;
};

}  // namespace colloid
