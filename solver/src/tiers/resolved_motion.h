// Motion of colloids from a flow in which each of them is resolved.        MODEL section
// Q
//
// Where the flow is solved, every d cells of travel, the wrenches of the liquid on the
// bodies are known; what they differ from those of the one_way model by is carried along
// with the bodies, extrapolated from the last two solves:
//
//     R V = D + E + constraints,    E = H + load + R V - D  where the flow is solved (Q3)
//
// R and D are the model's, at the present place: lubrication and the ambient flow change
// over a gap or a grain, E over what the model leaves out: the shape of the flow around
// several bodies and curved walls.
#pragma once

#include <map>
#include <memory>

#include "flow/stokes_solver.h"
#include "particles/one_way_motion.h"
#include "scene/scene.h"

namespace colloid {

struct ResolvedOptions {
  double radius = 0.0;       ///< a of every colloid [m]
  double most_travel = 0.0;  ///< between two solves [m]
  double cell = 0.0;         ///< width, for lubrication in narrow gaps [m]; 0: none
  double tolerance = 1e-4;   ///< of each solve
  int threads = 1;
};

class ResolvedMotion : public MotionModel {
 public:
  /// Keeps a reference to `model`.
  ResolvedMotion(const ResolvedOptions& options, const StokesProblem& problem,
                 const OneWayMotion& model);

  Motion motion(const std::vector<RigidBody>& bodies,
                const std::vector<Contact>& contacts,
                const std::vector<BodyWrench>& extra) const override;
  std::vector<BodyWrench> thermal_wrenches(const std::vector<RigidBody>& bodies,
                                           const std::vector<Vector6>& normals,
                                           double temperature,
                                           double step) const override;
  std::vector<BodyWrench> held_wrenches(
      const std::vector<RigidBody>& bodies) const override;

  bool begin_step(const std::vector<RigidBody>& bodies,
                  const std::vector<Contact>& contacts, const Motion& motion) override;
  double longest_step(const std::vector<RigidBody>& bodies) const override;
  void deposit_grew(const std::vector<Sphere>& deposit) override;
  std::vector<double> state() const override;
  void restore(const std::vector<double>& state) override;
  void record(NamedValues& counts, NamedValues& seconds) const override;

 private:
  /// What was found for a colloid: its share of its body's, about its own centre.
  struct Found {
    Vec3 position;          ///< when the flow was solved [m]
    std::size_t mates = 0;  ///< colloids in its body then
    bool bonded = false;
    BodyWrench error;   ///< E
    BodyWrench change;  ///< of E since the solve before; none if its body is another
  };
  /// The colloid that went farthest between the last two solves: how far it has gone
  /// since, over that, is the time by which E is extrapolated.
  struct Clock {
    int colloid = -1;
    Vec3 position;      ///< at the last solve [m]
    double span = 0.0;  ///< travel between the last two [m]
  };

  bool due(const std::vector<RigidBody>& bodies) const;
  void solve(const std::vector<RigidBody>& bodies, const std::vector<Contact>& contacts,
             const Motion& motion);
  std::vector<BodyWrench> errors(const std::vector<RigidBody>& bodies) const;
  void place(const std::vector<MovingBody>& bodies);
  double elapsed(const std::vector<RigidBody>& bodies) const;
  void keep(const std::vector<RigidBody>& bodies, const Eigen::VectorXd& error);

  ResolvedOptions options_;
  const OneWayMotion& model_;
  StokesSolver solver_;
  std::vector<MovingBody> placed_;  ///< bodies in the solver
  std::map<int, Found> found_;      ///< by colloid
  Clock clock_;
  long solves_ = 0;
  long iterations_ = 0;
  double work_units_ = 0.0;
  double seconds_ = 0.0;
};

}  // namespace colloid
