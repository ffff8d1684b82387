// Momentum of liquid and bodies together: see README.md beside this file.
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "flow_scenes.h"

namespace colloid {
namespace {

constexpr double kRadius = 6.65e-6;
constexpr double kPressureDrop = 0.3;  // [Pa]: about the reference Reynolds number
constexpr double kDensity = 1050.0;
// What drives the free colloid besides the flow [N].
const Vec3 kPush{2e-11, -1e-11, -3e-11};

// The throat under a pressure drop, so that what the drive puts in is known beforehand;
// one colloid held beside a grain, one free.
class Throat {
 public:
  explicit Throat(int passes) : scene_(throat_scene(0.0)) {
    scene_.drive = {};
    scene_.drive.pressure_drop = kPressureDrop;
    TransientFlowOptions options = base_cells(14, 14, 21, 1);
    options.outer_iterations = passes;
    options.momentum_tolerance = 1e-9;
    flow_ = std::make_unique<TransientFlow>(scene_, options);
    bodies_ = {free_sphere({60e-6, 52e-6, 95e-6}, kRadius, kDensity, kPush),
               free_sphere({41e-6, 40e-6, 60e-6}, kRadius, kDensity)};
    bodies_[1].free = false;
  }

  void step(double dt) {
    const Vec3 before = bodies_[0].velocity;
    responses_ = flow_->step(dt, bodies_);
    bodies_[0].velocity = responses_[0].velocity;
    bodies_[0].spin = responses_[0].spin;
    acceleration_ = (bodies_[0].velocity - before) * (1.0 / dt);
  }

  /// What the faces and the push give, less what grains and the held colloid take and
  /// what makes liquid and free colloid faster [N].
  Vec3 missing() const {
    // The liquid in the place of the free colloid has its share of the colloid's mass.
    const double displaced =
        4.0 / 3.0 * kPi * kRadius * kRadius * kRadius * scene_.fluid.density;
    Vec3 out = kPush - flow_->grain_force() - responses_[1].force -
               flow_->liquid_inertia() - (bodies_[0].mass - displaced) * acceleration_;
    for (int face = 0; face < kFaces; ++face) {
      out += flow_->face_force(face);
    }
    return out;
  }
  Vec3 drive() const { return flow_->face_force(z_minus) + flow_->face_force(z_plus); }
  Vec3 walls() const {
    Vec3 out;
    for (int face = x_minus; face <= y_plus; ++face) {
      out -= flow_->face_force(face);
    }
    return out;
  }
  const FlowResponse& response(std::size_t n) const { return responses_[n]; }
  Vec3 acceleration() const { return acceleration_; }
  double mass() const { return bodies_[0].mass; }
  TransientFlow& flow() { return *flow_; }
  const std::vector<FlowBody>& bodies() const { return bodies_; }
  double section() const {
    return scene_.geometry.box.size.x * scene_.geometry.box.size.y;
  }

 private:
  Scene scene_;
  std::unique_ptr<TransientFlow> flow_;
  std::vector<FlowBody> bodies_;
  std::vector<FlowResponse> responses_;
  Vec3 acceleration_;
};

// From rest: at first the whole drive makes the liquid faster, then grains and walls take
// it.  In every step nothing is lost but the residual of the momentum equation: 1e-9 of
// the norm over cells, whose sum over 1e4 cells is at most 1e-7 of it.
TEST(TransientMomentum, OfLiquidAndBodiesIsBalancedInEveryStep) {
  for (const int passes : {1, 2}) {
    Throat throat(passes);
    const double scale = kPressureDrop * throat.section();
    for (const double dt : {1e-6, 1e-5, 1e-4, 1e-3, 1e-3}) {
      throat.step(dt);
      EXPECT_LT(norm(throat.missing()), 1e-6 * scale) << passes << " passes, " << dt;
      // The flow's force on the free colloid is what it does not owe to the push.
      const Vec3 owed = throat.mass() * throat.acceleration() - kPush;
      EXPECT_LT(norm(throat.response(0).force - owed), 1e-9 * scale) << dt;
    }
  }
}

// At rest in time the pressure drop times the section is what grains, the held colloid
// and the walls take, less the push; what flows out carries 1e-3 of it, as it came in.
TEST(TransientMomentum, OfTheDriveIsTakenByBodiesAndWalls) {
  Throat throat(1);
  for (int n = 0; n < 40; ++n) {
    throat.step(2e-4);
  }
  const double scale = kPressureDrop * throat.section();
  EXPECT_NEAR(throat.drive().z / -scale, 1.0, 2e-3);
  EXPECT_LT(norm(throat.flow().liquid_inertia()), 1e-3 * scale);
  const Vec3 taken = throat.flow().grain_force() + throat.response(1).force +
                     throat.response(0).force + throat.walls();
  EXPECT_NEAR(taken.z / -scale, 1.0, 3e-3);
  // The free colloid is carried at a steady speed: the flow's force is minus the push.
  EXPECT_LT(norm(throat.response(0).force + kPush), 1e-2 * norm(kPush));
}

}  // namespace
}  // namespace colloid
