// Where the solid of a scene is: gaps between balls and faces, and whether any void is
// left.
#pragma once

#include <vector>

#include "core/box.h"

namespace colloid {

/// Distance of the surfaces of two balls [m], the nearest periodic images; negative if
/// they overlap.
double surface_gap(const Box& box, const Sphere& a, const Sphere& b);

/// How far the ball is from that face [m], negative if it sticks out; on a periodic face,
/// of its centre.
double room_at_face(const Box& box, const Sphere& ball, int face);

/// Whether some part of the ball is inside the box.
bool reaches_into(const Box& box, const Sphere& ball);

/// Whether there is a point of the box outside all balls, tried at 48^3 points: grains
/// that leave less than that are not resolved by any grid either.
bool has_void(const Box& box, const std::vector<Sphere>& balls);

/// The part of the box outside all balls [-], counted at as many points: within 1 % of
/// the box for grains of a tenth of its size and larger.
double void_fraction(const Box& box, const std::vector<Sphere>& balls);

/// Whether there is such a point on one face of the box, tried at 192^2 points.
bool has_void_on_face(const Box& box, const std::vector<Sphere>& balls, int face);

}  // namespace colloid
