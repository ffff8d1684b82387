// One physical set-up, in SI units.  Defaults are those of the reference scene (a throat
// between four collectors, water at 298 K, polystyrene on glass); every key is declared
// once in fields.cpp, which reading, writing and `describe` share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/box.h"
#include "core/vec3.h"

namespace colloid {

/// A ready-made geometry; `none` is a box with spheres listed by the user.
enum class Preset { none, throat };

/// A rigid ball that is free (under the given force and torque) or moves at `velocity`.
struct Body {
  Sphere sphere;
  Vec3 force;                    ///< external [N]
  Vec3 torque;                   ///< external, about the centre [N m]
  std::optional<Vec3> velocity;  ///< prescribed [m/s]; absent: free
};

struct Geometry {
  Preset preset = Preset::none;
  double collector_diameter = 96.6e-6;  ///< d_c of the throat [m]
  std::optional<double> height;         ///< of the throat's box [m]; absent: 1.5 d_c
  /// The domain; filled from the preset if there is one.
  Box box{{},
          {FaceCondition::wall, FaceCondition::wall, FaceCondition::wall,
           FaceCondition::wall, FaceCondition::wall, FaceCondition::wall}};
  std::vector<Sphere> spheres;  ///< fixed grains: listed, then those of spheres_file
  std::string spheres_file;     ///< as given, relative to the scene; its content is above
  std::vector<Body> bodies;
};

struct Fluid {
  double viscosity = 1e-3;               ///< mu [Pa s]
  double density = 1000.0;               ///< rho [kg/m^3]
  double temperature = 298.0;            ///< T [K]
  double relative_permittivity = 78.55;  ///< [-]
};

/// What moves the fluid: at most one of these.
struct Drive {
  std::optional<double> inlet_velocity;  ///< uniform over the inlet, into the box [m/s]
  std::optional<double> pressure_drop;   ///< inlet minus outlet [Pa]
  std::optional<Vec3> body_force;        ///< per volume [N/m^3]
  std::optional<Vec3> mean_velocity;     ///< superficial velocity held [m/s]
  std::optional<double> shear_rate;  ///< wall z+ moves along x at rate times height [1/s]

  bool given() const {
    return inlet_velocity || pressure_drop || body_force || mean_velocity || shear_rate;
  }
};

/// The velocity at which a colloid enters: that of the fluid there, or the inlet's mean.
enum class ReleaseVelocity { local, inlet };
/// The order of injections in injected volume.
enum class InjectionOrder { poisson };

struct Injection {
  ReleaseVelocity release_velocity = ReleaseVelocity::local;
  InjectionOrder sequence = InjectionOrder::poisson;
};

struct Colloids {
  double diameter = 13.3e-6;       ///< d = 2 a [m]
  double density = 1050.0;         ///< rho_p [kg/m^3]
  double volume_fraction = 0.005;  ///< phi of the injected suspension [-]
  double young_modulus = 70e6;     ///< [Pa]
  double poisson_ratio = 0.3;      ///< [-]
  double restitution = 0.9;        ///< normal, dry [-]
  double friction = 0.15;          ///< Coulomb coefficient, all contacts [-]
  Injection injection;
};

/// Mechanics of the fixed grains and walls.
struct Grains {
  double young_modulus = 20e9;  ///< [Pa]
  double poisson_ratio = 0.3;   ///< [-]
};

enum class DoubleLayer { superposition, derjaguin };
enum class VanDerWaals { unretarded, retarded };

struct SurfaceChemistry {
  double ionic_strength = 300.0;           ///< of a 1:1 electrolyte [mol/m^3]
  double zeta_colloid = -27.9e-3;          ///< [V]
  double zeta_grain = -15.7e-3;            ///< [V]
  double zeta_wall = -15.7e-3;             ///< [V]
  double hamaker_colloid_grain = 1e-20;    ///< across the liquid [J]
  double hamaker_colloid_wall = 1e-20;     ///< [J]
  double hamaker_colloid_colloid = 1e-20;  ///< [J]
  double born_diameter = 0.5e-9;           ///< collision parameter sigma of Born [m]
  std::optional<double> primary_minimum;   ///< colloid-grain [J]; absent: computed
  std::optional<double> colloid_colloid_minimum;  ///< [J]; absent: computed
  DoubleLayer double_layer = DoubleLayer::superposition;
  VanDerWaals van_der_waals = VanDerWaals::unretarded;
};

/// Whether a colloid that touches a side wall stays there.
enum class Walls { inert, adhesive };
/// Whether a bond may break under a force above the pull-off force.
enum class Bonds { permanent, breakable };
enum class StopWhen { duration, clogged };

enum class TierChoice { automatic, one_way, quasi_steady, transient };
/// Which surfaces slow a mobile colloid down (tier one_way).
enum class Hindrance { none, wall, wall_and_pair };
/// Whether gaps below the grid's resolution get a lubrication correction.
enum class Lubrication { resolved_only, full };
enum class Coupling { implicit, explicit_step };

/// How accurately, and by which tier, the scene is computed.
struct Fidelity {
  TierChoice tier = TierChoice::automatic;
  double cells_per_colloid = 5.5;  ///< grid cells per colloid diameter [-]
  Hindrance hindrance = Hindrance::wall_and_pair;
  std::optional<double> capture_gap;  ///< [m]; absent: computed from DLVO and drag
  double tolerance = 1e-6;            ///< relative residual of the flow [-]
  Lubrication lubrication = Lubrication::full;
  double courant = 0.3;  ///< largest Courant number (tier transient) [-]
  Coupling coupling = Coupling::implicit;
  int refinement = 1;       ///< halvings of the cell at colloids (tier transient)
  int subiterations = 1;    ///< passes of momentum and pressure a step (tier transient)
  int wall_refinement = 0;  ///< the same at the surfaces of grains (tier transient)
  double dem_step = 50e-9;  ///< of the colloids' motion and contacts (tier transient) [s]
};

struct Scene {
  std::string description;
  Geometry geometry;
  Fluid fluid;
  Drive drive;
  std::optional<Colloids> colloids;  ///< absent: only flow can be measured
  Grains grains;
  SurfaceChemistry surface;
  Vec3 gravity{0.0, 0.0, -9.81};  ///< [m/s^2]
  Walls walls = Walls::inert;
  Bonds bonds = Bonds::permanent;
  bool aggregates = true;  ///< mobile colloids that touch bond and move as one
  double duration = 5.0;   ///< [s]
  StopWhen stop_when = StopWhen::duration;
  Fidelity fidelity;
};

}  // namespace colloid
