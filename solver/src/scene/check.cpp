#include "scene/check.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "scene/names.h"
#include "scene/solid.h"

namespace colloid {

namespace {

std::string pointer_to_face(int face) {
  return fmt::format("/geometry/faces/{}", face_name(face));
}

/// The only face with that condition; refuses a second one.
std::optional<int> only_face(const Box& box, FaceCondition condition) {
  std::optional<int> found;
  for (int face = 0; face < kFaces; ++face) {
    if (box.face(face) == condition) {
      require(!found, pointer_to_face(face),
              fmt::format("is a second {}, {} is one already; expected at most one",
                          word_of(condition), found ? face_name(*found) : ""));
      found = face;
    }
  }
  return found;
}

void check_faces(const Box& box) {
  for (int face = 0; face < kFaces; face += 2) {
    const bool lower = box.face(face) == FaceCondition::periodic;
    const bool upper = box.face(face + 1) == FaceCondition::periodic;
    const int odd = lower ? face + 1 : face;
    require(lower == upper, pointer_to_face(odd),
            fmt::format("is {}, but {} is periodic: expected both or none",
                        word_of(box.face(odd)), face_name(lower ? face : face + 1)));
  }
  const std::optional<int> inlet = only_face(box, FaceCondition::inlet);
  if (!inlet) {
    return;
  }
  const std::optional<int> outlet = only_face(box, FaceCondition::outlet);
  require(outlet.has_value(), pointer_to_face(*inlet),
          "is an inlet, but no face is an outlet: the liquid has no way out");
  require(axis_of(*inlet) == axis_of(*outlet), pointer_to_face(*outlet),
          fmt::format("is the outlet, expected it opposite to the inlet {}",
                      face_name(*inlet)));
}

bool has_face(const Box& box, FaceCondition condition) {
  return std::find(box.faces.begin(), box.faces.end(), condition) != box.faces.end();
}

void check_mean_velocity(const Box& box, const Vec3& velocity) {
  for (int axis = 0; axis < 3; ++axis) {
    require(box.periodic(axis) || velocity[axis] == 0.0,
            fmt::format("/drive/mean_velocity/{}", axis),
            fmt::format("is {} m/s, must be 0 m/s: the faces {} and {} are not periodic",
                        shortest(velocity[axis]), face_name(2 * axis),
                        face_name(2 * axis + 1)));
  }
  require(box.periodic(0) || box.periodic(1) || box.periodic(2), "/drive/mean_velocity",
          "needs a pair of periodic faces");
}

void check_shear(const Box& box) {
  for (const int face : {static_cast<int>(z_minus), static_cast<int>(z_plus)}) {
    require(box.face(face) == FaceCondition::wall, "/drive/shear_rate",
            fmt::format("needs walls at z- and z+, but {} is {}", face_name(face),
                        word_of(box.face(face))));
  }
  require(box.periodic(0), "/drive/shear_rate",
          fmt::format("needs periodic faces x- and x+, but they are {} and {}",
                      word_of(box.face(x_minus)), word_of(box.face(x_plus))));
}

void check_drive(const Box& box, const Drive& drive) {
  const bool inlet = has_face(box, FaceCondition::inlet);
  const char* const missing_inlet =
      "needs an inlet face and an outlet face opposite to it, but no face is an inlet";
  require(inlet || !drive.inlet_velocity, "/drive/inlet_velocity", missing_inlet);
  require(inlet || !drive.pressure_drop, "/drive/pressure_drop", missing_inlet);
  require(!inlet || drive.inlet_velocity || drive.pressure_drop, "/drive",
          "does not say what enters at the inlet face: expected inlet_velocity or "
          "pressure_drop");
  if (drive.mean_velocity) {
    check_mean_velocity(box, *drive.mean_velocity);
  }
  if (drive.shear_rate) {
    check_shear(box);
  }
}

void check_spheres(const Geometry& geometry) {
  for (std::size_t i = 0; i < geometry.spheres.size(); ++i) {
    const Sphere& sphere = geometry.spheres[i];
    if (!reaches_into(geometry.box, sphere)) {
      const auto [x, y, z] = sphere.center;
      throw InputError(
          fmt::format("/geometry/spheres/{}", i),
          fmt::format("is entirely outside the box: center ({}, {}, {}) m, diameter {} m",
                      shortest(x), shortest(y), shortest(z),
                      shortest(2.0 * sphere.radius)));
    }
  }
  require(has_void(geometry.box, geometry.spheres), "/geometry",
          "leaves no room for liquid: the grains fill the box");
  for (int face = 0; face < kFaces; ++face) {
    const FaceCondition condition = geometry.box.face(face);
    if (condition == FaceCondition::inlet || condition == FaceCondition::outlet) {
      require(has_void_on_face(geometry.box, geometry.spheres, face), "/geometry",
              fmt::format("leaves no opening: the grains cover the {} {}",
                          word_of(condition), face_name(face)));
    }
  }
}

void check_bodies(const Geometry& geometry, const Fidelity& fidelity) {
  const std::vector<Body>& bodies = geometry.bodies;
  const bool driven = std::any_of(bodies.begin(), bodies.end(),
                                  [](const Body& body) { return body.velocity; });
  require(!driven || fidelity.tier != TierChoice::one_way, "/fidelity/tier",
          "is one_way, but /geometry/bodies with a velocity need quasi_steady or "
          "transient");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string where = fmt::format("/geometry/bodies/{}", i);
    const Sphere& body = bodies[i].sphere;
    for (int face = 0; face < kFaces; ++face) {
      const double room = room_at_face(geometry.box, body, face);
      require(room >= 0.0, where,
              fmt::format("sticks out of the box by {} m at {}", shortest(-room),
                          face_name(face)));
    }
    for (std::size_t j = 0; j < geometry.spheres.size(); ++j) {
      const double gap = surface_gap(geometry.box, body, geometry.spheres[j]);
      require(gap >= 0.0, where, [&] {
        return fmt::format("overlaps grain {} by {} m", j, shortest(-gap));
      });
    }
    for (std::size_t j = 0; j < i; ++j) {
      const double gap = surface_gap(geometry.box, body, bodies[j].sphere);
      require(gap >= 0.0, where, [&] {
        return fmt::format("overlaps /geometry/bodies/{} by {} m", j, shortest(-gap));
      });
    }
  }
}

/// A colloid must fit into the box, and through the inlet between its side faces.
void check_colloid_size(const Box& box, const Colloids& colloids) {
  const bool inlet = has_face(box, FaceCondition::inlet);
  for (int axis = 0; axis < 3; ++axis) {
    const bool across = box.face(2 * axis) == FaceCondition::inlet ||
                        box.face(2 * axis + 1) == FaceCondition::inlet;
    require(colloids.diameter < box.size[axis], "/colloids/diameter",
            fmt::format("is {} m, must be below the {} of the {}, {} m",
                        shortest(colloids.diameter), across ? "length" : "width",
                        inlet && !across ? "inlet" : "box", shortest(box.size[axis])));
  }
}

}  // namespace

void check_scene(const Scene& scene) {
  check_faces(scene.geometry.box);
  check_drive(scene.geometry.box, scene.drive);
  check_spheres(scene.geometry);
  check_bodies(scene.geometry, scene.fidelity);
  if (scene.colloids) {
    check_colloid_size(scene.geometry.box, *scene.colloids);
  }
}

}  // namespace colloid
