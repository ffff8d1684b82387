// Drag of a simple-cubic array of spheres with Palabos (lattice Boltzmann, D3Q19).
//
//     sphere_array <wall> <collision> <tau> <c> <L> [options]
//
//   wall       bounce_back   staircase sphere, half-way bounce-back
//              guo           curved wall, Palabos' GuoOffLatticeModel3D
//   collision  bgk           Palabos' GuoExternalForceBGKdynamics (as shipped)
//              trt           two relaxation times with Guo's force (below), Lambda = 3/16
//   tau        relaxation time of the stress [time steps]; nu = (tau - 1/2)/3
//   c          solid volume fraction
//   L          edge of the periodic cell [lattice spacings]
//   options    lambda=<x>    magic number of trt, default 3/16
//              shift=<x>     moves the centre by x*(1, 1, 1) lattice spacings, default 0
//              history       prints step, CPU seconds and K at each sample to stderr
//
// A body force f along x drives the flow from rest.  With F = f L^3 and the superficial
// velocity U (mean of u over the cell, zero in the solid), K = F/(6 pi mu a U).
//
// The run goes on until K has stayed within 1e-5 of its last value for a quarter of the
// run. The cost reported is that of the first sample from which on K stays within 1e-4 of
// its last value: what a run costs that stops in time, not what it costs to know that.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <sys/resource.h>

#include "palabos3D.h"
#include "palabos3D.hh"

using namespace plb;
typedef double T;
#define LATTICE descriptors::ForcedD3Q19Descriptor

/// Two-relaxation-time collision for Stokes flow (no u u term), with Guo's body force.
///
/// s_plus = 1/tau acts on the even part of the populations and sets the viscosity,
/// s_minus on the odd part.  With bounce-back walls the steady state depends on Lambda =
/// (1/s_plus - 1/2)(1/s_minus - 1/2) only (Ginzburg & d'Humieres 2003).  Palabos 1.5 has
/// a TRTdynamics, but with s_minus fixed at 1.1 and without a force.
template <typename T, template <typename U> class Descriptor>
class ForcedTrtDynamics : public IsoThermalBulkDynamics<T, Descriptor> {
 public:
  ForcedTrtDynamics(T omega, T lambda)
      : IsoThermalBulkDynamics<T, Descriptor>(omega),
        sMinus_((T)1 / (lambda / ((T)1 / omega - (T)0.5) + (T)0.5)) {}

  explicit ForcedTrtDynamics(HierarchicUnserializer& in)
      : IsoThermalBulkDynamics<T, Descriptor>((T)1) {
    unserialize(in);
  }

  // Palabos copies the dynamics of the periodic envelope in serialised form.
  void serialize(HierarchicSerializer& out) const override {
    IsoThermalBulkDynamics<T, Descriptor>::serialize(out);
    out.addValue(sMinus_);
  }
  void unserialize(HierarchicUnserializer& in) override {
    IsoThermalBulkDynamics<T, Descriptor>::unserialize(in);
    in.readValue(sMinus_);
  }
  ForcedTrtDynamics<T, Descriptor>* clone() const override {
    return new ForcedTrtDynamics<T, Descriptor>(*this);
  }
  int getId() const override { return id; }

  void collide(Cell<T, Descriptor>& cell, BlockStatistics&) override {
    T rhoBar;
    Array<T, 3> j;
    momentTemplates<T, Descriptor>::get_rhoBar_j(cell, rhoBar, j);
    relax(cell, rhoBar, j);
  }
  void collideExternal(Cell<T, Descriptor>& cell, T rhoBar, Array<T, 3> const& j, T,
                       BlockStatistics&) override {
    relax(cell, rhoBar, j);
  }
  T computeEquilibrium(plint i, T rhoBar, Array<T, 3> const& j, T, T) const override {
    int const* c = Descriptor<T>::c[i];
    return Descriptor<T>::t[i] * (rhoBar + 3 * (c[0] * j[0] + c[1] * j[1] + c[2] * j[2]));
  }
  void computeVelocity(Cell<T, Descriptor> const& cell, Array<T, 3>& u) const override {
    T rhoBar;
    momentTemplates<T, Descriptor>::get_rhoBar_j(cell, rhoBar, u);
    T const* f = cell.getExternal(Descriptor<T>::ExternalField::forceBeginsAt);
    for (int d = 0; d < 3; ++d)
      u[d] += f[d] / 2;
  }
  bool velIsJ() const override { return true; }

 private:
  void relax(Cell<T, Descriptor>& cell, T rhoBar, Array<T, 3> const& j) const {
    typedef Descriptor<T> D;
    T const sPlus = this->getOmega();
    T const* f = cell.getExternal(D::ExternalField::forceBeginsAt);
    // Odd part: -s_minus (f - eq(j + F/2)) + (1 - s_minus/2) 3 t c.F, in one vector.
    T odd[3];
    for (int d = 0; d < 3; ++d)
      odd[d] = 3 * (sMinus_ * (j[d] + f[d] / 2) + (1 - sMinus_ / 2) * f[d]);
    cell[0] -= sPlus * (cell[0] - D::t[0] * rhoBar);
    for (plint i = 1; i <= D::q / 2; ++i) {
      plint const opp = i + D::q / 2;
      int const* c = D::c[i];
      T const even = sPlus * ((cell[i] + cell[opp]) / 2 - D::t[i] * rhoBar);
      T const uneven = sMinus_ * (cell[i] - cell[opp]) / 2 -
                       D::t[i] * (c[0] * odd[0] + c[1] * odd[1] + c[2] * odd[2]);
      cell[i] -= even + uneven;
      cell[opp] -= even - uneven;
    }
  }
  T sMinus_;
  static int id;
};
template <typename T, template <typename U> class Descriptor>
int ForcedTrtDynamics<T, Descriptor>::id =
    meta::registerGeneralDynamics<T, Descriptor, ForcedTrtDynamics<T, Descriptor>>(
        "TRT_Forced");

/// The sphere for the staircase wall: nodes whose centre is inside.
class InSphere : public DomainFunctional3D {
 public:
  InSphere(T centre, T radius) : centre_(centre), radius_(radius) {}
  bool operator()(plint x, plint y, plint z) const override {
    T const dx = x - centre_, dy = y - centre_, dz = z - centre_;
    return dx * dx + dy * dy + dz * dz < radius_ * radius_;
  }
  InSphere* clone() const override { return new InSphere(*this); }

 private:
  T centre_, radius_;
};

double user_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_utime.tv_sec + 1e-6 * usage.ru_utime.tv_usec;
}

double peak_mebibytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;
}

struct Sample {
  plint step;
  double cpu, velocity;
};

int main(int argc, char* argv[]) {
  plbInit(&argc, &argv);
  if (argc < 6) {
    std::fprintf(stderr,
                 "usage: sphere_array <wall> <collision> <tau> <c> <L> [options]\n");
    return 2;
  }
  std::string const wall = argv[1], collision = argv[2];
  T const tau = std::atof(argv[3]), c = std::atof(argv[4]);
  plint const L = std::atol(argv[5]);
  T lambda = 3.0 / 16.0, shift = 0;
  bool history = false;
  for (int i = 6; i < argc; ++i) {
    std::string const option = argv[i];
    if (option.compare(0, 7, "lambda=") == 0)
      lambda = std::atof(option.c_str() + 7);
    if (option.compare(0, 6, "shift=") == 0)
      shift = std::atof(option.c_str() + 6);
    if (option == "history")
      history = true;
  }

  T const pi = std::acos(-1.0);
  T const radius = L * std::cbrt(3 * c / (4 * pi));
  T const centre = 0.5 * (L - 1) + shift;
  T const nu = (tau - 0.5) / 3;
  // Dimensionless: U a/nu = 1e-6, far below what inertia or compressibility could show.
  T const force = 6 * pi * 4.3 * 1e-6 * nu * nu / (T(L) * L * L);

  std::unique_ptr<Dynamics<T, LATTICE>> dynamics;
  if (collision == "trt")
    dynamics.reset(new ForcedTrtDynamics<T, LATTICE>(1 / tau, lambda));
  else
    dynamics.reset(new GuoExternalForceBGKdynamics<T, LATTICE>(1 / tau));

  Box3D const box(0, L - 1, 0, L - 1, 0, L - 1);
  std::unique_ptr<MultiBlockLattice3D<T, LATTICE>> lattice;
  BoundaryProfiles3D<T, Array<T, 3>> profiles;  // the wall model keeps a reference
  std::unique_ptr<TriangleBoundary3D<T>> boundary;
  std::unique_ptr<VoxelizedDomain3D<T>> voxels;
  std::unique_ptr<OffLatticeBoundaryCondition3D<T, LATTICE, Array<T, 3>>> condition;

  // Mask: 1 in the fluid, 0 in the solid.
  std::unique_ptr<MultiScalarField3D<T>> mask;
  if (wall == "guo") {
    // About 8 triangles per lattice face, and the volume of the true sphere.
    T const area = 4 * pi * radius * radius;
    Array<T, 3> const middle(centre, centre, centre);
    TriangleSet<T> surface = constructSphere<T>(Array<T, 3>(0, 0, 0), radius,
                                                (plint)std::max(4000.0, 8 * area));
    T volume = 0;
    for (auto const& t : surface.getTriangles())
      volume += dot(t[0], crossProduct<T>(t[1], t[2])) / 6;
    surface.scale(radius * std::cbrt(4 * pi / (3 * std::abs(volume))));
    surface.translate(middle);
    DEFscaledMesh<T> mesh(surface, 0, 0, 1, Dot3D(0, 0, 0));
    boundary.reset(new TriangleBoundary3D<T>(mesh));
    int const flow = voxelFlag::outside;
    voxels.reset(new VoxelizedDomain3D<T>(*boundary, flow, box, 1, 2, 0));
    lattice.reset(new MultiBlockLattice3D<T, LATTICE>(voxels->getVoxelMatrix()));
    defineDynamics(*lattice, lattice->getBoundingBox(), dynamics->clone());
    defineDynamics(*lattice, voxels->getVoxelMatrix(), lattice->getBoundingBox(),
                   new NoDynamics<T, LATTICE>(), voxelFlag::inside);
    profiles.setWallProfile(new NoSlipProfile3D<T>);
    auto* model = new GuoOffLatticeModel3D<T, LATTICE>(
        new TriangleFlowShape3D<T, Array<T, 3>>(voxels->getBoundary(), profiles), flow,
        true);
    model->setVelIsJ(dynamics->velIsJ());
    condition.reset(new OffLatticeBoundaryCondition3D<T, LATTICE, Array<T, 3>>(
        model, *voxels, *lattice));
  } else {
    lattice.reset(new MultiBlockLattice3D<T, LATTICE>(L, L, L, dynamics->clone()));
    defineDynamics(*lattice, lattice->getBoundingBox(), new InSphere(centre, radius),
                   new BounceBack<T, LATTICE>((T)0));
  }
  lattice->periodicity().toggleAll(true);
  lattice->toggleInternalStatistics(false);
  setExternalVector(*lattice, lattice->getBoundingBox(),
                    LATTICE<T>::ExternalField::forceBeginsAt, Array<T, 3>(force, 0, 0));
  initializeAtEquilibrium(*lattice, lattice->getBoundingBox(), (T)1,
                          Array<T, 3>(0, 0, 0));
  lattice->initialize();
  if (condition)
    condition->insert();

  mask.reset(new MultiScalarField3D<T>(*lattice));
  setToConstant(*mask, box, (T)1);
  setToFunction(*mask, box, [&](plint x, plint y, plint z) {
    return InSphere(centre, radius)(x, y, z) ? (T)0 : (T)1;
  });
  double const fluid = computeSum(*mask, box);

  auto velocity = [&]() {
    std::auto_ptr<MultiScalarField3D<T>> u = computeVelocityComponent(*lattice, box, 0);
    multiplyInPlace(*u, *mask, box);
    return computeSum(*u, box) / (double(L) * L * L);
  };
  auto drag = [&](double u) {
    return force * double(L) * L * L / (6 * pi * nu * radius * u);
  };

  double const set_up = user_seconds();
  std::vector<Sample> samples;
  plint const every = std::max<plint>(5, L / 4);
  plint step = 0;
  bool done = false;
  while (!done) {
    // Mean of four steps: nodes trapped between staircases flip for ever with period
    // four.
    double u = 0;
    for (plint i = 0; i < every; ++i) {
      lattice->collideAndStream();
      if (i >= every - 4)
        u += velocity() / 4;
    }
    step += every;
    samples.push_back({step, user_seconds() - set_up, u});
    size_t const n = samples.size() - 1;
    if (history)
      std::fprintf(stderr, "%ld %.3f %.8f\n", (long)step, samples[n].cpu,
                   drag(samples[n].velocity));
    if (!std::isfinite(samples[n].velocity))
      return 4;
    if (n >= 20) {
      done = true;
      for (size_t i = n - n / 4; i < n; ++i)
        done = done && std::abs(samples[i].velocity / samples[n].velocity - 1) < 1e-5;
    }
    if (samples[n].cpu > 300)
      break;
  }

  double const K = drag(samples.back().velocity);
  size_t first = samples.size() - 1;
  while (first > 0 && std::abs(drag(samples[first - 1].velocity) / K - 1) < 1e-4)
    --first;
  // wall, collision, tau, lambda, shift, c, cells per diameter, cells, solid fraction of
  // the lattice, K, converged, steps and CPU to 1e-4, set-up CPU, all steps, all CPU,
  // memory
  std::printf("%s,%s,%g,%g,%g,%g,%.4f,%ld,%.6f,%.6f,%d,%ld,%.2f,%.2f,%ld,%.2f,%.0f\n",
              wall.c_str(), collision.c_str(), tau, lambda, shift, c, 2 * radius,
              (long)(L * L * L), 1 - fluid / (double(L) * L * L), K, (int)done,
              (long)samples[first].step, samples[first].cpu, set_up, (long)step,
              samples.back().cpu, peak_mebibytes());
  return 0;
}
