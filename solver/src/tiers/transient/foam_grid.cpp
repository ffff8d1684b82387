#include "tiers/transient/foam_grid.h"

#include "pairGAMGAgglomeration.H"

namespace colloid {

namespace {

// Both read from a dictionary only in private; explicit instantiation may name them.
template <class Tag, typename Tag::type Member>
struct Access {
  friend typename Tag::type member(Tag) { return Member; }
};
struct SchemesRead {
  using type = void (Foam::fvSchemes::*)(const Foam::dictionary&);
  friend type member(SchemesRead);
};
struct SolutionRead {
  using type = void (Foam::solution::*)(const Foam::dictionary&);
  friend type member(SolutionRead);
};
template struct Access<SchemesRead, &Foam::fvSchemes::read>;
template struct Access<SolutionRead, &Foam::solution::read>;

// Multigrid pairs cells forwards and backwards in turn, and remembers the turn from one
// mesh to the next: a continued run would pair them otherwise.
struct PairingDirection {
  using type = bool*;
  friend type member(PairingDirection);
};
template struct Access<PairingDirection, &Foam::pairGAMGAgglomeration::forward_>;

Foam::dictionary parse(const char* text) {
  Foam::IStringStream stream{Foam::string(text)};
  return Foam::dictionary(stream);
}

// The pressure correction does without the term for faces between levels: its flux is
// free of divergence all the same.
constexpr const char* kSchemes = R"(
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; laplacian(rate,dp) Gauss linear uncorrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
)";

// The preconditioner of the pressure: one V-cycle of algebraic multigrid.
constexpr const char* kSolution = R"(
solvers
{
  p
  {
    solver rigidPCG;
    preconditioner
    {
      preconditioner GAMG; smoother GaussSeidel; nCellsInCoarsestLevel 50;
      tolerance 1e-10; relTol 0.1; nVcycles 1; cacheAgglomeration true;
    }
    relTol 1e-3; maxIter 200;
  }
}
)";

void set_dictionaries(Foam::fvMesh& mesh) {
  const Foam::dictionary schemes = parse(kSchemes);
  const Foam::dictionary solution = parse(kSolution);
  auto& mesh_schemes = static_cast<Foam::fvSchemes&>(mesh);
  auto& mesh_solution = static_cast<Foam::fvSolution&>(mesh);
  static_cast<Foam::dictionary&>(mesh_schemes) = schemes;
  static_cast<Foam::dictionary&>(mesh_solution) = solution;
  (mesh_schemes.*member(SchemesRead()))(schemes);
  (static_cast<Foam::solution&>(mesh_solution).*member(SolutionRead()))(solution);
  mesh.setFluxRequired("dp");
}

Foam::word box_face_name(int face) {
  constexpr const char* kNames[] = {"xMinus", "xPlus",  "yMinus",
                                    "yPlus",  "zMinus", "zPlus"};
  return kNames[face];
}

Foam::polyPatch* make_patch(const FacePatch& patch, int index, const OctreeLevels& levels,
                            const Foam::polyBoundaryMesh& boundary) {
  if (patch.kind == FacePatch::Kind::rank) {
    return new Foam::processorPolyPatch(patch.size, patch.start, index, boundary,
                                        Foam::Pstream::myProcNo(), patch.which);
  }
  if (patch.kind == FacePatch::Kind::solid) {
    return Foam::polyPatch::New("wall", "solid", patch.size, patch.start, index, boundary)
        .ptr();
  }
  const Foam::word name = box_face_name(patch.which);
  if (levels.box.face(patch.which) == FaceCondition::periodic) {
    const int axis = axis_of(patch.which);
    Vec3 separation;
    separation[axis] = (is_upper(patch.which) ? -1.0 : 1.0) * levels.box.size[axis];
    return new Foam::cyclicPolyPatch(
        name, patch.size, patch.start, index, boundary, box_face_name(patch.which ^ 1),
        Foam::coupledPolyPatch::TRANSLATIONAL, Foam::Zero, Foam::Zero, foam(separation));
  }
  const bool wall = levels.box.face(patch.which) == FaceCondition::wall;
  return Foam::polyPatch::New(wall ? "wall" : "patch", name, patch.size, patch.start,
                              index, boundary)
      .ptr();
}

}  // namespace

std::unique_ptr<Foam::Time> make_time() {
  Foam::messageStream::level = 0;
  Foam::FatalError.throwExceptions();
  Foam::FatalIOError.throwExceptions();
  Foam::dictionary control;
  control.add("startFrom", Foam::word("startTime"));
  control.add("startTime", 0.0);
  control.add("stopAt", Foam::word("endTime"));
  control.add("endTime", 1e30);
  control.add("deltaT", 1.0);
  control.add("writeControl", Foam::word("timeStep"));
  control.add("writeInterval", 1000000000);
  control.add("runTimeModifiable", false);
  return std::make_unique<Foam::Time>(control, Foam::fileName("/nonexistent"),
                                      Foam::fileName("case"), "system", "constant", false,
                                      false);
}

std::unique_ptr<Foam::fvMesh> make_foam_mesh(const Foam::Time& time,
                                             const OctreeLevels& levels,
                                             const OctreeMesh& octree) {
  Foam::pointField points(static_cast<Foam::label>(octree.points.size()));
  for (std::size_t i = 0; i < octree.points.size(); ++i) {
    points[static_cast<Foam::label>(i)] = foam(octree.points[i]);
  }
  Foam::faceList faces(static_cast<Foam::label>(octree.faces.size()));
  for (std::size_t i = 0; i < octree.faces.size(); ++i) {
    Foam::face face(4);
    for (int c = 0; c < 4; ++c) {
      face[c] = octree.faces[i][static_cast<std::size_t>(c)];
    }
    faces[static_cast<Foam::label>(i)] = std::move(face);
  }
  Foam::labelList owner(static_cast<Foam::label>(octree.owner.size()));
  std::copy(octree.owner.begin(), octree.owner.end(), owner.begin());
  Foam::labelList neighbour(static_cast<Foam::label>(octree.neighbour.size()));
  std::copy(octree.neighbour.begin(), octree.neighbour.end(), neighbour.begin());

  auto mesh = std::make_unique<Foam::fvMesh>(
      Foam::IOobject(Foam::polyMesh::defaultRegion, time.constant(), time,
                     Foam::IOobject::NO_READ, Foam::IOobject::NO_WRITE),
      std::move(points), std::move(faces), std::move(owner), std::move(neighbour), true);
  Foam::List<Foam::polyPatch*> patches(static_cast<Foam::label>(octree.patches.size()));
  for (std::size_t i = 0; i < octree.patches.size(); ++i) {
    patches[static_cast<Foam::label>(i)] =
        make_patch(octree.patches[i], static_cast<int>(i), levels, mesh->boundaryMesh());
  }
  mesh->addFvPatches(patches, true);
  *member(PairingDirection()) = true;
  set_dictionaries(*mesh);
  return mesh;
}

}  // namespace colloid
