#include "tiers/transient/transient_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "core/error.h"
#include "particles/surfaces.h"
#include "tiers/transient/foam_carried_pressure.h"
#include "tiers/transient/foam_grid.h"
#include "tiers/transient/foam_momentum.h"
#include "tiers/transient/foam_pressure.h"
#include "tiers/transient/immersed.h"
#include "tiers/transient/octree.h"
#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

using Foam::surfaceScalarField;
using Foam::volScalarField;
using Foam::volVectorField;

constexpr int kMostMomentumIterations = 200;
// Refined around a body, beyond its surface, in cells of the base grid; and what of it
// must be left before the grid is built anew.
constexpr double kRefined = 1.6;
constexpr double kRefinedAtLeast = 0.75;
// Solid cells kept inside grains, in cells: the surface needs its neighbours.
constexpr double kSolidDepth = 2.5;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

Foam::IOobject io(const char* name, const Foam::fvMesh& mesh) {
  return Foam::IOobject(name, mesh.time().timeName(), mesh, Foam::IOobject::NO_READ,
                        Foam::IOobject::NO_WRITE);
}

// The fields of one grid.
struct Fields {
  volVectorField velocity;
  volScalarField pressure;    // kinematic [m^2/s^2]
  volScalarField correction;  // of the pressure in the last step: the next begins with it
  surfaceScalarField flux;    // [m^3/s]

  Fields(const Foam::fvMesh& mesh, const Foam::wordList& velocity_types,
         const Foam::wordList& pressure_types)
      : velocity(io("U", mesh), mesh,
                 Foam::dimensionedVector("U", Foam::dimVelocity, Foam::Zero),
                 velocity_types),
        pressure(io("p", mesh), mesh,
                 Foam::dimensionedScalar("p", Foam::sqr(Foam::dimVelocity), 0.0),
                 pressure_types),
        correction(io("dp", mesh), mesh,
                   Foam::dimensionedScalar("dp", Foam::sqr(Foam::dimVelocity), 0.0),
                   pressure_types),
        flux(io("phi", mesh), Foam::fvc::flux(velocity)) {}
};

// Values in every cell of the whole grid, in its canonical order: how fields go from one
// grid to the next, and into a checkpoint.
struct CellValues {
  OctreeLevels levels;
  std::vector<double> values;  // [cell][u, v, w, p, then the gradient of each]
};
constexpr int kFieldsPerCell = 4;
constexpr int kValuesPerCell = kFieldsPerCell * 4;

}  // namespace

struct TransientFlow::Impl {
  Impl(const Scene& the_scene, const TransientFlowOptions& the_options)
      : scene(the_scene),
        options(the_options),
        viscosity(scene.fluid.viscosity / scene.fluid.density),
        time(make_time()) {
    require(!scene.drive.mean_velocity, "/drive/mean_velocity",
            "the tier transient does not hold a mean velocity; expected a body_force");
    levels.box = scene.geometry.box;
    levels.cells = options.cells;
    levels.level.assign(static_cast<std::size_t>(options.cells[0]) *
                            static_cast<std::size_t>(options.cells[1]) *
                            static_cast<std::size_t>(options.cells[2]),
                        0);
    // Until the first step, or a checkpoint, says where bodies are.
    refine_for({});
    build();
  }
  ~Impl() {
    fields.reset();
    mesh.reset();
  }

  // --- grid ---------------------------------------------------------------------------

  double base_size() const {
    return std::max({levels.spacing(0), levels.spacing(1), levels.spacing(2)});
  }

  // Calls f for every base cell within `reach` of the sphere along each axis, with the
  // distance of its centre from the surface, outside positive.
  template <class F>
  void for_base_cells(const Sphere& sphere, double reach, const F& f) const {
    for (const std::size_t cell :
         base_cells_around(levels, sphere.center, sphere.radius + reach)) {
      f(cell,
        norm(shortest(levels.box, levels.centre(cell), sphere.center)) - sphere.radius);
    }
  }

  // Whether every body is still inside its refined neighbourhood.
  bool refined_for(const std::vector<FlowBody>& bodies) const {
    bool fine = true;
    for (const FlowBody& body : bodies) {
      const double reach = kRefinedAtLeast * base_size();
      for_base_cells(body.sphere, reach, [&](std::size_t cell, double d) {
        if (d < reach && levels.level[cell] >= 0 &&
            levels.level[cell] < options.refinement) {
          fine = false;
        }
      });
    }
    return fine;
  }

  void refine_for(const std::vector<FlowBody>& bodies) {
    std::fill(levels.level.begin(), levels.level.end(), 0);
    const double h = base_size();
    const double half_diagonal = 0.5 * std::sqrt(3.0) * h;
    for (const Sphere& grain : scene.geometry.spheres) {
      for_base_cells(grain, h, [&](std::size_t cell, double d) {
        if (d < -half_diagonal - kSolidDepth * h) {
          levels.level[cell] = -1;
        } else if (std::abs(d) < half_diagonal + h && levels.level[cell] >= 0) {
          levels.level[cell] = std::max(levels.level[cell], options.wall_refinement);
        }
      });
    }
    for (const FlowBody& body : bodies) {
      const double reach = kRefined * h;
      for_base_cells(body.sphere, reach, [&](std::size_t cell, double d) {
        if (d < reach && levels.level[cell] >= 0) {
          levels.level[cell] = std::max(levels.level[cell], options.refinement);
        }
      });
    }
    balance(levels);
  }

  Foam::word velocity_type(int face) const {
    switch (scene.geometry.box.face(face)) {
      case FaceCondition::inlet:
        return scene.drive.pressure_drop ? "zeroGradient" : "fixedValue";
      case FaceCondition::outlet:
        return "zeroGradient";
      case FaceCondition::wall:
        return "fixedValue";
      case FaceCondition::periodic:
        return "cyclic";
      case FaceCondition::symmetry:
        return "slip";
    }
    return "";
  }
  Foam::word pressure_type(int face) const {
    const FaceCondition condition = scene.geometry.box.face(face);
    if (condition == FaceCondition::periodic) {
      return "cyclic";
    }
    const bool fixed = condition == FaceCondition::outlet ||
                       (condition == FaceCondition::inlet && scene.drive.pressure_drop);
    return fixed ? "fixedValue" : "zeroGradient";
  }

  // Velocity that the scene gives on a face of the box.
  Vec3 face_velocity(int face) const {
    Vec3 u;
    const FaceCondition condition = scene.geometry.box.face(face);
    if (condition == FaceCondition::inlet && scene.drive.inlet_velocity) {
      u[axis_of(face)] = (is_upper(face) ? -1.0 : 1.0) * *scene.drive.inlet_velocity;
    }
    if (face == z_plus && scene.drive.shear_rate) {
      u.x = *scene.drive.shear_rate * scene.geometry.box.size.z;
    }
    return u;
  }

  // From `levels`.
  void build() {
    fields.reset();
    mesh.reset();
    octree = build_mesh(levels, partition(levels, rank_count()), this_rank());
    mesh = make_foam_mesh(*time, levels, octree);
    Foam::wordList velocity_types(mesh->boundary().size(), "processor");
    Foam::wordList pressure_types(velocity_types);
    for (int face = 0; face < kFaces; ++face) {
      velocity_types[face] = velocity_type(face);
      pressure_types[face] = pressure_type(face);
    }
    velocity_types[kFaces] = "fixedValue";
    pressure_types[kFaces] = "zeroGradient";
    fields = std::make_unique<Fields>(*mesh, velocity_types, pressure_types);
    for (int face = 0; face < kFaces; ++face) {
      if (velocity_types[face] == "fixedValue") {
        fields->velocity.boundaryFieldRef()[face] == foam(face_velocity(face));
      }
      if (scene.drive.pressure_drop &&
          scene.geometry.box.face(face) == FaceCondition::inlet) {
        fields->pressure.boundaryFieldRef()[face] ==
            *scene.drive.pressure_drop / scene.fluid.density;
      }
    }
    fields->flux = Foam::fvc::flux(fields->velocity);
    fixed_known = false;
    counts.cells = static_cast<long>(first_cells(levels).back());
    ++counts.grids;
  }

  CellValues cell_values() const {
    CellValues out;
    out.levels = levels;
    const Foam::volTensorField gradient(Foam::fvc::grad(fields->velocity));
    const Foam::volVectorField pressure_gradient(Foam::fvc::grad(fields->pressure));
    std::vector<double> own;
    own.reserve(octree.centres.size() * kValuesPerCell);
    for (int cell = 0; cell < static_cast<int>(octree.centres.size()); ++cell) {
      const Foam::vector& u = fields->velocity[cell];
      const Foam::tensor& g = gradient[cell];  // d_i u_j
      const Foam::vector& gp = pressure_gradient[cell];
      own.insert(own.end(), {u.x(), u.y(), u.z(), fields->pressure[cell]});
      own.insert(own.end(), {g.xx(), g.yx(), g.zx(), g.xy(), g.yy(), g.zy(), g.xz(),
                             g.yz(), g.zz(), gp.x(), gp.y(), gp.z()});
    }
    const std::vector<double> all = gather_all(own);
    const std::vector<std::int64_t> numbers = gather_all(octree.global);
    out.values.resize(all.size());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      std::copy_n(
          all.begin() + static_cast<std::ptrdiff_t>(n * kValuesPerCell), kValuesPerCell,
          out.values.begin() + static_cast<std::ptrdiff_t>(numbers[n]) * kValuesPerCell);
    }
    return out;
  }

  // Fields of this grid from those of another: linear where it is finer, means where it
  // is coarser, the same numbers elsewhere.
  void map(const CellValues& old) {
    const std::vector<std::int64_t> old_first = first_cells(old.levels);
    const std::vector<std::int64_t> first = first_cells(levels);
    const auto base_of = [&](std::int64_t global) {
      return static_cast<std::size_t>(
          std::upper_bound(first.begin(), first.end(), global) - first.begin() - 1);
    };
    for (int cell = 0; cell < static_cast<int>(octree.centres.size()); ++cell) {
      const std::size_t base = base_of(octree.global[at(cell)]);
      const int level = levels.level[base];
      const int old_level = old.levels.level[base];
      const auto child = static_cast<int>(octree.global[at(cell)] - first[base]);
      std::array<double, kFieldsPerCell> value{};
      if (old_level >= 0) {
        value = mapped(old, old_first[base], level, old_level, child);
      }
      fields->velocity.primitiveFieldRef()[cell] =
          Foam::vector(value[0], value[1], value[2]);
      fields->pressure.primitiveFieldRef()[cell] = value[3];
    }
    fields->velocity.correctBoundaryConditions();
    fields->pressure.correctBoundaryConditions();
    fields->flux = Foam::fvc::flux(fields->velocity);
  }

  std::array<double, kFieldsPerCell> mapped(const CellValues& old, std::int64_t old_first,
                                            int level, int old_level, int child) const {
    std::array<double, kFieldsPerCell> value{};
    const int n = 1 << level;
    const std::array<int, 3> c{child % n, child / n % n, child / (n * n)};
    const auto source = [&](const std::array<int, 3>& o) {
      const int m = 1 << old_level;
      return &old.values[static_cast<std::size_t>(
          (old_first + (static_cast<std::int64_t>(o[2]) * m + o[1]) * m + o[0]) *
          kValuesPerCell)];
    };
    if (old_level >= level) {
      const int ratio = 1 << (old_level - level);
      for (int k = 0; k < ratio; ++k) {
        for (int j = 0; j < ratio; ++j) {
          for (int i = 0; i < ratio; ++i) {
            const double* v =
                source({c[0] * ratio + i, c[1] * ratio + j, c[2] * ratio + k});
            for (std::size_t f = 0; f < kFieldsPerCell; ++f) {
              value[f] += v[f] / (ratio * ratio * ratio);
            }
          }
        }
      }
      return value;
    }
    const int ratio = 1 << (level - old_level);
    const double* v = source({c[0] / ratio, c[1] / ratio, c[2] / ratio});
    for (std::size_t f = 0; f < kFieldsPerCell; ++f) {
      value[f] = v[f];
      for (int axis = 0; axis < 3; ++axis) {
        const double offset = ((c[at(axis)] % ratio + 0.5) / ratio - 0.5) *
                              levels.spacing(axis) / (1 << old_level);
        value[f] += v[kFieldsPerCell + 3 * f + static_cast<std::size_t>(axis)] * offset;
      }
    }
    return value;
  }

  void adapt(const std::vector<FlowBody>& bodies) {
    if (refined_for(bodies)) {
      return;
    }
    const CellValues old = cell_values();
    refine_for(bodies);
    build();
    map(old);
    project(bodies);
  }

  // Makes the flux of a mapped field free of divergence.
  void project(const std::vector<FlowBody>& bodies) {
    constexpr double kAnyStep = 1.0;  // the corrected flux does not depend on it
    const std::vector<ImmersedEntry> entries = immersed(bodies, kAnyStep);
    std::vector<MomentumBody> held(spheres.size());
    PressureCorrection correction(*mesh, levels.box, spheres, entries, held, kAnyStep);
    volScalarField& dp = fields->correction;
    const SolveReport report =
        correction.solve(dp, fields->flux, options.pressure_tolerance);
    counts.pressure_iterations += report.iterations;
    dp.primitiveFieldRef() = 0.0;  // that of no step
  }

  // --- one step -----------------------------------------------------------------------

  // Entries of grains first, then of bodies; `spheres` has the same order.
  std::vector<ImmersedEntry> immersed(const std::vector<FlowBody>& bodies, double dt) {
    const std::size_t grains = scene.geometry.spheres.size();
    if (!fixed_known) {
      fixed_entries =
          immerse(levels, octree, scene.geometry.spheres, viscosity, options.rigidity);
      fixed_known = true;
    }
    spheres = scene.geometry.spheres;
    std::vector<Sphere> moving;
    for (const FlowBody& body : bodies) {
      moving.push_back(body.sphere);
      spheres.push_back(body.sphere);
    }
    std::vector<ImmersedEntry> entries = fixed_entries;
    for (ImmersedEntry entry :
         immerse(levels, octree, moving, viscosity, options.rigidity)) {
      entry.body += static_cast<int>(grains);
      entries.push_back(entry);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (bodies[b].free || norm(bodies[b].velocity) + norm(bodies[b].spin) > 0.0) {
        open_narrow_gaps(levels, octree, static_cast<int>(grains + b), spheres, viscosity,
                         entries);
      }
    }
    for (ImmersedEntry& entry : entries) {
      entry.strength += entry.solid ? options.rigidity / dt : 0.0;
    }
    return entries;
  }

  std::vector<MomentumBody> momentum_bodies(const std::vector<FlowBody>& bodies,
                                            double dt) const {
    const double density = scene.fluid.density;
    std::vector<MomentumBody> out(scene.geometry.spheres.size());
    for (const FlowBody& body : bodies) {
      MomentumBody m;
      m.free = body.free;
      m.motion << body.velocity.x, body.velocity.y, body.velocity.z, body.spin.x,
          body.spin.y, body.spin.z;
      if (body.free) {
        const double a = body.sphere.radius;
        const double displaced = 4.0 / 3.0 * Foam::constant::mathematical::pi * a * a * a;
        m.whole_inertia = sphere_inertia(body.mass / density / dt, a);
        m.inertia = m.whole_inertia - sphere_inertia(displaced / dt, a);
        Six load;
        load << body.force.x, body.force.y, body.force.z, body.torque.x, body.torque.y,
            body.torque.z;
        m.source = m.inertia * m.motion + load / density;
      }
      out.push_back(m);
    }
    return out;
  }

  std::vector<FlowResponse> step(double dt, const std::vector<FlowBody>& bodies) {
    adapt(bodies);
    time->setDeltaT(dt, false);
    ++*time;
    const std::vector<ImmersedEntry> entries = immersed(bodies, dt);
    std::vector<MomentumBody> moved = momentum_bodies(bodies, dt);
    fields->velocity.storeOldTime();
    carried.carry(levels, octree, {spheres.begin() + grain_count(), spheres.end()},
                  cell_at_bodies(), fields->pressure);
    std::vector<Six> reaction;
    for (int outer = 0; outer < options.outer_iterations; ++outer) {
      if (outer > 0) {
        fields->correction.primitiveFieldRef() = 0.0;
      }
      reaction = iterate(dt, entries, moved);
    }
    ++counts.steps;
    check_finite();
    return responses(dt, bodies, moved, entries, reaction);
  }

  // One pass of momentum and pressure; what held bodies back, kinematic, per body.
  std::vector<Six> iterate(double dt, const std::vector<ImmersedEntry>& entries,
                           std::vector<MomentumBody>& bodies) {
    volVectorField& u = fields->velocity;
    volScalarField& p = fields->pressure;
    surfaceScalarField& phi = fields->flux;
    const Foam::dimensionedScalar nu("nu", Foam::dimViscosity, viscosity);
    // 1. Momentum with the old pressure.
    Foam::fvVectorMatrix momentum(Foam::fvm::ddt(u) + Foam::fvm::div(phi, u) -
                                  Foam::fvm::laplacian(nu, u));
    volScalarField inverse_diagonal(io("rA", *mesh), *mesh,
                                    Foam::dimensionedScalar("r", Foam::dimTime, 0.0));
    find_inverse_diagonal(momentum, entries, inverse_diagonal);
    const volVectorField pressure_gradient(Foam::fvc::grad(p));
    momentum.source() -= mesh->V() * pressure_gradient.primitiveField();
    if (scene.drive.body_force) {
      momentum.source() +=
          mesh->V() * foam(*scene.drive.body_force * (1.0 / scene.fluid.density));
    }
    const SolveReport solved = solve_momentum(
        momentum, entries, bodies, options.momentum_tolerance, kMostMomentumIterations);
    counts.momentum_iterations += solved.iterations;
    require_converged(solved, "momentum");
    std::vector<Six> reaction = entry_reaction(entries, bodies);
    begin_face_forces();
    // 2. Fluxes; the difference of the two gradients keeps the pressure of neighbouring
    // cells together (Rhie & Chow 1983).
    phi = Foam::fvc::flux(u) +
          Foam::fvc::interpolate(inverse_diagonal) *
              ((Foam::fvc::interpolate(pressure_gradient) & mesh->Sf()) -
               Foam::fvc::snGrad(p) * mesh->magSf());
    const volScalarField divergence(Foam::fvc::div(phi));
    // 3. Pressure correction.
    PressureCorrection correction(*mesh, levels.box, spheres, entries, bodies, dt);
    volScalarField& dp = fields->correction;
    const SolveReport projected = correction.solve(dp, phi, options.pressure_tolerance);
    counts.pressure_iterations += projected.iterations;
    require_converged(projected, "pressure");
    const volVectorField correction_gradient(Foam::fvc::grad(dp));
    correction.correct(dp, correction_gradient, u, bodies);
    add_reaction(dt, correction_gradient, entries, bodies, reaction);
    finish_face_forces(dp);
    // 4. Cahouet & Chabard (1988): the Laplacian alone answers inertia, the divergence
    // itself viscosity.
    p += dp;
    Foam::scalarField& pi = p.primitiveFieldRef();
    forAll(pi, cell) {
      pi[cell] -= kViscousShare * viscosity * divergence[cell];
    }
    p.correctBoundaryConditions();
    return reaction;
  }

  void find_inverse_diagonal(const Foam::fvVectorMatrix& momentum,
                             const std::vector<ImmersedEntry>& entries,
                             volScalarField& inverse) const {
    Foam::scalarField a(momentum.A()().primitiveField());
    for (const ImmersedEntry& entry : entries) {
      a[entry.cell] += entry.strength;
    }
    inverse.primitiveFieldRef() = 1.0 / a;
    inverse.correctBoundaryConditions();
  }

  std::vector<Six> entry_reaction(const std::vector<ImmersedEntry>& entries,
                                  const std::vector<MomentumBody>& bodies) const {
    std::vector<Six> sums(bodies.size(), Six::Zero());
    for (const ImmersedEntry& entry : entries) {
      const Vec3 slip = vec3(fields->velocity[entry.cell]) -
                        rigid_velocity(bodies[at(entry.body)].motion, entry.arm);
      sums[at(entry.body)] +=
          wrench(slip * (entry.strength * mesh->V()[entry.cell]), entry.arm);
    }
    sum_over_ranks(sums.empty() ? nullptr : sums.front().data(), 6 * sums.size());
    return sums;
  }

  // What the outside does to the liquid through each face of the box, and through those
  // of cells left out inside grains: friction, and momentum that flows in, both as in the
  // momentum equation; then the pressure that makes the velocity free of divergence.  So
  // the momentum of the whole is balanced in every step, not only in steady flow.
  void begin_face_forces() {
    const volVectorField& u = fields->velocity;
    for (int face = 0; face <= kFaces; ++face) {
      const Foam::fvPatch& patch = mesh->boundary()[face];
      face_forces[at(face)] = {};
      if (!patch.coupled()) {
        const Foam::vectorField traction(
            viscosity * u.boundaryField()[face].snGrad() * patch.magSf() -
            fields->flux.boundaryField()[face] * u.boundaryField()[face]);
        face_forces[at(face)] = vec3(Foam::sum(traction));
      }
    }
  }
  void finish_face_forces(const volScalarField& dp) {
    for (int face = 0; face <= kFaces; ++face) {
      const Foam::fvPatch& patch = mesh->boundary()[face];
      if (!patch.coupled()) {
        const Foam::vectorField traction(
            (fields->pressure.boundaryField()[face] + dp.boundaryField()[face]) *
            patch.Sf());
        face_forces[at(face)] -= vec3(Foam::sum(traction));
      }
    }
  }

  // What the pressure correction asks of driven bodies.
  void add_reaction(double dt, const volVectorField& gradient,
                    const std::vector<ImmersedEntry>& entries,
                    const std::vector<MomentumBody>& bodies,
                    std::vector<Six>& reaction) const {
    std::vector<Six> sums(bodies.size(), Six::Zero());
    for (const ImmersedEntry& entry : entries) {
      if (entry.solid && !bodies[at(entry.body)].free) {
        const double beta = entry.strength / (1.0 / dt + entry.strength);
        sums[at(entry.body)] -= wrench(
            vec3(gradient[entry.cell]) * (beta * mesh->V()[entry.cell]), entry.arm);
      }
    }
    sum_over_ranks(sums.empty() ? nullptr : sums.front().data(), 6 * sums.size());
    for (std::size_t b = 0; b < sums.size(); ++b) {
      reaction[b] += sums[b];
    }
  }

  std::vector<FlowResponse> responses(double dt, const std::vector<FlowBody>& bodies,
                                      const std::vector<MomentumBody>& moved,
                                      const std::vector<ImmersedEntry>& entries,
                                      const std::vector<Six>& reaction) {
    const std::size_t grains = scene.geometry.spheres.size();
    const double density = scene.fluid.density;
    // Of the liquid inside a driven body: it takes up momentum too.
    std::vector<Six> inside(moved.size(), Six::Zero());
    const volVectorField& u = fields->velocity;
    const volVectorField& old = u.oldTime();
    for (const ImmersedEntry& entry : entries) {
      if (entry.solid) {
        inside[at(entry.body)] +=
            wrench(vec3(u[entry.cell] - old[entry.cell]) * (mesh->V()[entry.cell] / dt),
                   entry.arm);
      }
    }
    sum_over_ranks(inside.empty() ? nullptr : inside.front().data(), 6 * inside.size());
    std::vector<FlowResponse> out;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const Six& q = moved[grains + b].motion;
      Six load;
      if (bodies[b].free) {
        Six before;
        before << bodies[b].velocity.x, bodies[b].velocity.y, bodies[b].velocity.z,
            bodies[b].spin.x, bodies[b].spin.y, bodies[b].spin.z;
        Six external;
        external << bodies[b].force.x, bodies[b].force.y, bodies[b].force.z,
            bodies[b].torque.x, bodies[b].torque.y, bodies[b].torque.z;
        load = density * (moved[grains + b].whole_inertia * (q - before)) - external;
      } else {
        load = density * (reaction[grains + b] + inside[grains + b]);
      }
      out.push_back({{q[0], q[1], q[2]},
                     {q[3], q[4], q[5]},
                     {load[0], load[1], load[2]},
                     {load[3], load[4], load[5]}});
    }
    finish_forces(dt, entries, moved);
    for (std::size_t b = 0; b < grains; ++b) {
      const Six load = density * (reaction[b] + inside[b]);
      grain_force += {load[0], load[1], load[2]};
    }
    return out;
  }

  // Sums over ranks, in newtons: of the faces, of inertia, and what the liquid kept
  // inside grains does to the part of them that is left out, with the body force on that
  // part.
  void finish_forces(double dt, const std::vector<ImmersedEntry>& entries,
                     const std::vector<MomentumBody>& bodies) {
    const volVectorField& u = fields->velocity;
    const volVectorField& old = u.oldTime();
    const Foam::scalarField& volume = mesh->V();
    liquid_inertia = vec3(Foam::sum(
        Foam::vectorField((u.primitiveField() - old.primitiveField()) * volume)));
    for (const ImmersedEntry& entry : entries) {
      if (entry.solid && !bodies[at(entry.body)].free) {
        liquid_inertia -= vec3(u[entry.cell] - old[entry.cell]) * volume[entry.cell];
      }
    }
    std::vector<double> sums{Foam::sum(volume)};
    const auto add = [&](const Vec3& v) { sums.insert(sums.end(), {v.x, v.y, v.z}); };
    add(liquid_inertia * (1.0 / dt));
    std::for_each(face_forces.begin(), face_forces.end(), add);
    sum_over_ranks(sums.data(), sums.size());
    const auto sum = [&](std::size_t n) {
      return scene.fluid.density *
             Vec3{sums[3 * n + 1], sums[3 * n + 2], sums[3 * n + 3]};
    };
    liquid_inertia = sum(0);
    for (std::size_t n = 0; n < face_forces.size(); ++n) {
      face_forces[n] = sum(n + 1);
    }
    const Vec3& size = levels.box.size;
    const double left_out = size.x * size.y * size.z - sums[0];
    grain_force =
        left_out * scene.drive.body_force.value_or(Vec3{}) - face_forces[kFaces];
  }

  static void require_converged(const SolveReport& report, const char* what) {
    if (!std::isfinite(report.final)) {
      throw ConvergenceError(
          fmt::format("transient flow: the {} became infinite after {} iterations", what,
                      report.iterations));
    }
  }

  // The named place where a run that went wrong is stopped.
  void check_finite() const {
    double largest = 0.0;
    for (const Foam::vector& v : fields->velocity.primitiveField()) {
      const double speed = Foam::mag(v);
      largest = std::isfinite(speed) ? std::max(largest, speed)
                                     : std::numeric_limits<double>::infinity();
    }
    if (!std::isfinite(largest_over_ranks(largest))) {
      throw ConvergenceError(fmt::format(
          "transient flow: unstable, a velocity is infinite in step {}", counts.steps));
    }
  }

  // A plug flow that meets a wall has a pressure that is singular in the corner; it is
  // taken a quarter of the face's width away from walls (as MODEL (F4)).
  bool in_core(int face, const Vec3& x) const {
    const Box& box = levels.box;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == axis_of(face)) {
        continue;
      }
      const double from_low = x[axis] / box.size[axis];
      if ((box.face(2 * axis) == FaceCondition::wall && from_low < 0.25) ||
          (box.face(2 * axis + 1) == FaceCondition::wall && from_low > 0.75)) {
        return false;
      }
    }
    return true;
  }

  double courant_time() const {
    const Foam::scalarField sums(
        Foam::fvc::surfaceSum(Foam::mag(fields->flux))().primitiveField());
    double largest = 0.0;
    forAll(sums, cell) {
      largest = std::max(largest, 0.5 * sums[cell] / mesh->V()[cell]);
    }
    largest = largest_over_ranks(largest);
    return largest > 0.0 ? 1.0 / largest : std::numeric_limits<double>::infinity();
  }

  double cell_at_bodies() const {
    return std::min({levels.spacing(0), levels.spacing(1), levels.spacing(2)}) /
           (1 << options.refinement);
  }

  std::ptrdiff_t grain_count() const {
    return static_cast<std::ptrdiff_t>(scene.geometry.spheres.size());
  }

  // Below the point where it would overshoot at the shortest waves (F: the flux is damped
  // there by the momentum diagonal).
  static constexpr double kViscousShare = 0.8;

  const Scene& scene;
  TransientFlowOptions options;
  double viscosity;  // kinematic [m^2/s]
  std::unique_ptr<Foam::Time> time;
  OctreeLevels levels;
  OctreeMesh octree;
  std::unique_ptr<Foam::fvMesh> mesh;
  std::unique_ptr<Fields> fields;
  bool fixed_known = false;
  std::vector<ImmersedEntry> fixed_entries;  // of this grid
  std::vector<Sphere> spheres;               // grains and bodies of this step
  CarriedPressure carried;
  Vec3 grain_force;
  Vec3 liquid_inertia;
  std::array<Vec3, kFaces + 1> face_forces{};
  TransientFlowCounts counts;
};

TransientFlow::TransientFlow(const Scene& scene, const TransientFlowOptions& options)
    : impl_(std::make_unique<Impl>(scene, options)) {}

TransientFlow::~TransientFlow() = default;

std::vector<FlowResponse> TransientFlow::step(double dt,
                                              const std::vector<FlowBody>& bodies) {
  return impl_->step(dt, bodies);
}

int TransientFlow::settle(double dt, double change, int steps,
                          const std::vector<FlowBody>& bodies) {
  for (int n = 1; n <= steps; ++n) {
    impl_->step(dt, bodies);
    const Foam::vectorField& u = impl_->fields->velocity.primitiveField();
    const Foam::vectorField& old = impl_->fields->velocity.oldTime().primitiveField();
    const double most = Foam::gMax(Foam::mag(u)());
    if (Foam::gMax(Foam::mag(u - old)()) < change * most) {
      return n;
    }
  }
  return steps;
}

double TransientFlow::courant_time() const {
  return impl_->courant_time();
}

const TransientFlowCounts& TransientFlow::counts() const {
  return impl_->counts;
}

double TransientFlow::pressure_drop() const {
  double sums[4] = {};  // inlet p A, A; outlet
  for (int face = 0; face < kFaces; ++face) {
    const FaceCondition condition = impl_->scene.geometry.box.face(face);
    if (condition != FaceCondition::inlet && condition != FaceCondition::outlet) {
      continue;
    }
    const int side = condition == FaceCondition::inlet ? 0 : 2;
    const Foam::fvPatch& patch = impl_->mesh->boundary()[face];
    forAll(patch, i) {
      if (impl_->in_core(face, vec3(patch.Cf()[i]))) {
        sums[side] += impl_->fields->pressure.boundaryField()[face][i] * patch.magSf()[i];
        sums[side + 1] += patch.magSf()[i];
      }
    }
  }
  sum_over_ranks(sums, 4);
  return impl_->scene.fluid.density * (sums[0] / sums[1] - sums[2] / sums[3]);
}

double TransientFlow::flow_rate() const {
  double rate = 0.0;
  for (int face = 0; face < kFaces; ++face) {
    if (impl_->scene.geometry.box.face(face) == FaceCondition::inlet) {
      rate -= Foam::sum(impl_->fields->flux.boundaryField()[face]);
    }
  }
  sum_over_ranks(&rate, 1);
  return rate;
}

Vec3 TransientFlow::mean_velocity() const {
  Foam::vector sum(Foam::Zero);
  const Foam::vectorField& u = impl_->fields->velocity.primitiveField();
  forAll(u, cell) {
    sum += u[cell] * impl_->mesh->V()[cell];
  }
  double sums[3] = {sum.x(), sum.y(), sum.z()};
  sum_over_ranks(sums, 3);
  const Vec3& size = impl_->levels.box.size;
  return Vec3{sums[0], sums[1], sums[2]} * (1.0 / (size.x * size.y * size.z));
}

Vec3 TransientFlow::grain_force() const {
  return impl_->grain_force;
}

Vec3 TransientFlow::face_force(int face) const {
  return impl_->face_forces[at(face)];
}

Vec3 TransientFlow::liquid_inertia() const {
  return impl_->liquid_inertia;
}

Vec3 TransientFlow::velocity_at(const Vec3& x) const {
  const Impl& impl = *impl_;
  double found[4] = {};
  for (std::size_t cell = 0; cell < impl.octree.centres.size(); ++cell) {
    const Vec3 d = x - impl.octree.centres[cell];
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double half = 0.5 * impl.octree.size[cell] * impl.levels.spacing(axis) /
                          impl.levels.spacing(0);
      inside = inside && -half <= d[axis] && d[axis] < half;
    }
    if (inside) {
      const Foam::vector& u = impl.fields->velocity[static_cast<int>(cell)];
      const double value[4] = {u.x(), u.y(), u.z(), 1.0};
      std::copy(value, value + 4, found);
      break;
    }
  }
  sum_over_ranks(found, 4);
  return found[3] > 0.0 ? Vec3{found[0], found[1], found[2]} * (1.0 / found[3]) : Vec3{};
}

void TransientFlow::save(
    std::map<std::string, std::vector<double>>& reals,
    std::map<std::string, std::vector<std::int64_t>>& integers) const {
  const Impl& impl = *impl_;
  const Fields& fields = *impl.fields;
  std::vector<double> cells;
  for (int cell = 0; cell < fields.velocity.size(); ++cell) {
    const Foam::vector& u = fields.velocity[cell];
    cells.insert(cells.end(), {u.x(), u.y(), u.z(), fields.pressure[cell]});
  }
  std::vector<double> flux(fields.flux.primitiveField().begin(),
                           fields.flux.primitiveField().end());
  forAll(fields.flux.boundaryField(), patch) {
    const Foam::scalarField& values = fields.flux.boundaryField()[patch];
    flux.insert(flux.end(), values.begin(), values.end());
  }
  reals["flow_cells"] = gather_all(cells);
  reals["flow_flux"] = gather_all(flux);
  reals["flow_correction"] =
      gather_all(std::vector<double>(fields.correction.primitiveField().begin(),
                                     fields.correction.primitiveField().end()));
  std::vector<double>& bodies = reals["flow_bodies"];
  for (const Sphere& body : impl.carried.bodies()) {
    bodies.insert(bodies.end(),
                  {body.center.x, body.center.y, body.center.z, body.radius});
  }
  integers["flow_levels"].assign(impl.levels.level.begin(), impl.levels.level.end());
  const TransientFlowCounts& c = impl.counts;
  integers["flow_counts"] = {rank_count(), c.steps, c.grids, c.momentum_iterations,
                             c.pressure_iterations};
}

void TransientFlow::restore(
    const std::map<std::string, std::vector<double>>& reals,
    const std::map<std::string, std::vector<std::int64_t>>& integers) {
  Impl& impl = *impl_;
  const std::vector<std::int64_t>& counts = integers.at("flow_counts");
  require(
      counts[0] == rank_count(), "--checkpoint",
      fmt::format("was written by {} ranks; expected to go on with as many", counts[0]));
  const std::vector<std::int64_t>& levels = integers.at("flow_levels");
  std::copy(levels.begin(), levels.end(), impl.levels.level.begin());
  impl.build();
  Fields& fields = *impl.fields;
  // The ranks' parts are one after the other.
  const auto before = [](std::size_t own) {
    const std::vector<std::int64_t> sizes =
        gather_all(std::vector<std::int64_t>{static_cast<std::int64_t>(own)});
    return std::accumulate(sizes.begin(), sizes.begin() + this_rank(), std::int64_t{0});
  };
  const double* cell = reals.at("flow_cells").data() +
                       before(4 * static_cast<std::size_t>(fields.velocity.size()));
  for (int i = 0; i < fields.velocity.size(); ++i, cell += 4) {
    fields.velocity.primitiveFieldRef()[i] = Foam::vector(cell[0], cell[1], cell[2]);
    fields.pressure.primitiveFieldRef()[i] = cell[3];
  }
  fields.velocity.correctBoundaryConditions();
  fields.pressure.correctBoundaryConditions();
  const double* correction = reals.at("flow_correction").data() +
                             before(static_cast<std::size_t>(fields.velocity.size()));
  for (double& value : fields.correction.primitiveFieldRef()) {
    value = *correction++;
  }
  const double* flux = reals.at("flow_flux").data() +
                       before(static_cast<std::size_t>(impl.mesh->nFaces()));
  for (double& value : fields.flux.primitiveFieldRef()) {
    value = *flux++;
  }
  forAll(fields.flux.boundaryField(), patch) {
    for (double& value : fields.flux.boundaryFieldRef()[patch]) {
      value = *flux++;
    }
  }
  const std::vector<double>& bodies = reals.at("flow_bodies");
  std::vector<Sphere> last;
  for (std::size_t b = 0; b < bodies.size(); b += 4) {
    last.push_back({{bodies[b], bodies[b + 1], bodies[b + 2]}, bodies[b + 3]});
  }
  impl.carried.restore(std::move(last));
  impl.counts.steps = static_cast<long>(counts[1]);
  impl.counts.grids = static_cast<long>(counts[2]);
  impl.counts.momentum_iterations = static_cast<long>(counts[3]);
  impl.counts.pressure_iterations = static_cast<long>(counts[4]);
}

double TransientFlow::cell_at_bodies() const {
  return impl_->cell_at_bodies();
}

}  // namespace colloid
