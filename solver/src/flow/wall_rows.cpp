#include "flow/wall_rows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "flow/halo.h"
#include "flow/wall_moment.h"

namespace colloid {

namespace {

constexpr std::int32_t kNone = -1;
// Deep inside image m the list holds kSolid - m instead.
constexpr std::int32_t kSolid = -2;

// A face that two surfaces cut is measured by sampling; 4 x 4 points.
constexpr int kSamples = 4;

// A second surface's wall distance is not resolved below this part of a spacing.
constexpr double kShortestLink = 0.05;

// Least diagonal, relative to a regular row's.
constexpr double kLeastDiagonal = 0.25;

// Distance along an axis, from x in direction `sign`, to the sphere; `limit` if missed.
double distance_along(const Vec3& from_center, int axis, double sign, double radius,
                      double limit) {
  const double b = from_center[axis] * sign;
  const double c = dot(from_center, from_center) - radius * radius;
  const double discriminant = b * b - c;
  if (discriminant < 0.0) {
    return limit;
  }
  return std::min(limit, std::max(0.0, -b - std::sqrt(discriminant)));
}

}  // namespace

// A surface near a face: local tangent plane and the moment of the face above it.
struct WallRows::Row {
  const Image* image = nullptr;
  Vec3 from_center;
  Vec3 normal;
  double distance = 0.0;
  double moment = 0.0;
};

struct WallRows::NearSurfaces {
  std::vector<Row> all;
  std::size_t first = 0;  // the one that closes the face most
  double open = 0.0;      // moment of the face above all of them
};

double WallRows::width(int axis, const std::array<int, 3>& at) const {
  const auto a = static_cast<std::size_t>(axis);
  return grid_.width[a][static_cast<std::size_t>(at[a])];
}

WallRows::WallRows(const Grid& grid, const FlowFaces& faces)
    : grid_(grid), faces_(faces), scratch_(std::make_unique<NearSurfaces>()) {
  double widest = 0.0;
  spacing_ = 1e300;
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    axes_[s] = make_axis_stencil(grid_, a, faces_[2 * s].kind, faces_[2 * s + 1].kind);
    for (double w : grid_.width[s]) {
      widest = std::max(widest, w);
    }
    spacing_ = std::min(spacing_, grid_.width[s].front());
    coefficients_.diagonal += 2.0 / (grid_.width[s].front() * grid_.width[s].front());
  }
  // A row sees its neighbours' moments: one spacing and half a face's diagonal away.
  reach_ = 1.75 * widest;

  coefficients_.cell_scale.assign(grid_.size, 0.0F);
  IndexBox whole;
  for (int c = 0; c < 3; ++c) {
    const auto s = static_cast<std::size_t>(c);
    coefficients_.row_scale[s].assign(grid_.size, 0.0F);
    for (auto& link : coefficients_.link[s]) {
      link.assign(grid_.size, 0.0F);
    }
    head_[s].assign(grid_.size, kNone);
    whole.end = {grid_.end(c, 0), grid_.end(c, 1), grid_.end(c, 2)};
    make_rows(whole, c);
    wrap(c);
  }
  whole.end = grid_.cells;
  make_cells(whole);
}

WallRows::~WallRows() = default;

bool WallRows::on_given_face(int component, const std::array<int, 3>& at) const {
  const auto c = static_cast<std::size_t>(component);
  if (grid_.periodic[c]) {
    return false;
  }
  return (at[c] == 0 && faces_[2 * c].kind != FlowFace::Kind::pressure) ||
         (at[c] == grid_.cells[c] && faces_[2 * c + 1].kind != FlowFace::Kind::pressure);
}

const SecondDifference& WallRows::difference(int component, int axis, int i) const {
  const AxisStencil& s = axes_[static_cast<std::size_t>(axis)];
  return (component == axis ? s.at_face : s.at_centre)[static_cast<std::size_t>(i)];
}

WallRows::IndexBox WallRows::reach_of(const Image& image, int component) const {
  IndexBox box;
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    const auto& x = grid_.position[s];
    const double low = image.center[a] - image.radius - reach_;
    const double high = image.center[a] + image.radius + reach_;
    const auto first = std::upper_bound(x.begin(), x.end(), low) - x.begin() - 1;
    const auto last = std::lower_bound(x.begin(), x.end(), high) - x.begin() + 1;
    box.begin[s] = std::max(0, static_cast<int>(first));
    box.end[s] = std::min(grid_.end(component, a), static_cast<int>(last));
  }
  return box;
}

void WallRows::collect(std::int32_t index, int component) {
  const Image& image = images_[static_cast<std::size_t>(index)];
  const IndexBox box = reach_of(image, component);
  auto& head = head_[static_cast<std::size_t>(component)];
  const double outer = (image.radius + reach_) * (image.radius + reach_);
  const double depth = std::max(0.0, image.radius - 0.8 * reach_);
  const double inner = depth * depth;
  for (int k = box.begin[2]; k < box.end[2]; ++k) {
    for (int j = box.begin[1]; j < box.end[1]; ++j) {
      for (int i = box.begin[0]; i < box.end[0]; ++i) {
        const std::size_t q = grid_.index(i, j, k);
        if (head[q] <= kSolid) {
          continue;
        }
        const Vec3 e = grid_.location(component, i, j, k) - image.center;
        const double square = dot(e, e);
        if (square < inner) {
          head[q] = kSolid - index;
          stale_[q] = 1;
        } else if (square < outer) {
          candidates_.push_back({index, head[q]});
          head[q] = static_cast<std::int32_t>(candidates_.size() - 1);
          stale_[q] = 1;
        }
      }
    }
  }
}

void WallRows::add(const Sphere& sphere) {
  add(std::vector<Sphere>{sphere});
}

// The sphere and those of its periodic images that reach the box.
void WallRows::add_images(const Sphere& sphere) {
  std::array<int, 3> shifts{};
  for (std::size_t a = 0; a < 3; ++a) {
    shifts[a] = grid_.periodic[a] ? 1 : 0;
  }
  for (int kz = -shifts[2]; kz <= shifts[2]; ++kz) {
    for (int ky = -shifts[1]; ky <= shifts[1]; ++ky) {
      for (int kx = -shifts[0]; kx <= shifts[0]; ++kx) {
        Image image{sphere.center, sphere.radius, sphere_count_};
        const std::array<int, 3> shift{kx, ky, kz};
        bool reaches = true;
        for (int a = 0; a < 3; ++a) {
          const auto s = static_cast<std::size_t>(a);
          const double length = grid_.position[s].back();
          image.center[a] += shift[s] * length;
          reaches = reaches && image.center[a] + image.radius + reach_ > 0.0 &&
                    image.center[a] - image.radius - reach_ < length;
        }
        if (reaches) {
          images_.push_back(image);
        }
      }
    }
  }
  ++sphere_count_;
}

void WallRows::add(const std::vector<Sphere>& spheres) {
  closed_.clear();
  const std::size_t first = images_.size();
  for (const Sphere& sphere : spheres) {
    add_images(sphere);
  }
  if (first == images_.size()) {
    return;
  }
  stale_.assign(grid_.size, 0);
  for (int c = 0; c < 3; ++c) {
    IndexBox all = reach_of(images_[first], c);
    for (std::size_t m = first; m < images_.size(); ++m) {
      collect(static_cast<std::int32_t>(m), c);
      const IndexBox box = reach_of(images_[m], c);
      for (std::size_t a = 0; a < 3; ++a) {
        all.begin[a] = std::min(all.begin[a], box.begin[a]);
        all.end[a] = std::max(all.end[a], box.end[a]);
      }
    }
    make_stale_rows(all, c);
    wrap(c);
  }
  for (std::size_t m = first; m < images_.size(); ++m) {
    IndexBox box = reach_of(images_[m], pressure);
    for (std::size_t a = 0; a < 3; ++a) {
      box.begin[a] = std::max(0, box.begin[a] - 1);
    }
    make_cells(box);
  }
}

void WallRows::make_stale_rows(const IndexBox& box, int component) {
  for (int k = box.begin[2]; k < box.end[2]; ++k) {
    for (int j = box.begin[1]; j < box.end[1]; ++j) {
      for (int i = box.begin[0]; i < box.end[0]; ++i) {
        char& stale = stale_[grid_.index(i, j, k)];
        if (stale != 0) {
          stale = 0;
          make_rows({{i, j, k}, {i + 1, j + 1, k + 1}}, component);
        }
      }
    }
  }
}

void WallRows::make_rows(const IndexBox& box, int component) {
  const auto& head = head_[static_cast<std::size_t>(component)];
  for (int k = box.begin[2]; k < box.end[2]; ++k) {
    for (int j = box.begin[1]; j < box.end[1]; ++j) {
      for (int i = box.begin[0]; i < box.end[0]; ++i) {
        const std::size_t q = grid_.index(i, j, k);
        const std::array<int, 3> at{i, j, k};
        if (head[q] <= kSolid || on_given_face(component, at)) {
          close(component, q);
        } else if (head[q] == kNone) {
          regular_row(component, at);
        } else {
          make_row(component, at);
        }
      }
    }
  }
}

void WallRows::close(int component, std::size_t q) {
  const auto c = static_cast<std::size_t>(component);
  if (coefficients_.row_scale[c][q] > 0.0F) {
    closed_.push_back({c, q});
  }
  coefficients_.row_scale[c][q] = 0.0F;
  for (auto& link : coefficients_.link[c]) {
    link[q] = 0.0F;
  }
}

void WallRows::store(int component, std::size_t q, const std::array<double, 3>& factor,
                     double diagonal) {
  const auto c = static_cast<std::size_t>(component);
  const double scale = coefficients_.diagonal /
                       std::max(diagonal, kLeastDiagonal * coefficients_.diagonal);
  coefficients_.row_scale[c][q] = static_cast<float>(scale);
  for (std::size_t a = 0; a < 3; ++a) {
    coefficients_.link[c][a][q] = static_cast<float>(factor[a] * scale);
  }
}

void WallRows::regular_row(int component, const std::array<int, 3>& at) {
  double diagonal = 0.0;
  for (int a = 0; a < 3; ++a) {
    diagonal += difference(component, a, at[static_cast<std::size_t>(a)]).diagonal();
  }
  store(component, grid_.index(at[0], at[1], at[2]), {1.0, 1.0, 1.0}, diagonal);
}

void WallRows::find_near_surfaces(int component, const std::array<int, 3>& at,
                                  NearSurfaces& found) const {
  const std::size_t q = grid_.index(at[0], at[1], at[2]);
  const Vec3 x = grid_.location(component, at[0], at[1], at[2]);
  const int t1 = (component + 1) % 3;
  const int t2 = (component + 2) % 3;
  const double w1 = width(t1, at);
  const double w2 = width(t2, at);

  // 1  the surfaces near, and the one that closes the face most
  found.all.clear();
  found.first = 0;
  int touching = 0;
  for (std::int32_t m = head_[static_cast<std::size_t>(component)][q]; m != kNone;
       m = candidates_[static_cast<std::size_t>(m)].next) {
    Row s;
    s.image = &images_[static_cast<std::size_t>(
        candidates_[static_cast<std::size_t>(m)].image)];
    s.from_center = x - s.image->center;
    const double r = norm(s.from_center);
    s.normal = r > 0.0 ? s.from_center * (1.0 / r) : Vec3{0.0, 0.0, 1.0};
    s.distance = r - s.image->radius;
    s.moment = wall_moment(s.distance, s.normal[t1] * w1, s.normal[t2] * w2);
    touching += s.moment == s.distance ? 0 : 1;
    found.all.push_back(s);
    const Row& best = found.all[found.first];
    if (s.moment < best.moment ||
        (s.moment == best.moment && s.distance < best.distance)) {
      found.first = found.all.size() - 1;
    }
  }

  // 2  its moment; where several surfaces cut the face, less by the part that the others
  // take
  //    at sampled points (none, if they are the same surface)
  found.open = found.all[found.first].moment;
  if (touching > 1) {
    const Row& wall = found.all[found.first];
    double alone = 0.0;
    double together = 0.0;
    for (int a = 0; a < kSamples; ++a) {
      for (int b = 0; b < kSamples; ++b) {
        Vec3 y = x;
        y[t1] += ((a + 0.5) / kSamples - 0.5) * w1;
        y[t2] += ((b + 0.5) / kSamples - 0.5) * w2;
        const double here = norm(y - wall.image->center) - wall.image->radius;
        double distance = here;
        for (const Row& s : found.all) {
          distance = std::min(distance, norm(y - s.image->center) - s.image->radius);
        }
        alone += std::max(0.0, here);
        together += std::max(0.0, distance);
      }
    }
    found.open *= alone > 0.0 ? together / alone : 0.0;
  }
}

double WallRows::moment(int component, const std::array<int, 3>& at) const {
  const std::int32_t head =
      head_[static_cast<std::size_t>(component)][grid_.index(at[0], at[1], at[2])];
  if (head <= kSolid) {
    return 0.0;
  }
  if (head == kNone) {
    return reach_;
  }
  NearSurfaces found;
  find_near_surfaces(component, at, found);
  return found.open;
}

bool WallRows::away(int component, const std::array<int, 3>& at) const {
  return head_[static_cast<std::size_t>(component)][grid_.index(at[0], at[1], at[2])] ==
         kNone;
}

// One row from beginning to end, in numbered steps.
// NOLINTNEXTLINE(readability-function-size)
void WallRows::make_row(int component, const std::array<int, 3>& at) {
  const std::size_t q = grid_.index(at[0], at[1], at[2]);
  const int t1 = (component + 1) % 3;
  const int t2 = (component + 2) % 3;
  const double w1 = width(t1, at);
  const double w2 = width(t2, at);

  NearSurfaces& surfaces = *scratch_;
  find_near_surfaces(component, at, surfaces);
  const std::vector<Row>& near = surfaces.all;
  const Row& wall = near[surfaces.first];
  const double open = surfaces.open;
  if (open < kClosed * spacing_) {
    close(component, q);
    return;
  }

  // 3  the second difference along each axis
  std::array<double, 3> factor{};
  double diagonal = 0.0;
  for (int a = 0; a < 3; ++a) {
    const SecondDifference& d = difference(component, a, at[static_cast<std::size_t>(a)]);
    std::array<double, 2> pull{};      // weight of the unknown, per side
    std::array<double, 2> distance{};  // to the neighbour or the wall
    for (std::size_t side = 0; side < 2; ++side) {
      const double sign = side == 0 ? -1.0 : 1.0;
      const double step = side == 0 ? d.below : d.above;
      const Side kind = side == 0 ? d.side_below : d.side_above;
      distance[side] = step;
      if (kind == Side::given_velocity) {
        pull[side] = 1.0 / step;
      }
      if (kind != Side::neighbour) {
        continue;
      }
      const double slope = sign * wall.normal[a];
      const double there = wall.distance + slope * step;
      const double moment =
          wall_moment(there, wall.normal[t1] * w1, wall.normal[t2] * w2);
      pull[side] = (moment / step - slope) / wall.moment;
      if (there < 0.0) {
        distance[side] = step * std::min(1.0, wall.moment / (wall.moment - there));
      }
      for (const Row& s : near) {
        Vec3 there_from_center = s.from_center;
        there_from_center[a] += sign * step;
        if (&s == &wall || norm(there_from_center) >= s.image->radius) {
          continue;
        }
        const double cut =
            std::max(kShortestLink * step,
                     distance_along(s.from_center, a, sign, s.image->radius, step));
        pull[side] = std::max(pull[side], 1.0 / cut);
        distance[side] = std::min(distance[side], cut);
      }
    }
    const bool free = d.side_below == Side::no_shear || d.side_above == Side::no_shear;
    const double prefactor = free ? d.prefactor : 2.0 / (distance[0] + distance[1]);
    if (free) {
      pull = {std::max(0.0, pull[0]), std::max(0.0, pull[1])};
    }
    factor[static_cast<std::size_t>(a)] = prefactor / d.prefactor;
    diagonal += prefactor * (pull[0] + pull[1]);
  }
  store(component, q, factor, diagonal);
}

void WallRows::open_subgrid(int component, std::size_t face, double conductance) {
  const auto c = static_cast<std::size_t>(component);
  close(component, face);
  coefficients_.row_scale[c][face] =
      static_cast<float>(coefficients_.diagonal * conductance);
}

void WallRows::update_cells() {
  for (int c = 0; c < 3; ++c) {
    wrap(c);
  }
  IndexBox whole;
  whole.end = grid_.cells;
  make_cells(whole);
}

NearestSurface WallRows::nearest(int component, int i, int j, int k) const {
  const Vec3 x = grid_.location(component, i, j, k);
  NearestSurface found;
  found.distance = std::numeric_limits<double>::max();
  const auto consider = [&](std::int32_t index) {
    const Image& image = images_[static_cast<std::size_t>(index)];
    const Vec3 e = x - image.center;
    const double distance = norm(e) - image.radius;
    if (distance < found.distance) {
      found = {image.sphere, distance, e};
    }
  };
  std::int32_t m = head_[static_cast<std::size_t>(component)][grid_.index(i, j, k)];
  if (m <= kSolid) {
    consider(kSolid - m);
    return found;
  }
  for (; m != kNone; m = candidates_[static_cast<std::size_t>(m)].next) {
    consider(candidates_[static_cast<std::size_t>(m)].image);
  }
  return found;
}

void WallRows::wrap(int component) {
  fill_halo(grid_, coefficients_.row_scale[static_cast<std::size_t>(component)].data());
}

void WallRows::make_cells(const IndexBox& box) {
  const Coefficients& m = coefficients_;
  for (int k = box.begin[2]; k < box.end[2]; ++k) {
    for (int j = box.begin[1]; j < box.end[1]; ++j) {
      for (int i = box.begin[0]; i < box.end[0]; ++i) {
        const std::size_t q = grid_.index(i, j, k);
        const std::array<int, 3> at{i, j, k};
        double sum = 0.0;
        for (int a = 0; a < 3; ++a) {
          const auto s = static_cast<std::size_t>(a);
          const auto lower = static_cast<std::size_t>(at[s]) + 1;
          const auto& gradient = axes_[s].gradient;
          const std::size_t up = q + static_cast<std::size_t>(grid_.stride(a));
          sum += static_cast<double>(axes_[s].divergence[lower]) *
                 (static_cast<double>(m.row_scale[s][q] * gradient[lower]) +
                  static_cast<double>(m.row_scale[s][up] * gradient[lower + 1]));
        }
        if (sum <= 0.0 && m.cell_scale[q] > 0.0F) {
          closed_.push_back({pressure, q});
        }
        coefficients_.cell_scale[q] =
            sum > 0.0 ? static_cast<float>(m.diagonal / sum) : 0.0F;
      }
    }
  }
}

}  // namespace colloid
