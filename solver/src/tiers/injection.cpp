#include "tiers/injection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "scene/names.h"
#include "tiers/measurement.h"
#include "tiers/regime.h"

namespace colloid {

namespace {

constexpr double kMostCells = 5e5;  // of the clean flow: a second, not minutes

const Colloids& colloids_of(const Scene& scene) {
  require(scene.colloids.has_value(), "/colloids",
          "is missing: without colloids nothing is injected");
  return *scene.colloids;
}

int inlet_of(const Box& box) {
  std::optional<int> inlet;
  for (int face = 0; face < kFaces; ++face) {
    if (box.face(face) == FaceCondition::inlet) {
      require(!inlet, fmt::format("/geometry/faces/{}", face_name(face)),
              fmt::format("is a second inlet, {} is one already; colloids are injected "
                          "through one face",
                          inlet ? face_name(*inlet) : ""));
      inlet = face;
    }
  }
  require(inlet.has_value(), "/geometry/faces",
          "has no inlet: colloids are injected through an inlet face");
  return *inlet;
}

double face_area(const Box& box, int face) {
  return box.size[(axis_of(face) + 1) % 3] * box.size[(axis_of(face) + 2) % 3];
}

/// Distance of a point from the plane of the face, positive inside the box.
double depth(const Box& box, int face, const Vec3& point) {
  const double x = point[axis_of(face)];
  return is_upper(face) ? box.size[axis_of(face)] - x : x;
}

bool grains_cross(const Geometry& geometry, int face) {
  return std::any_of(
      geometry.spheres.begin(), geometry.spheres.end(), [&](const Sphere& grain) {
        return std::abs(depth(geometry.box, face, grain.center)) < grain.radius;
      });
}

double solved_flow_rate(Scene scene) {
  scene.fidelity = Fidelity{};
  scene.geometry.bodies.clear();
  const Vec3 size = scene.geometry.box.size;
  const double spacing =
      std::max(scene.colloids->diameter / scene.fidelity.cells_per_colloid,
               std::cbrt(size.x * size.y * size.z / kMostCells));
  std::array<int, 3> cells{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = std::round(size[static_cast<int>(axis)] / spacing);
    cells[axis] = static_cast<int>(std::clamp(along, 1.0, kMostCells));
  }
  MeasureOptions options;
  options.grid.cells = cells;
  return measure(scene, options).flow_rate;
}

}  // namespace

CleanInlet clean_inlet(const Scene& scene) {
  colloids_of(scene);
  const Box& box = scene.geometry.box;
  const int face = inlet_of(box);
  const double area = face_area(box, face);
  CleanInlet inlet;
  inlet.flow_rate = scene.drive.inlet_velocity && !grains_cross(scene.geometry, face)
                        ? *scene.drive.inlet_velocity * area
                        : solved_flow_rate(scene);
  require(inlet.flow_rate > 0.0, "/drive",
          "moves no liquid through the inlet, so it carries no colloids in: the way to "
          "the outlet is blocked");
  inlet.mean_speed = inlet.flow_rate / area;
  FlowScales scales;
  scales.inlet_speed = inlet.mean_speed;
  inlet.capture_gap = analyse_regime(scene, scales).colloids->colloid_grain.capture_gap;
  return inlet;
}

InjectionPlan make_injection_plan(const Scene& scene, double capture_gap) {
  const Colloids& colloids = colloids_of(scene);
  const Box& box = scene.geometry.box;
  InjectionPlan plan;
  plan.inlet_face = inlet_of(box);
  plan.inlet_area = face_area(box, plan.inlet_face);
  plan.colloid_radius = 0.5 * colloids.diameter;
  plan.volume_fraction = colloids.volume_fraction;
  plan.capture_gap = capture_gap;

  const double room = plan.colloid_radius + capture_gap;
  for (int axis = 0; axis < 3; ++axis) {
    const bool across = axis != axis_of(plan.inlet_face);
    const bool periodic = across && box.periodic(axis);
    const double needed = across ? 2.0 * room : colloids.diameter;
    require(needed <= box.size[axis], "/colloids/diameter",
            fmt::format("is {} m: a colloid needs {:.6g} m at the inlet, with a capture "
                        "gap of {:.3g} m to each side, but the box is {} m along {}",
                        shortest(colloids.diameter), needed, capture_gap,
                        shortest(box.size[axis]), "xyz"[axis]));
    plan.periodic[static_cast<std::size_t>(axis)] = periodic;
    plan.low[axis] = periodic ? 0.0 : room;
    plan.high[axis] = box.size[axis] - plan.low[axis];
    if (!across) {
      const double release = is_upper(plan.inlet_face)
                                 ? box.size[axis] - plan.colloid_radius
                                 : plan.colloid_radius;
      plan.low[axis] = release;
      plan.high[axis] = release;
    }
  }
  for (const Sphere& grain : scene.geometry.spheres) {
    const double below = depth(box, plan.inlet_face, grain.center) - plan.colloid_radius;
    if (std::abs(below) < grain.radius + room) {
      plan.grains.push_back(grain);
    }
  }
  return plan;
}

}  // namespace colloid
