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
  const bool moving = image.sphere >= fixed_count_;
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
        if (square >= outer) {
          continue;
        }
        if (moving) {
          changes_.push_back({component, q, head[q]});
        }
        if (square < inner) {
          head[q] = kSolid - index;
          stale_[q] = 1;
        } else {
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
  assert(fixed_count_ == sphere_count_);
  closed_.clear();
  const std::size_t first = images_.size();
  for (const Sphere& sphere : spheres) {
    add_images(sphere);
  }
  fixed_count_ = sphere_count_;
  stale_.assign(grid_.size, 0);
  add_from(first);
  fixed_images_ = images_.size();
  fixed_candidates_ = candidates_.size();
}

void WallRows::set_moving(const std::vector<Sphere>& spheres) {
  closed_.clear();
  stale_.assign(grid_.size, 0);
  close_subgrid();
  forget_moving();
  for (const Sphere& sphere : spheres) {
    add_images(sphere);
  }
  add_from(fixed_images_);
}

// Takes moving spheres out of the lists; their rows are stale then.
void WallRows::forget_moving() {
  for (auto& boxes : moved_boxes_) {
    boxes.clear();
  }
  for (std::size_t m = fixed_images_; m < images_.size(); ++m) {
    for (int c = 0; c < 4; ++c) {
      moved_boxes_[static_cast<std::size_t>(c)].push_back(reach_of(images_[m], c));
    }
  }
  while (!changes_.empty()) {
    const HeadChange& change = changes_.back();
    head_[static_cast<std::size_t>(change.component)][change.at] = change.before;
    changes_.pop_back();
  }
  candidates_.resize(fixed_candidates_);
  images_.resize(fixed_images_);
  sphere_count_ = fixed_count_;
}

std::vector<WallRows::IndexBox> WallRows::moving_boxes(int component) const {
  std::vector<IndexBox> boxes;
  for (std::size_t m = fixed_images_; m < images_.size(); ++m) {
    boxes.push_back(reach_of(images_[m], component));
  }
  return boxes;
}

// Makes the rows near the images from `first` on, and near spheres just forgotten.
void WallRows::add_from(std::size_t first) {
  for (int c = 0; c < 3; ++c) {
    const auto s = static_cast<std::size_t>(c);
    std::vector<IndexBox> boxes = moved_boxes_[s];
    for (const IndexBox& box : boxes) {
      mark_stale(box);
    }
    for (std::size_t m = first; m < images_.size(); ++m) {
      collect(static_cast<std::int32_t>(m), c);
      boxes.push_back(reach_of(images_[m], c));
    }
    for (const IndexBox& box : boxes) {
      make_stale_rows(box, c);
    }
    wrap(c);
  }
  std::vector<IndexBox> boxes = moved_boxes_[pressure];
  for (std::size_t m = first; m < images_.size(); ++m) {
    boxes.push_back(reach_of(images_[m], pressure));
  }
  for (IndexBox& box : boxes) {
    for (int& begin : box.begin) {
      begin = std::max(0, begin - 1);
    }
    make_cells(box);
  }
  for (auto& moved : moved_boxes_) {
    moved.clear();
  }
}

void WallRows::mark_stale(const IndexBox& box) {
  for (int k = box.begin[2]; k < box.end[2]; ++k) {
    for (int j = box.begin[1]; j < box.end[1]; ++j) {
      const std::size_t q = grid_.index(box.begin[0], j, k);
      const int count = box.end[0] - box.begin[0];
      std::fill_n(stale_.begin() + static_cast<std::ptrdiff_t>(q), std::max(0, count), 1);
    }
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

// Both sides of a row along each axis: weight of the unknown, distance to the neighbour
// or the wall, and the surface whose velocity counts there.
struct WallRows::RowSides {
  std::array<std::array<double, 2>, 3> pull{};
  std::array<std::array<const Row*, 2>, 3> surface{};
  std::array<double, 3> prefactor{};
  double diagonal = 0.0;
};

WallRows::RowSides WallRows::row_sides(int component, const std::array<int, 3>& at,
                                       const NearSurfaces& surfaces) const {
  const int t1 = (component + 1) % 3;
  const int t2 = (component + 2) % 3;
  const double w1 = width(t1, at);
  const double w2 = width(t2, at);
  const std::vector<Row>& near = surfaces.all;
  const Row& wall = near[surfaces.first];
  RowSides sides;
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    const SecondDifference& d = difference(component, a, at[s]);
    auto& pull = sides.pull[s];
    std::array<double, 2> distance{};
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
      sides.surface[s][side] = &wall;
      if (there < 0.0) {
        distance[side] = step * std::min(1.0, wall.moment / (wall.moment - there));
      }
      for (const Row& other : near) {
        Vec3 there_from_center = other.from_center;
        there_from_center[a] += sign * step;
        if (&other == &wall || norm(there_from_center) >= other.image->radius) {
          continue;
        }
        const double cut = std::max(
            kShortestLink * step,
            distance_along(other.from_center, a, sign, other.image->radius, step));
        if (1.0 / cut > pull[side]) {
          pull[side] = 1.0 / cut;
          sides.surface[s][side] = &other;
        }
        distance[side] = std::min(distance[side], cut);
      }
    }
    const bool free = d.side_below == Side::no_shear || d.side_above == Side::no_shear;
    sides.prefactor[s] = free ? d.prefactor : 2.0 / (distance[0] + distance[1]);
    if (free) {
      pull = {std::max(0.0, pull[0]), std::max(0.0, pull[1])};
    }
    sides.diagonal += sides.prefactor[s] * (pull[0] + pull[1]);
  }
  return sides;
}

void WallRows::make_row(int component, const std::array<int, 3>& at) {
  const std::size_t q = grid_.index(at[0], at[1], at[2]);
  NearSurfaces& surfaces = *scratch_;
  find_near_surfaces(component, at, surfaces);
  if (surfaces.open < kClosed * spacing_) {
    close(component, q);
    return;
  }
  const RowSides sides = row_sides(component, at, surfaces);
  std::array<double, 3> factor{};
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    factor[s] = sides.prefactor[s] / difference(component, a, at[s]).prefactor;
  }
  store(component, q, factor, sides.diagonal);
}

// The row acts on the velocity relative to the surface that counts on each side.  A
// neighbour that is closed has the velocity of its own surface.
void WallRows::surface_terms(int component, const std::array<int, 3>& at,
                             std::vector<SurfaceTerm>& terms) const {
  terms.clear();
  const auto c = static_cast<std::size_t>(component);
  const std::size_t q = grid_.index(at[0], at[1], at[2]);
  if (head_[c][q] < 0 || coefficients_.row_scale[c][q] <= 0.0F) {
    return;
  }
  NearSurfaces& surfaces = *scratch_;
  find_near_surfaces(component, at, surfaces);
  if (surfaces.open < kClosed * spacing_) {
    return;  // opened below the grid
  }
  const RowSides sides = row_sides(component, at, surfaces);
  const double least = kLeastDiagonal * coefficients_.diagonal;
  const double scale = coefficients_.diagonal / std::max(sides.diagonal, least);
  const auto add = [&](int sphere, double weight, const Vec3& from_center) {
    terms.push_back({sphere, scale * weight, from_center});
  };
  if (sides.diagonal < least) {
    const Row& wall = surfaces.all[surfaces.first];
    add(wall.image->sphere, least - sides.diagonal, wall.from_center);
  }
  for (int a = 0; a < 3; ++a) {
    const auto s = static_cast<std::size_t>(a);
    const SecondDifference& d = difference(component, a, at[s]);
    for (std::size_t side = 0; side < 2; ++side) {
      const Row* surface = sides.surface[s][side];
      if (surface == nullptr) {
        continue;
      }
      const int sign = side == 0 ? -1 : 1;
      const double step = side == 0 ? d.below : d.above;
      Vec3 there = surface->from_center;
      there[a] += sign * step;
      const double weight = sides.prefactor[s] / step;
      add(surface->image->sphere, sides.prefactor[s] * sides.pull[s][side],
          surface->from_center);
      add(surface->image->sphere, -weight, there);
      const auto neighbour = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(q) +
                                                      sign * grid_.stride(a));
      if (coefficients_.row_scale[c][neighbour] > 0.0F) {
        continue;
      }
      std::array<int, 3> next = at;
      next[s] += sign;
      next = grid_.wrapped(next);
      if (on_given_face(component, next)) {
        continue;
      }
      const NearestSurface owner = nearest(component, next[0], next[1], next[2]);
      if (owner.sphere >= 0) {
        add(owner.sphere, weight, owner.from_center);
      }
    }
  }
}

void WallRows::open_subgrid(int component, std::size_t face, double conductance) {
  const auto c = static_cast<std::size_t>(component);
  close(component, face);
  coefficients_.row_scale[c][face] =
      static_cast<float>(coefficients_.diagonal * conductance);
  opened_.push_back({c, face});
}

// Throats below the grid belong to one arrangement of the spheres.
void WallRows::close_subgrid() {
  for (const Entry& face : opened_) {
    close(static_cast<int>(face.component), face.at);
  }
  if (!opened_.empty()) {
    opened_.clear();
    update_cells();
  }
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
