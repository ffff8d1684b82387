#include "tiers/transient/dem_engine.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include <fcntl.h>
#include <mpi.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/constants.h"
#include "core/error.h"

// Of LIGGGHTS.
#include "lmptype.h"
//
#include "atom.h"
#include "atom_vec.h"
#include "domain.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "lammps.h"
#include "library.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

namespace colloid {

namespace {

constexpr double kSkin = 0.3;  // of the radius: neighbours are kept that much longer

/// Standard output and error lead nowhere while it lives: LIGGGHTS prints when an
/// instance is opened and when one is restored.
class Silence {
 public:
  Silence() {
    std::fflush(nullptr);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (int stream = 0; stream < 2; ++stream) {
      saved_[stream] = dup(stream + 1);
      if (nowhere >= 0 && saved_[stream] >= 0) {
        dup2(nowhere, stream + 1);
      }
    }
    if (nowhere >= 0) {
      close(nowhere);
    }
  }
  ~Silence() {
    std::fflush(nullptr);
    for (int stream = 0; stream < 2; ++stream) {
      if (saved_[stream] >= 0) {
        dup2(saved_[stream], stream + 1);
        close(saved_[stream]);
      }
    }
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int saved_[2] = {-1, -1};
};

/// A file in memory with a name that LIGGGHTS can open.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("poreclog-dem", MFD_CLOEXEC)) {
    if (descriptor_ < 0) {
      throw OutputError("memory", "no file for the state of the colloids", errno);
    }
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  void write(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t n = ::write(descriptor_, text.data() + at, text.size() - at);
      if (n <= 0) {
        throw OutputError("memory", "no room for the state of the colloids", errno);
      }
      at += static_cast<std::size_t>(n);
    }
  }
  std::string read() const {
    std::string text(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t n =
          pread(descriptor_, text.data() + at, text.size() - at, static_cast<off_t>(at));
      if (n <= 0) {
        throw OutputError("memory", "the state of the colloids cannot be read", errno);
      }
      at += static_cast<std::size_t>(n);
    }
    return text;
  }

 private:
  int descriptor_;
};

void start_mpi() {
  int ready = 0;
  MPI_Initialized(&ready);
  if (ready == 0) {
    int given = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SINGLE, &given);
    std::atexit([] {
      int over = 0;
      MPI_Finalized(&over);
      if (over == 0) {
        MPI_Finalize();
      }
    });
  }
}

std::string digits(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.17g", number);
  return text;
}

/// Lets LIGGGHTS' integration and contacts call our forces in every sub-step.
class ForceFix : public LAMMPS_NS::Fix {
 public:
  ForceFix(LAMMPS_NS::LAMMPS* engine, int words, char** word)
      : LAMMPS_NS::Fix(engine, words, word) {
    time_integrate = 1;
  }
  void attach(DemForces& forces) { forces_ = &forces; }

  int setmask() override {
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE;
  }
  void setup(int /*virial*/) override {
    list_pairs();
    forces_->act(atoms(), pairs_, true);
  }
  void initial_integrate(int /*virial*/) override {
    const DemAtoms now = atoms();
    forces_->half_kick(now);
    forces_->move(now);
  }
  void post_force(int /*virial*/) override {
    if (neighbor_lists_ != LAMMPS_NS::Pointers::neighbor->ncalls) {
      list_pairs();
    }
    forces_->act(atoms(), pairs_, false);
  }
  void final_integrate() override { forces_->half_kick(atoms()); }

 private:
  DemAtoms atoms() {
    LAMMPS_NS::Atom& a = *LAMMPS_NS::Pointers::atom;
    return {a.nlocal, a.x, a.v, a.omega, a.f, a.torque, a.tag, a.type, a.mask, a.radius};
  }

  // Pairs that may act on a mobile colloid.
  void list_pairs() {
    using LAMMPS_NS::NeighList;
    LAMMPS_NS::Atom& a = *LAMMPS_NS::Pointers::atom;
    const NeighList& list = *LAMMPS_NS::Pointers::force->pair->list;
    neighbor_lists_ = LAMMPS_NS::Pointers::neighbor->ncalls;
    pairs_.clear();
    forces_->locate(atoms());
    for (int n = 0; n < list.inum; ++n) {
      const int i = list.ilist[n];
      for (int k = 0; k < list.numneigh[i]; ++k) {
        const int j = list.firstneigh[i][k] & NEIGHMASK;
        // Through a periodic face a pair is listed on both sides: take one of them.
        if ((a.type[i] == dem_mobile || a.type[j] == dem_mobile) &&
            (j < a.nlocal || a.tag[i] < a.tag[j])) {
          pairs_.push_back({i, j, a.map(a.tag[j])});
        }
      }
    }
  }

  DemForces* forces_ = nullptr;
  std::vector<DemPair> pairs_;
  LAMMPS_NS::bigint neighbor_lists_ = -1;
};

LAMMPS_NS::Fix* make_force_fix(LAMMPS_NS::LAMMPS* engine, int words, char** word) {
  return new ForceFix(engine, words, word);
}

// The table of fix styles is private; an explicit instantiation may name it.
using FixMaker = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
struct FixTable {
  using type = std::map<std::string, FixMaker>* LAMMPS_NS::Modify::*;
  friend type member(FixTable);
};
template <class Tag, typename Tag::type pointer>
struct Access {
  friend typename Tag::type member(Tag) { return pointer; }
};
template struct Access<FixTable, &LAMMPS_NS::Modify::fix_map>;

}  // namespace

DemEngine::DemEngine(const DemOptions& options, const std::vector<Sphere>& grains,
                     DemForces& forces)
    : options_(options), forces_(forces) {
  describe_extent(grains);
  open();
  try {
    describe_box();
    describe_matter();
    int tag = 0;
    for (const Sphere& grain : grains) {
      add_sphere(++tag, dem_grain, wrapped(options_.box, grain.center), grain.radius);
    }
    finish_set_up();
  } catch (...) {
    lammps_close(engine_);
    throw;
  }
}

DemEngine::DemEngine(const DemOptions& options, const std::vector<Sphere>& grains,
                     DemForces& forces, const std::string& saved)
    : options_(options), forces_(forces) {
  describe_extent(grains);
  open();
  try {
    MemoryFile file;
    file.write(saved);
    begin_commands();
    {
      const Silence silence;
      command("read_restart " + file.name());
    }
    describe_matter();
    finish_set_up();
  } catch (...) {
    lammps_close(engine_);
    throw;
  }
}

DemEngine::~DemEngine() {
  lammps_close(engine_);
}

void DemEngine::describe_extent(const std::vector<Sphere>& grains) {
  // Along periodic axes the scene's box; along others with room for spheres beyond it.
  lowest_ = {};
  highest_ = options_.box.size;
  for (int axis = 0; axis < 3; ++axis) {
    if (options_.box.periodic(axis)) {
      continue;
    }
    for (const Sphere& grain : grains) {
      lowest_[axis] = std::min(lowest_[axis], grain.center[axis]);
      highest_[axis] = std::max(highest_[axis], grain.center[axis]);
    }
    lowest_[axis] -= 4.0 * options_.radius;
    highest_[axis] += 4.0 * options_.radius;
  }
}

void DemEngine::open() {
  if (!error_hook_is_linked()) {
    throw EngineError("its errors would end the process");
  }
  start_mpi();
  std::vector<std::string> words{"liggghts", "-log",      "/dev/null",
                                 "-screen",  "/dev/null", "-nocite"};
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  void* engine = nullptr;
  const Silence silence;
  lammps_open(static_cast<int>(arguments.size()), arguments.data(), MPI_COMM_SELF,
              &engine);
  engine_ = static_cast<LAMMPS_NS::LAMMPS*>(engine);
}

void DemEngine::command(const std::string& text) {
  std::string writable = text;
  lammps_command(engine_, writable.data());
}

void DemEngine::begin_commands() {
  command("atom_modify map array sort 0 0");
  command("hard_particles yes");  // Young's moduli beyond LIGGGHTS' idea of usual ones
  command("soft_particles yes");
  command("newton off");
}

void DemEngine::describe_box() {
  command("units si");
  command("atom_style sphere");
  begin_commands();
  std::string boundary = "boundary";
  std::string region = "region domain block";
  for (int axis = 0; axis < 3; ++axis) {
    boundary += options_.box.periodic(axis) ? " p" : " f";
    region += " " + digits(lowest_[axis]) + " " + digits(highest_[axis]);
  }
  command(boundary);
  command(region + " units box");
  command("create_box 4 domain");
}

void DemEngine::describe_matter() {
  const double a = options_.radius;
  command("communicate single vel yes");
  command("neighbor " + digits(kSkin * a) + " bin");
  command("neigh_modify delay 0 every 1 check yes contact_distance_factor " +
          digits(1.0 + forces_.reach() / (2.0 * a)));
  command("neigh_modify exclude type 2 2");
  command("neigh_modify exclude type 2 3");
  command("neigh_modify exclude type 3 3");
  const DemSurface& colloid = options_.colloid;
  const DemSurface& grain = options_.grain;
  // By type: mobile colloid, grain and wall, held colloid, smooth plane.
  const auto by_type = [&](double of_colloid, double of_grain) {
    return " " + digits(of_colloid) + " " + digits(of_grain) + " " + digits(of_colloid) +
           " " + digits(of_colloid);
  };
  command("fix young all property/global youngsModulus peratomtype" +
          by_type(colloid.young_modulus, grain.young_modulus));
  command("fix poisson all property/global poissonsRatio peratomtype" +
          by_type(colloid.poisson_ratio, grain.poisson_ratio));
  std::string restitution;
  std::string friction;
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) {
      const bool smooth = i == dem_smooth_plane || j == dem_smooth_plane;
      restitution += " " + digits(options_.restitution);
      friction += " " + digits(smooth ? 0.0 : options_.friction);
    }
  }
  command("fix restitution all property/global coefficientRestitution peratomtypepair 4" +
          restitution);
  command("fix friction all property/global coefficientFriction peratomtypepair 4" +
          friction);
  command("pair_style gran model hertz tangential history");
  command("pair_coeff * *");
  command("timestep " + digits(options_.step));
}

void DemEngine::finish_set_up() {
  command("group colloid type 1");
  command("group frozen type 2");
  command("fix freeze frozen freeze");
  (*(engine_->modify->*member(FixTable())))["poreclog/forces"] = make_force_fix;
  command("fix forces all poreclog/forces");
  auto* fix =
      static_cast<ForceFix*>(engine_->modify->fix[engine_->modify->find_fix("forces")]);
  fix->attach(forces_);
  forces_.set_frozen_bit(group_bit("frozen"));
  for (int face = 0; face < kFaces; ++face) {
    const FaceCondition condition = options_.box.face(face);
    if (condition == FaceCondition::outlet || condition == FaceCondition::periodic) {
      continue;
    }
    const int axis = axis_of(face);
    const DemType type = condition == FaceCondition::wall ? dem_grain : dem_smooth_plane;
    command("fix plane" + std::to_string(face) +
            " colloid wall/gran model hertz tangential history primitive type " +
            std::to_string(type) + " " + "xyz"[axis] + "plane " +
            digits(is_upper(face) ? options_.box.size[axis] : 0.0));
  }
  command("thermo 0");
  command("thermo_modify lost ignore norm no");
}

int DemEngine::group_bit(const char* name) const {
  return engine_->group->bitmask[engine_->group->find(name)];
}

int DemEngine::atom_of(int id) const {
  const int tag = forces_.tag_of(id);
  const LAMMPS_NS::Atom& atom = *engine_->atom;
  const int* end = atom.tag + atom.nlocal;
  const int* found = std::find(static_cast<const int*>(atom.tag), end, tag);
  if (found == end) {
    throw ConvergenceError("DEM: colloid " + std::to_string(id) + " is lost");
  }
  return static_cast<int>(found - atom.tag);
}

void DemEngine::add_sphere(int tag, int type, const Vec3& x, double radius) {
  LAMMPS_NS::Atom& atom = *engine_->atom;
  Vec3 where = x;
  double position[3] = {where.x, where.y, where.z};
  atom.avec->create_atom(type, position);
  const int i = atom.nlocal - 1;
  atom.tag[i] = tag;
  atom.radius[i] = radius;
  atom.density[i] = options_.density;
  atom.rmass[i] = options_.density * 4.0 / 3.0 * kPi * radius * radius * radius;
  LAMMPS_NS::Modify& modify = *engine_->modify;
  for (int f = 0; f < modify.nfix; ++f) {
    if (modify.fix[f]->create_attribute != 0) {
      modify.fix[f]->pre_set_arrays();
      modify.fix[f]->set_arrays(i);
    }
  }
  atom.natoms = atom.nlocal;
  atom.nghost = 0;
  atom.map_init();
  atom.map_set();
}

void DemEngine::add(const DemState& state) {
  add_sphere(forces_.tag_of(state.id), dem_mobile, wrapped(options_.box, state.position),
             options_.radius);
  LAMMPS_NS::Atom& atom = *engine_->atom;
  const int i = atom.nlocal - 1;
  set(atom.v[i], state.velocity);
  set(atom.omega[i], state.spin);
  atom.mask[i] |= group_bit("colloid");
  if (state.held) {
    hold(state.id);
  }
}

void DemEngine::hold(int id) {
  LAMMPS_NS::Atom& atom = *engine_->atom;
  const int i = atom_of(id);
  atom.type[i] = dem_held;
  atom.mask[i] |= group_bit("frozen");
  set(atom.v[i], {});
  set(atom.omega[i], {});
}

void DemEngine::remove(int id) {
  atom_of(id);  // throws if there is none
  command("group leaving id " + std::to_string(forces_.tag_of(id)));
  command("delete_atoms group leaving compress no");
  command("group leaving delete");
}

void DemEngine::run(long steps, double step) {
  command("timestep " + digits(step));
  // With set-up: only so a restored instance continues as this one does.
  command("run " + std::to_string(steps) + " pre yes post no");
}

std::vector<DemState> DemEngine::states() const {
  const LAMMPS_NS::Atom& atom = *engine_->atom;
  std::vector<DemState> out;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (atom.type[i] != dem_grain) {
      out.push_back({forces_.id_of(atom.tag[i]), vector(atom.x[i]), vector(atom.v[i]),
                     vector(atom.omega[i]), atom.type[i] == dem_held});
    }
  }
  return out;
}

std::string DemEngine::save() {
  const MemoryFile file;
  command("write_restart " + file.name());
  return file.read();
}

}  // namespace colloid
