// Motion of colloids that the flow carries but that do not act on it.       MODEL
// (P1)-(P7)
#pragma once

#include <memory>

#include "particles/ambient_flow.h"
#include "particles/body_motion.h"
#include "particles/contact_rules.h"
#include "particles/hindrance.h"
#include "particles/motion.h"
#include "physics/surface_pair.h"

namespace colloid {

struct OneWayOptions {
  double radius = 0.0;            ///< a of every colloid [m]
  double viscosity = 0.0;         ///< mu [Pa s]
  Vec3 weight;                    ///< gravity less buoyancy on one colloid [N]
  std::vector<BodyWrench> given;  ///< on the colloids with the first ids, besides
  bool wall_hindrance = true;     ///< by grains, retained colloids and walls
  bool pair_hindrance = true;     ///< between mobile colloids
  ContactRules rules;
  // Surface forces beyond the gap of contact; null: too short in range to matter.
  std::shared_ptr<const SurfaceForces> grain_forces;
  std::shared_ptr<const SurfaceForces> wall_forces;
  std::shared_ptr<const SurfaceForces> colloid_forces;
};

/// The model at one state, V of 6 n: per body (U [m/s], w [rad/s]); wrenches in N, N m:
///
///     wrench of liquid and surfaces = drive - resistance V,  load the surfaces' part.
struct LinearMotion {
  Eigen::MatrixXd resistance;
  Eigen::VectorXd drive;
  Eigen::VectorXd load;  ///< weight and surface forces, part of `drive`
  Eigen::MatrixXd
      motions;  ///< columns: the motions that bonds and pressed contacts leave
};

class OneWayMotion : public MotionModel {
 public:
  /// Keeps references to `flow` and `surfaces`, which may grow.  `grain_radii` [m].
  OneWayMotion(const OneWayOptions& options, const AmbientFlow& flow,
               const FixedSurfaces& surfaces, const std::vector<double>& grain_radii);

  Motion motion(const std::vector<RigidBody>& bodies,
                const std::vector<Contact>& contacts,
                const std::vector<BodyWrench>& extra) const override;
  std::vector<BodyWrench> thermal_wrenches(const std::vector<RigidBody>& bodies,
                                           const std::vector<Vector6>& normals,
                                           double temperature,
                                           double step) const override;
  std::vector<BodyWrench> held_wrenches(
      const std::vector<RigidBody>& bodies) const override;

  /// `pressed`: contacts that keep their distance.
  LinearMotion linear(const std::vector<RigidBody>& bodies,
                      const std::vector<Contact>& pressed) const;
  /// What a flow solved on a grid of this cell width [m] leaves out of the resistance in
  /// narrow gaps, MODEL (Q2).  Units as in LinearMotion.
  Eigen::MatrixXd lubrication(const std::vector<RigidBody>& bodies, double cell) const;

 private:
  struct Assembly;
  Assembly assemble(const std::vector<RigidBody>& bodies) const;
  void add_pairs(const std::vector<RigidBody>& bodies, Assembly& out) const;
  void add_surfaces(const std::vector<RigidBody>& bodies, Assembly& out) const;
  ContactRow contact_row(const std::vector<RigidBody>& bodies,
                         const Contact& contact) const;
  double surface_force(const NearSurface& surface) const;
  Matrix6 narrow_gaps(const Vec3& position, double cell) const;
  Eigen::VectorXd arms(Eigen::Index size) const;
  Eigen::MatrixXd in_si(const Eigen::MatrixXd& resistance) const;

  OneWayOptions options_;
  double drag_;  ///< 6 pi mu a [N s/m]
  const AmbientFlow& flow_;
  const FixedSurfaces& surfaces_;
  std::unique_ptr<SurfaceHindrance> wall_hindrance_;
  std::unique_ptr<EqualPairHindrance> pair_hindrance_;
};

}  // namespace colloid
