// Motion of colloids in time under contact, surface and given hydrodynamic forces: the
// discrete elements of the transient tier.                                MODEL (T-D1)
//
// LIGGGHTS finds the neighbours and computes the contacts (Hertz, tangential history,
// friction, restitution) and keeps their history; all other forces, the integration,
// arrest and bonds are ours and act in every sub-step.  One instance on one rank; MPI is
// initialised if it is not yet.  Nothing is printed.
//
// What holds colloids: faces of kind wall (with friction), inlet and symmetry (without).
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/box.h"
#include "tiers/surface_model.h"

namespace colloid {

struct DemSurface {
  double young_modulus = 0.0;  ///< E [Pa]
  double poisson_ratio = 0.3;  ///< nu
};

struct DemOptions {
  explicit DemOptions(SurfaceModel model) : surfaces(std::move(model)) {}

  Box box;
  double radius = 0.0;         ///< a, of every colloid [m]
  double density = 0.0;        ///< of colloids [kg/m^3]
  double fluid_density = 0.0;  ///< rho [kg/m^3]
  double viscosity = 0.0;      ///< mu [Pa s]
  Vec3 gravity;                ///< [m/s^2]
  DemSurface colloid;
  DemSurface grain;          ///< also of walls
  double restitution = 0.9;  ///< of colloids with anything
  double friction = 0.15;    ///< the same, at grains, colloids and walls
  double step = 5e-8;        ///< longest sub-step [s]

  SurfaceModel surfaces;  ///< gaps of contact, forces, pull-offs, what attaches
  /// Surface forces act beyond the gap of contact (down to `least_surface_force`).
  bool long_range_forces = false;
  double least_surface_force = 1e-13;  ///< [N]
  bool permanent_bonds = true;         ///< else they break above the pull-off

  /// Lubrication, less what a flow on cells of the edge `lubrication_cell` [m] resists
  /// with by itself.
  bool lubrication = false;
  double lubrication_cell = 0.0;
  double upper_wall_speed = 0.0;  ///< along x, of the face z_plus, for lubrication [m/s]
};

struct DemState {
  int id = -1;  ///< >= 0, unique
  Vec3 position, velocity, spin;
  bool held = false;
};

/// Hydrodynamic force and torque on a colloid, linearised around the flow's answer:
/// force - drag (v - velocity), torque - torsion (w - spin).
struct DemLoad {
  int id = -1;
  Vec3 force, torque;    ///< [N], [N m]
  Vec3 velocity, spin;   ///< [m/s], [1/s]
  double drag = 0.0;     ///< [N s/m]
  double torsion = 0.0;  ///< [N m s]
};

/// Mean over the interval of everything but the DemLoad: weight less buoyancy, surface
/// forces, contacts, bonds, sub-grid lubrication.  m dv = (mean + mean load) dt exactly.
struct DemMean {
  int id = -1;
  Vec3 force, torque;
};

struct DemEvent {
  enum class Kind {
    touched_grain,     ///< arrested; other: index of the grain
    touched_wall,      ///< arrested; other: the Face
    touched_retained,  ///< bonded to the held colloid `other`, rolls on it
    touched_mobile,    ///< bonded rigidly to the mobile colloid `other`
    arrested_with,     ///< arrested: in one aggregate with `other`, which was arrested
    bond_broken        ///< with `other`, pulled by more than the pull-off
  };
  Kind kind = Kind::touched_grain;
  int colloid = -1;
  int other = -1;
  double time = 0.0;  ///< from the start of the interval [s]
};

struct DemStep {
  std::vector<DemMean> means;  ///< of those mobile at the start, ascending ids
  std::vector<DemEvent> events;
  long steps = 0;
};

struct DemBond {
  int first = -1;
  int second = -1;
  bool rigid = false;            ///< else rolls
  double tension = 0.0;          ///< [N], > 0: pulled
  double largest_tension = 0.0;  ///< so far [N]
};

/// What limits the sub-step.  MODEL (T-D8)
struct DemStepLimits {
  double rayleigh = 0.0;        ///< surface wave once around a colloid [s]
  double bonds = 0.0;           ///< stiffness of bonds [s]
  double surface_forces = 0.0;  ///< steepest surface force that acts [s]
  double largest() const;       ///< beyond: refused
  const char* what() const;     ///< which one
};
DemStepLimits step_limits(const DemOptions& options);

/// 5e-8 s, or less where that is more than 36 % of the limit.
double advised_step(const DemOptions& options);

class Dem {
 public:
  /// InputError: options that cannot be simulated, also a step beyond its limit.
  Dem(const DemOptions& options, const std::vector<Sphere>& grains);
  ~Dem();
  Dem(Dem&&) noexcept;
  Dem& operator=(Dem&&) noexcept;

  /// A mobile colloid (or a retained one: state.held).
  void add(const DemState& state);
  void remove(int id);
  /// Retained from now on.  Its aggregate is not: see `aggregate`.
  void hold(int id);

  /// Moves on by `duration`, in whole sub-steps no longer than the option.  Loads may
  /// come in any order; a mobile colloid without one feels no liquid.  An arrest does not
  /// stop the interval.  ConvergenceError: a colloid that is lost, not a number or moves
  /// by more than a twentieth of its radius in a sub-step; the object is then useless.
  DemStep advance(double duration, const std::vector<DemLoad>& loads);

  /// Ascending ids; positions inside the box along periodic axes.
  std::vector<DemState> states() const;
  std::vector<DemBond> bonds() const;
  /// The colloid and all to which rigid bonds join it, ascending.
  std::vector<int> aggregate(int id) const;
  long bonds_broken() const;
  /// What the options make doubtful, one sentence each.
  const std::vector<std::string>& warnings() const;

  /// All that the continuation depends on: a restored object goes on bit by bit as this
  /// one does.  For the same options and grains.
  std::string save();
  void restore(const std::string& saved);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace colloid
