// The momentum rows of one grid level, spheres and faces of the box included.
//
// The unknown of a face is the mean normal velocity through the WHOLE face, solid part
// included (velocity zero there): so the discrete divergence sums exact fluxes, and mass
// is conserved to the last digit however the spheres cut the cells.  Near a sphere the
// velocity grows linearly with the distance, so a cut face carries the shear times its
// wall moment M (wall_moment.h), and M takes the place of the distance in the
// Shortley-Weller difference: a row is exact for the linear profile of a plane wall in
// any position, MODEL (F8). A face is open while M is above kClosed; M, and with it the
// whole system, depends continuously on where the spheres are.
//
// Rejected: faces open where their centre is fluid (fluxes then have a first-order error
// that no refinement of the rows removes: K of a simple-cubic array stalls 0.06 % off),
// and averaging fine operators for the coarse levels (this rule, applied to the coarse
// grid's own cut faces, already gives convergence that depends neither on size nor on
// crowding).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "flow/axis_stencil.h"
#include "flow/grid.h"

namespace colloid {

/// Coefficients of one level; arrays as laid out by Grid.  A row of the momentum equation
/// is divided by its own diagonal and multiplied by `diagonal`, the same for all rows:
///
///   diagonal u - sum_axes link (w- u- + w+ u+) + row_scale (grad p - f) = 0        (F9)
struct Coefficients {
  std::array<std::array<std::vector<float>, 3>, 3> link;  ///< [component][axis]
  std::array<std::vector<float>, 3> row_scale;            ///< [component]; 0 = closed
  std::vector<float> cell_scale;  ///< one over the diagonal of D C^-1 G; 0 = no open face
  double diagonal = 0.0;
};

/// Where an unknown is, or was.
struct Entry {
  std::size_t component = 0;
  std::size_t at = 0;
};

/// A surface's part in a face, for sharing out forces.
struct NearestSurface {
  int sphere = -1;        ///< index into the spheres, -1 where none is near
  double distance = 0.0;  ///< signed, grid units
  Vec3 from_center;       ///< from the sphere's (image's) centre, grid units
};

class WallRows {
 public:
  /// Moment below which a face is closed, in spacings.
  static constexpr double kClosed = 1e-3;

  WallRows(const Grid& grid, const FlowFaces& faces);
  ~WallRows();

  /// Adds a sphere (grid units; periodic images are found here) and updates the rows
  /// near.
  void add(const Sphere& sphere);
  /// As add(), many at once: rows that two spheres share are made once.
  void add(const std::vector<Sphere>& spheres);

  /// Spheres that move, in place of those of the last call; they count after all others.
  /// The rows are the same to the bit as if they had been added.  add() needs them gone.
  void set_moving(const std::vector<Sphere>& spheres);

  /// Where rows and faces of one moving sphere (or an image of it) are.
  struct IndexBox {
    std::array<int, 3> begin{}, end{};
  };
  std::vector<IndexBox> moving_boxes(int component) const;
  int fixed_count() const { return fixed_count_; }  ///< spheres that do not move
  int sphere_count() const { return sphere_count_; }

  /// What a moving surface brings into a row: its velocity at a point, times `weight`,
  /// is added to the right-hand side of (F9).
  struct SurfaceTerm {
    int sphere = -1;
    double weight = 0.0;
    Vec3 from_center;  ///< of the point, from the sphere's (image's) centre
  };
  /// Those of one open row, by the spheres near it, fixed ones too.                 (F18)
  void surface_terms(int component, const std::array<int, 3>& at,
                     std::vector<SurfaceTerm>& terms) const;

  /// Opens a closed face as a sub-grid throat: mean velocity = conductance x (f - grad
  /// p).
  void open_subgrid(int component, std::size_t face, double conductance);
  void update_cells();

  /// Effective wall distance of a face: its moment (wall_moment.h); at least the reach of
  /// the walls where none is near.  Grid units.
  double moment(int component, const std::array<int, 3>& at) const;
  /// No surface is near enough to change this row or its neighbours.
  bool away(int component, const std::array<int, 3>& at) const;
  /// The nearest surface among those within reach.
  NearestSurface nearest(int component, int i, int j, int k) const;

  const Coefficients& coefficients() const { return coefficients_; }
  /// What the last add() closed: vectors kept from before must become zero there.
  const std::vector<Entry>& closed_entries() const { return closed_; }
  const std::array<AxisStencil, 3>& axes() const { return axes_; }
  const Grid& grid() const { return grid_; }
  /// Is this face one of the box's own, with a given velocity (no unknown)?
  bool on_given_face(int component, const std::array<int, 3>& at) const;

 private:
  struct Image {
    Vec3 center;
    double radius;
    int sphere;
  };
  struct Candidate {
    std::int32_t image;
    std::int32_t next;
  };
  struct HeadChange {
    int component;
    std::size_t at;
    std::int32_t before;
  };
  struct Row;
  struct NearSurfaces;
  struct RowSides;

  double width(int axis, const std::array<int, 3>& at) const;
  void find_near_surfaces(int component, const std::array<int, 3>& at,
                          NearSurfaces& found) const;
  RowSides row_sides(int component, const std::array<int, 3>& at,
                     const NearSurfaces& surfaces) const;
  IndexBox reach_of(const Image& image, int component) const;
  void add_images(const Sphere& sphere);
  void collect(std::int32_t image, int component);
  void forget_moving();
  void close_subgrid();
  void add_from(std::size_t first_image);
  void make_rows(const IndexBox& box, int component);
  void mark_stale(const IndexBox& box);
  void make_stale_rows(const IndexBox& box, int component);
  void make_row(int component, const std::array<int, 3>& at);
  void regular_row(int component, const std::array<int, 3>& at);
  void store(int component, std::size_t q, const std::array<double, 3>& factor,
             double diagonal);
  void close(int component, std::size_t q);
  void make_cells(const IndexBox& box);
  void wrap(int component);
  const SecondDifference& difference(int component, int axis, int i) const;

  Grid grid_;
  FlowFaces faces_;
  std::array<AxisStencil, 3> axes_;
  Coefficients coefficients_;
  double reach_ = 0.0;
  double spacing_ = 0.0;  ///< smallest regular spacing
  std::vector<Image> images_;
  int sphere_count_ = 0;
  int fixed_count_ = 0;
  std::size_t fixed_images_ = 0;
  std::size_t fixed_candidates_ = 0;
  std::vector<HeadChange> changes_;  ///< of the lists, by moving spheres, in order
  std::array<std::vector<IndexBox>, 4> moved_boxes_;  ///< of those that were forgotten
  std::array<std::vector<std::int32_t>, 3> head_;  ///< first candidate, -1 none, -2 solid
  std::vector<Candidate> candidates_;
  std::vector<char> stale_;  ///< rows to be made again; all zero between calls
  std::vector<Entry> closed_;
  std::vector<Entry> opened_;  ///< below the grid
  std::unique_ptr<NearSurfaces> scratch_;
};

}  // namespace colloid
