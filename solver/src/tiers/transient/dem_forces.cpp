#include "tiers/transient/dem_forces.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/constants.h"
#include "core/error.h"
#include "core/text.h"

namespace colloid {

namespace {

constexpr double kLongestMove = 0.05;                 // of the radius, in one sub-step
constexpr double kParting = 2.0 * kContactTolerance;  // of the gap: out of touch

/// D of (T-D3): (D - drag) / D = exp(-drag h / m), D = m / h without drag.
double exponential_inertia(double drag, double mass, double h) {
  const double z = drag * h / mass;
  return z < 1e-12 ? mass / h : drag / -std::expm1(-z);
}

std::vector<double> radii_of(const std::vector<Sphere>& spheres) {
  std::vector<double> out(spheres.size());
  std::transform(spheres.begin(), spheres.end(), out.begin(),
                 [](const Sphere& sphere) { return sphere.radius; });
  return out;
}

/// At that velocity.
Vec3 hydrodynamic(const DemLoad& load, const Vec3& velocity) {
  return load.force + load.drag * (load.velocity - velocity);
}

}  // namespace

DemForces::DemForces(const DemOptions& options, const std::vector<Sphere>& grains)
    : options_(options),
      grain_radii_(radii_of(grains)),
      grain_force_(options.surfaces.grain, options.least_surface_force, false),
      wall_force_(options.surfaces.wall, options.least_surface_force,
                  !options.surfaces.rules.walls_attach),
      colloid_force_(options.surfaces.colloid, options.least_surface_force, false),
      stiffness_(bond_stiffness(options)) {
  const double a = options_.radius;
  const double volume = 4.0 / 3.0 * kPi * a * a * a;
  mass_ = options_.density * volume;
  inertia_ = 0.4 * mass_ * a * a;
  weight_ = (options_.density - options_.fluid_density) * volume * options_.gravity;
  const ContactRules& rules = options_.surfaces.rules;
  reach_ = std::max(rules.grain_gap, (1.0 + kParting) * rules.colloid_gap);
  if (options_.long_range_forces) {
    reach_ = std::max({reach_, grain_force_.range(), colloid_force_.range()});
  }
  if (options_.lubrication) {
    reach_ = std::max(reach_, kResolvedGap * options_.lubrication_cell);
    gap_resistance_.emplace(options_.viscosity, a, grain_radii_,
                            options_.lubrication_cell,
                            options_.surfaces.grain.forces.pair().closest_gap);
  }
}

DemForces::Slot& DemForces::slot(int id) {
  if (id >= static_cast<int>(slots_.size())) {
    slots_.resize(static_cast<std::size_t>(id) + 1);
  }
  return slots_[static_cast<std::size_t>(id)];
}

void DemForces::begin(double step, const std::vector<DemLoad>& loads) {
  step_ = step;
  steps_ = 0;
  events_.clear();
  std::fill(slots_.begin(), slots_.end(), Slot{});
  for (const DemLoad& load : loads) {
    slot(load.id).load = load;
  }
}

DemStep DemForces::finish(double duration, const std::vector<int>& ids) {
  DemStep out;
  for (const int id : ids) {
    const Slot& s = slot(id);
    out.means.push_back({id, s.impulse * (1.0 / duration), s.turning * (1.0 / duration)});
  }
  out.events = std::move(events_);
  events_.clear();
  out.steps = steps_;
  return out;
}

void DemForces::locate(const DemAtoms& atoms) {
  const double h = 0.5 * step_;
  for (Slot& s : slots_) {
    s.local = -1;
  }
  for (int i = 0; i < atoms.local; ++i) {
    if (atoms.type[i] != dem_grain) {
      Slot& s = slot(id_of(atoms.tag[i]));
      s.local = i;
      if (s.drag_inertia == 0.0) {
        s.drag_inertia = exponential_inertia(s.load.drag, mass_, h);
        s.torsion_inertia = exponential_inertia(s.load.torsion, inertia_, h);
      }
    }
  }
}

void DemForces::act(const DemAtoms& atoms, const std::vector<DemPair>& pairs,
                    bool first) {
  steps_ += first ? 0 : 1;
  gaps_.clear();
  add_body_forces(atoms);
  add_bond_forces(atoms, first);
  for (const DemPair& pair : pairs) {
    add_pair(atoms, pair);
  }
  for (int i = 0; i < atoms.local; ++i) {
    if (atoms.type[i] == dem_mobile) {
      add_walls(atoms, i);
    }
  }
  // Who was arrested on the way is at rest for its gaps.
  for (NarrowGap& gap : gaps_) {
    for (int* end : {&gap.first, &gap.second}) {
      if (*end >= 0 && atoms.type[*end] != dem_mobile) {
        *end = -1;
      }
    }
  }
}

void DemForces::add_body_forces(const DemAtoms& atoms) {
  for (int i = 0; i < atoms.local; ++i) {
    if (atoms.type[i] == dem_mobile) {
      Slot& s = slot(id_of(atoms.tag[i]));
      add(atoms.f[i], weight_);
      s.push = weight_ + hydrodynamic(s.load, {});
    }
  }
}

void DemForces::add_bond_forces(const DemAtoms& atoms, bool first) {
  for (Bond& bond : bonds_) {
    const int i = slot(bond.first).local;
    const int j = slot(bond.second).local;
    if (atoms.type[i] != dem_mobile && atoms.type[j] != dem_mobile) {
      continue;
    }
    const Vec3 offset = shortest(options_.box, vector(atoms.x[i]), vector(atoms.x[j]));
    const BondForce force =
        bond_force(bond, stiffness_, offset, {vector(atoms.v[i]), vector(atoms.omega[i])},
                   {vector(atoms.v[j]), vector(atoms.omega[j])}, first ? 0.0 : step_);
    if (!options_.permanent_bonds && bond.tension > options_.surfaces.colloid.pull_off) {
      bond.broken = 1;
      continue;
    }
    add(atoms.f[i], force.force);
    add(atoms.f[j], -force.force);
    add(atoms.torque[i], force.first_torque);
    add(atoms.torque[j], force.second_torque);
    slot(bond.first).push += force.force;
    slot(bond.second).push -= force.force;
  }
  drop_broken();
  // Parted colloids may bond again once they have been out of touch.
  const double apart =
      2.0 * options_.radius + (1.0 + kParting) * options_.surfaces.rules.colloid_gap;
  for (auto pair = parted_.begin(); pair != parted_.end();) {
    const int i = slot(pair->first).local;
    const int j = slot(pair->second).local;
    const bool out =
        norm(shortest(options_.box, vector(atoms.x[i]), vector(atoms.x[j]))) > apart;
    pair = out ? parted_.erase(pair) : std::next(pair);
  }
}

void DemForces::drop_broken() {
  const auto kept = std::stable_partition(bonds_.begin(), bonds_.end(),
                                          [](const Bond& b) { return b.broken == 0; });
  for (auto bond = kept; bond != bonds_.end(); ++bond) {
    joined_.erase(key(bond->first, bond->second));
    parted_.insert(key(bond->first, bond->second));
    events_.push_back({DemEvent::Kind::bond_broken, bond->first, bond->second,
                       static_cast<double>(steps_) * step_});
    ++broken_;
  }
  bonds_.erase(kept, bonds_.end());
}

void DemForces::add_pair(const DemAtoms& atoms, const DemPair& pair) {
  const int i = pair.first;
  const int j = pair.second_local;
  if (atoms.type[i] != dem_mobile && atoms.type[j] != dem_mobile) {
    return;
  }
  const Vec3 offset = vector(atoms.x[i]) - vector(atoms.x[pair.second]);
  const double reach = atoms.radius[i] + atoms.radius[j] + reach_;
  if (dot(offset, offset) > reach * reach) {
    return;
  }
  if (atoms.type[j] == dem_grain) {
    add_grain(atoms, i, j, offset);
  } else if (atoms.type[i] == dem_grain) {
    add_grain(atoms, j, i, -offset);
  } else {
    add_colloids(atoms, i, j, offset);
  }
}

void DemForces::lubricate(int i, const NearSurface& surface) {
  if (gap_resistance_ &&
      surface.distance - options_.radius < kResolvedGap * options_.lubrication_cell) {
    gaps_.push_back(narrow_gap(i, gap_resistance_->beside(surface)));
    if (surface.id.kind == SurfaceId::Kind::face && surface.id.index == z_plus) {
      gaps_.back().drive = options_.upper_wall_speed * gaps_.back().resistance.col(0);
    }
  }
}

void DemForces::add_grain(const DemAtoms& atoms, int colloid, int grain,
                          const Vec3& offset) {
  const int index = atoms.tag[grain] - 1;
  const double distance = norm(offset);
  const Vec3 normal = offset * (1.0 / distance);
  const double b = grain_radii_[static_cast<std::size_t>(index)];
  const double gap = distance - atoms.radius[colloid] - b;
  if (options_.long_range_forces) {
    add(atoms.f[colloid], grain_force_.at(gap) * normal);
  }
  lubricate(colloid, {{SurfaceId::Kind::grain, index}, distance - b, normal, b});
  const ContactRules& rules = options_.surfaces.rules;
  if (gap <= rules.grain_gap) {
    attach(atoms, colloid, DemEvent::Kind::touched_grain, index, rules.grain_repulsion,
           rules.grains_attach, normal);
  }
}

void DemForces::add_walls(const DemAtoms& atoms, int i) {
  const ContactRules& rules = options_.surfaces.rules;
  for (int face = 0; face < kFaces; ++face) {
    if (options_.box.face(face) != FaceCondition::wall) {
      continue;
    }
    const int axis = axis_of(face);
    const double side = is_upper(face) ? -1.0 : 1.0;
    const double x = atoms.x[i][axis];
    const double distance = is_upper(face) ? options_.box.size[axis] - x : x;
    const double gap = distance - atoms.radius[i];
    Vec3 normal;
    normal[axis] = side;
    if (options_.long_range_forces) {
      add(atoms.f[i], wall_force_.at(gap) * normal);
    }
    lubricate(i, {{SurfaceId::Kind::face, face}, distance, normal, HUGE_VAL});
    if (gap <= rules.wall_gap) {
      attach(atoms, i, DemEvent::Kind::touched_wall, face, rules.wall_repulsion,
             rules.walls_attach, normal);
    }
  }
}

void DemForces::add_colloids(const DemAtoms& atoms, int one, int other,
                             const Vec3& offset) {
  const int a = id_of(atoms.tag[one]);
  const int b = id_of(atoms.tag[other]);
  if (bonded(a, b)) {
    return;
  }
  const double distance = norm(offset);
  const Vec3 normal = offset * (1.0 / distance);
  const double gap = distance - atoms.radius[one] - atoms.radius[other];
  const ContactRules& rules = options_.surfaces.rules;
  const bool mobile = atoms.type[one] == dem_mobile && atoms.type[other] == dem_mobile;
  if (gap <= rules.colloid_gap && rules.colloids_attach &&
      (!mobile || rules.aggregates) && parted_.count(key(a, b)) == 0) {
    Bond bond;
    bond.first = a;
    bond.second = b;
    bond.rigid = mobile ? 1 : 0;
    bond.length = distance;
    bonds_.push_back(bond);
    joined_.insert(key(a, b));
    const bool first_moves = atoms.type[one] == dem_mobile;
    events_.push_back(
        {mobile ? DemEvent::Kind::touched_mobile : DemEvent::Kind::touched_retained,
         first_moves ? a : b, first_moves ? b : a, static_cast<double>(steps_) * step_});
    return;
  }
  if (options_.long_range_forces) {
    const Vec3 force = colloid_force_.at(gap) * normal;
    add(atoms.f[one], force);
    add(atoms.f[other], -force);
  }
  if (gap_resistance_ && gap < kResolvedGap * options_.lubrication_cell) {
    gaps_.push_back(narrow_gap(one, other, gap_resistance_->between(offset)));
  }
}

void DemForces::attach(const DemAtoms& atoms, int i, DemEvent::Kind kind, int other,
                       double repulsion, bool attaches, const Vec3& normal) {
  if (atoms.type[i] == dem_mobile &&
      (attaches || -dot(slot(id_of(atoms.tag[i])).push, normal) > repulsion)) {
    arrest(atoms, i, kind, other);
  }
}

void DemForces::freeze(const DemAtoms& atoms, int i) {
  atoms.type[i] = dem_held;
  atoms.mask[i] |= frozen_bit_;
  set(atoms.v[i], {});
  set(atoms.omega[i], {});
}

void DemForces::arrest(const DemAtoms& atoms, int i, DemEvent::Kind kind, int other) {
  const double time = static_cast<double>(steps_) * step_;
  const int id = id_of(atoms.tag[i]);
  events_.push_back({kind, id, other, time});
  freeze(atoms, i);
  for (const int member : aggregate(id)) {
    const int local = slot(member).local;
    if (atoms.type[local] == dem_mobile) {
      events_.push_back({DemEvent::Kind::arrested_with, member, id, time});
      freeze(atoms, local);
    }
  }
}

void DemForces::half_kick(const DemAtoms& atoms) {
  const double h = 0.5 * step_;
  for (int i = 0; i < atoms.local; ++i) {
    if (atoms.type[i] != dem_mobile) {
      continue;
    }
    Slot& s = slot(id_of(atoms.tag[i]));
    const Vec3 force = vector(atoms.f[i]);
    const Vec3 torque = vector(atoms.torque[i]);
    const Vec3 v = vector(atoms.v[i]);
    const Vec3 spin = vector(atoms.omega[i]);
    s.impulse += h * force;
    s.turning += h * torque;
    add(atoms.v[i], (1.0 / s.drag_inertia) * (force + hydrodynamic(s.load, v)));
    add(atoms.omega[i],
        (1.0 / s.torsion_inertia) *
            (torque + s.load.torque + s.load.torsion * (s.load.spin - spin)));
  }
  if (!gaps_.empty()) {
    add_lubrication(atoms);
  }
}

void DemForces::add_lubrication(const DemAtoms& atoms) {
  const double h = 0.5 * step_;
  const double a = options_.radius;
  const auto n = static_cast<std::size_t>(atoms.local);
  compliance_.assign(n, Vector6::Zero());
  motion_.assign(n, Vector6::Zero());
  for (std::size_t i = 0; i < n; ++i) {
    if (atoms.type[i] == dem_mobile) {
      const Slot& s = slot(id_of(atoms.tag[i]));
      compliance_[i].head<3>().setConstant(1.0 / s.drag_inertia);
      compliance_[i].tail<3>().setConstant(a * a / s.torsion_inertia);
      motion_[i] << eigen(vector(atoms.v[i])), a * eigen(vector(atoms.omega[i]));
    }
  }
  solve_lubrication(gaps_, compliance_, motion_);
  for (std::size_t i = 0; i < n; ++i) {
    if (atoms.type[i] == dem_mobile) {
      set(atoms.v[i], plain(motion_[i].head<3>()));
      set(atoms.omega[i], plain(motion_[i].tail<3>() / a));
    }
  }
  const auto receive = [&](int i, const Vector6& wrench) {
    if (i >= 0) {
      Slot& s = slot(id_of(atoms.tag[i]));
      s.impulse += h * plain(wrench.head<3>());
      s.turning += (h * a) * plain(wrench.tail<3>());
    }
  };
  for (const NarrowGap& gap : gaps_) {
    receive(gap.first, gap.wrench.head<6>());
    receive(gap.second, gap.wrench.tail<6>());
  }
}

void DemForces::move(const DemAtoms& atoms) {
  for (int i = 0; i < atoms.local; ++i) {
    if (atoms.type[i] != dem_mobile) {
      continue;
    }
    const Vec3 step = step_ * vector(atoms.v[i]);
    // Also false for what is not a number.
    if (!(norm(step) < kLongestMove * options_.radius &&
          std::isfinite(norm(vector(atoms.omega[i]))))) {
      throw ConvergenceError("DEM: colloid " + std::to_string(id_of(atoms.tag[i])) +
                             " is unstable: in a sub-step of " + shortest(step_) +
                             " s it would move by " + shortest(norm(step)) + " m");
    }
    add(atoms.x[i], step);
  }
}

void DemForces::forget(int id) {
  const auto of_it = [id](const auto& pair) {
    return pair.first == id || pair.second == id;
  };
  bonds_.erase(std::remove_if(bonds_.begin(), bonds_.end(), of_it), bonds_.end());
  for (auto* pairs : {&joined_, &parted_}) {
    for (auto pair = pairs->begin(); pair != pairs->end();) {
      pair = of_it(*pair) ? pairs->erase(pair) : std::next(pair);
    }
  }
}

std::vector<DemBond> DemForces::bonds() const {
  std::vector<DemBond> out;
  for (const Bond& b : bonds_) {
    out.push_back({b.first, b.second, b.rigid != 0, b.tension, b.largest_tension});
  }
  return out;
}

std::vector<int> DemForces::aggregate(int id) const {
  std::set<int> members{id};
  for (bool grew = true; grew;) {
    grew = false;
    for (const Bond& bond : bonds_) {
      if (bond.rigid != 0 && members.count(bond.first) != members.count(bond.second)) {
        members.insert({bond.first, bond.second});
        grew = true;
      }
    }
  }
  return {members.begin(), members.end()};
}

std::string DemForces::save() const {
  std::string out;
  const auto put = [&out](const void* from, std::size_t size) {
    out.append(static_cast<const char*>(from), size);
  };
  const std::array<std::int64_t, 3> counts{static_cast<std::int64_t>(bonds_.size()),
                                           static_cast<std::int64_t>(parted_.size()),
                                           broken_};
  put(counts.data(), sizeof(counts));
  put(bonds_.data(), bonds_.size() * sizeof(Bond));
  for (const auto& [first, second] : parted_) {
    const std::array<std::int32_t, 2> ids{first, second};
    put(ids.data(), sizeof(ids));
  }
  return out;
}

void DemForces::restore(std::string& text) {
  std::size_t at = 0;
  const auto take = [&](void* to, std::size_t size) {
    if (at + size > text.size()) {
      throw InputError("DEM", "what was saved of the colloids is incomplete");
    }
    if (size > 0) {
      std::memcpy(to, text.data() + at, size);
    }
    at += size;
  };
  std::array<std::int64_t, 3> counts{};
  take(counts.data(), sizeof(counts));
  const auto most = static_cast<std::int64_t>(text.size());
  if (counts[0] < 0 || counts[0] > most || counts[1] < 0 || counts[1] > most) {
    throw InputError("DEM", "what was saved of the colloids is damaged");
  }
  bonds_.assign(static_cast<std::size_t>(counts[0]), Bond{});
  take(bonds_.data(), bonds_.size() * sizeof(Bond));
  joined_.clear();
  for (const Bond& bond : bonds_) {
    joined_.insert(key(bond.first, bond.second));
  }
  parted_.clear();
  for (std::int64_t i = 0; i < counts[1]; ++i) {
    std::array<std::int32_t, 2> ids{};
    take(ids.data(), sizeof(ids));
    parted_.insert({ids[0], ids[1]});
  }
  broken_ = counts[2];
  text.erase(0, at);
}

}  // namespace colloid
