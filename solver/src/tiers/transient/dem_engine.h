// One instance of LIGGGHTS: set up, given atoms, run, saved.  No type of LIGGGHTS here.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "tiers/transient/dem.h"
#include "tiers/transient/dem_forces.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace colloid {

/// What LIGGGHTS complains of.
class EngineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes the linker take the definitions that throw.
bool error_hook_is_linked();

class DemEngine {
 public:
  /// `forces` must stay where it is.
  DemEngine(const DemOptions& options, const std::vector<Sphere>& grains,
            DemForces& forces);
  /// As `saved` left it.
  DemEngine(const DemOptions& options, const std::vector<Sphere>& grains,
            DemForces& forces, const std::string& saved);
  ~DemEngine();
  DemEngine(const DemEngine&) = delete;
  DemEngine& operator=(const DemEngine&) = delete;

  void add(const DemState& state);
  void remove(int id);
  void hold(int id);
  void run(long steps, double step);
  std::vector<DemState> states() const;  ///< in LIGGGHTS' order
  std::string save();

 private:
  void describe_extent(const std::vector<Sphere>& grains);
  void open();
  void begin_commands();
  void describe_box();
  void describe_matter();
  void add_sphere(int tag, int type, const Vec3& x, double radius);
  void finish_set_up();
  void command(const std::string& text);
  int group_bit(const char* name) const;
  int atom_of(int id) const;

  const DemOptions& options_;
  DemForces& forces_;
  Vec3 lowest_, highest_;  ///< corners of LIGGGHTS' box [m]
  LAMMPS_NS::LAMMPS* engine_ = nullptr;
};

}  // namespace colloid
