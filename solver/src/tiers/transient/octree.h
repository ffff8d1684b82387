// The octree grid of the transient tier: cubes of the base grid, each cut into 8^level
// cells, level by level finer towards colloids.                          MODEL section T
//
// Always built from scratch, in one canonical order, from the levels alone: the same
// levels give the same numbering whatever was refined before, so that a checkpoint needs
// the levels and one number a cell and field, and a continued run is the same to the bit.
// (The stock way, splitting cells of a mesh that lives on, keeps a history in its
// numbering, maps fluxes with wrong signs, and costs more than building anew.)
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/box.h"

namespace colloid {

using Index3 = std::array<int, 3>;

/// Which base cells are there, and how finely each is cut.
struct OctreeLevels {
  Box box;
  Index3 cells{};          ///< of the base grid, along each axis
  std::vector<int> level;  ///< [nz][ny][nx]: halvings; -1: cell left out (solid)

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(cells[0]) +
           static_cast<std::size_t>(i);
  }
  Index3 position(std::size_t index) const;
  Vec3 centre(std::size_t index) const;  ///< [m]
  /// Edge of a base cell along an axis [m].
  double spacing(int axis) const {
    return box.size[axis] / cells[static_cast<std::size_t>(axis)];
  }
};

/// Raises levels until neighbours (across faces, edges and corners, periodic faces too)
/// differ by one at most.
void balance(OctreeLevels& levels);

/// A group of boundary faces: those of one face of the box, of the solid left out, or
/// those shared with another rank.
struct FacePatch {
  enum class Kind { box_face, solid, rank };
  Kind kind = Kind::box_face;
  int which = 0;  ///< the Face, or the other rank
  int start = 0;  ///< first face
  int size = 0;
};

/// One rank's part of the grid, as an unstructured mesh: faces in upper-triangular order
/// (internal ones by owner, then neighbour), then patch by patch; quads, each with its
/// normal out of its owner.  Both sides of a periodic pair, and both ranks of a shared
/// patch, list the faces in the same order.
struct OctreeMesh {
  std::vector<Vec3> points;               ///< [m]
  std::vector<std::array<int, 4>> faces;  ///< corners
  std::vector<int> owner;                 ///< cell of each face
  std::vector<int> neighbour;             ///< of the internal faces
  std::vector<FacePatch> patches;         ///< six of the box, the solid, then ranks
  std::vector<Vec3> centres;              ///< of the cells [m]
  std::vector<double> size;               ///< edge of each cell along x [m]
  std::vector<std::int64_t> global;       ///< number of each cell in the whole grid
  std::vector<int> first;  ///< this rank's first cell in each base cell, and their number
};

/// Base cells that come nearer to `x` than `reach` along every axis, images through
/// periodic faces too; in order.
std::vector<std::size_t> base_cells_around(const OctreeLevels& levels, const Vec3& x,
                                           double reach);

/// Cells of those base cells that this rank has; in order.
std::vector<int> cells_around(const OctreeLevels& levels, const OctreeMesh& mesh,
                              const Vec3& x, double reach);

/// Rank of every base cell: parts of about equal numbers of cells, cut across the axis
/// along which the grid is longest and not periodic; whole layers if another axis is
/// periodic.  InputError if no such axis is left for several ranks.
std::vector<int> partition(const OctreeLevels& levels, int ranks);

/// Number of cells of the whole grid, and of the first cell of every base cell.
std::vector<std::int64_t> first_cells(const OctreeLevels& levels);

OctreeMesh build_mesh(const OctreeLevels& levels, const std::vector<int>& rank_of,
                      int rank);

}  // namespace colloid
