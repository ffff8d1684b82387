// What acts on colloids in every sub-step besides LIGGGHTS' contacts, and how they move.
//
//     half_kick, move | (LIGGGHTS: contacts) | act, half_kick        MODEL (T-D2), (T-D3)
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tiers/transient/dem.h"
#include "tiers/transient/dem_atoms.h"
#include "tiers/transient/dem_bonds.h"
#include "tiers/transient/dem_lubrication.h"
#include "tiers/transient/dem_surface_force.h"

namespace colloid {

class DemForces {
 public:
  DemForces(const DemOptions& options, const std::vector<Sphere>& grains);

  /// LIGGGHTS' number of an atom.
  int tag_of(int id) const { return grains() + 1 + id; }
  int id_of(int tag) const { return tag - grains() - 1; }
  /// How far neighbours must be known, from surface to surface [m].
  double reach() const { return reach_; }

  void begin(double step, const std::vector<DemLoad>& loads);
  /// Ends the interval: impulses over `duration`.
  DemStep finish(double duration, const std::vector<int>& ids);

  /// Whenever LIGGGHTS may have renumbered its atoms.
  void locate(const DemAtoms& atoms);
  /// All forces at the present positions are added to LIGGGHTS'; touching colloids are
  /// arrested and bonded.  `first`: of the interval, before its first sub-step.
  void act(const DemAtoms& atoms, const std::vector<DemPair>& pairs, bool first);
  void half_kick(const DemAtoms& atoms);
  void move(const DemAtoms& atoms);

  void forget(int id);
  std::vector<DemBond> bonds() const;
  std::vector<int> aggregate(int id) const;
  long bonds_broken() const { return broken_; }
  void set_frozen_bit(int bit) { frozen_bit_ = bit; }

  std::string save() const;
  /// Takes what `save` wrote off the front of `text`.
  void restore(std::string& text);

 private:
  /// One colloid during an interval.
  struct Slot {
    DemLoad load;
    Vec3 impulse, turning;         ///< of all that is in DemMean [N s], [N m s]
    Vec3 push;                     ///< weight, bonds, the liquid's force at rest [N]
    double drag_inertia = 0.0;     ///< D of (T-D3) [N s/m]
    double torsion_inertia = 0.0;  ///< [N m s]
    int local = -1;                ///< its atom at present
  };

  int grains() const { return static_cast<int>(grain_radii_.size()); }
  Slot& slot(int id);
  void add_body_forces(const DemAtoms& atoms);
  void add_bond_forces(const DemAtoms& atoms, bool first);
  void add_pair(const DemAtoms& atoms, const DemPair& pair);
  void add_grain(const DemAtoms& atoms, int colloid, int grain, const Vec3& offset);
  void add_colloids(const DemAtoms& atoms, int one, int other, const Vec3& offset);
  void add_walls(const DemAtoms& atoms, int i);
  /// Lubrication of colloid `i` beside a surface.
  void lubricate(int i, const NearSurface& surface);
  void add_lubrication(const DemAtoms& atoms);
  void attach(const DemAtoms& atoms, int i, DemEvent::Kind kind, int other,
              double repulsion, bool attaches, const Vec3& normal);
  void arrest(const DemAtoms& atoms, int i, DemEvent::Kind kind, int other);
  void freeze(const DemAtoms& atoms, int i);
  bool bonded(int a, int b) const { return joined_.count(key(a, b)) > 0; }
  static std::pair<int, int> key(int a, int b) {
    return a < b ? std::make_pair(a, b) : std::make_pair(b, a);
  }
  void drop_broken();

  DemOptions options_;
  std::vector<double> grain_radii_;              ///< [m]
  std::optional<GapResistance> gap_resistance_;  ///< with lubrication
  double mass_ = 0.0;
  double inertia_ = 0.0;  ///< 2/5 m a^2
  Vec3 weight_;           ///< less buoyancy [N]
  DemSurfaceForce grain_force_, wall_force_, colloid_force_;
  BondStiffness stiffness_;
  double reach_ = 0.0;
  int frozen_bit_ = 0;

  // What continues from interval to interval.
  std::vector<Bond> bonds_;
  std::set<std::pair<int, int>> joined_;  ///< by bonds_
  std::set<std::pair<int, int>> parted_;  ///< broken bonds still within touch
  long broken_ = 0;

  // Of one interval.
  double step_ = 0.0;
  long steps_ = 0;
  std::vector<Slot> slots_;  ///< by id
  std::vector<DemEvent> events_;
  std::vector<NarrowGap> gaps_;
  std::vector<Vector6> compliance_;  ///< by atom, for the gaps: of (v, a w) [m/(N s)]
  std::vector<Vector6> motion_;
};

}  // namespace colloid
