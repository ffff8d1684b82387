#include "particles/one_way_motion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/constants.h"
#include "particles/unresolved_gap.h"

namespace colloid {

namespace {

Matrix6 shift_of(const Vec3& arm, double radius) {
  // Motion of the member: U + w x r, so (U, aw) -> (U - [r/a]x aw, aw).
  Matrix6 t = Matrix6::Identity();
  t.topRightCorner<3, 3>() = -skew(eigen(arm) / radius);
  return t;
}

BodyWrench from_wrench(const Vector6& six, double scale, double radius) {
  return {plain(six.head<3>()) * scale, plain(six.tail<3>()) * (scale * radius)};
}

struct Member {
  int body;
  int index;
  Vec3 position;
  AmbientMotion ambient;
};

Vector6 normal_row(const std::vector<RigidBody>& bodies, const Member& member,
                   const Vec3& n, double radius) {
  return normal_row(bodies[static_cast<std::size_t>(member.body)],
                    static_cast<std::size_t>(member.index), n, radius);
}

std::vector<Member> members_of(const std::vector<RigidBody>& bodies) {
  std::vector<Member> members;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t m = 0; m < bodies[b].size(); ++m) {
      members.push_back(
          {static_cast<int>(b), static_cast<int>(m), bodies[b].position(m), {}});
    }
  }
  return members;
}

}  // namespace

struct OneWayMotion::Assembly {
  std::vector<Member> members;
  std::vector<BodySystem> systems;
  std::vector<Vector6> loads;  ///< of weight and surface forces, part of the drives
  std::vector<PairTerm> pairs;
  std::vector<double> pair_loads;  ///< likewise, part of the pairs' drives
};

OneWayMotion::OneWayMotion(const OneWayOptions& options, const AmbientFlow& flow,
                           const FixedSurfaces& surfaces,
                           const std::vector<double>& grain_radii)
    : options_(options),
      drag_(6.0 * kPi * options.viscosity * options.radius),
      flow_(flow),
      surfaces_(surfaces) {
  if (options.wall_hindrance) {
    assert(surfaces.reach() >= hindrance_range(options.radius));
    std::vector<double> radii = grain_radii;
    radii.push_back(options.radius);  // retained colloids
    wall_hindrance_ = std::make_unique<SurfaceHindrance>(options.radius, radii);
  }
  if (options.pair_hindrance) {
    pair_hindrance_ = std::make_unique<EqualPairHindrance>();
  }
}

double OneWayMotion::surface_force(const NearSurface& surface) const {
  const SurfaceForces* forces = nullptr;
  switch (surface.id.kind) {
    case SurfaceId::Kind::grain:
      forces = options_.grain_forces.get();
      break;
    case SurfaceId::Kind::colloid:
      forces = options_.colloid_forces.get();
      break;
    default:
      forces = options_.wall_forces.get();
  }
  if (forces == nullptr || !is_surface(surfaces_.box(), surface.id)) {
    return 0.0;
  }
  const double least = contact_gap(options_.rules, surfaces_.box(), surface.id);
  return forces->force(std::max(surface.distance - options_.radius, least));
}

// Mobile colloids of different bodies: squeezing and shearing flow between them.
void OneWayMotion::add_pairs(const std::vector<RigidBody>& bodies, Assembly& out) const {
  const double a = options_.radius;
  std::vector<Member>& members = out.members;
  std::vector<Vec3> change(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (std::size_t j = i + 1; j < members.size(); ++j) {
      if (members[i].body == members[j].body) {
        continue;
      }
      const Vec3 e = shortest(surfaces_.box(), members[i].position, members[j].position);
      const double r = norm(e);
      const double gap = std::max(r - 2.0 * a, options_.rules.colloid_gap);
      if (gap >= kHindranceReach * a) {
        continue;
      }
      const PairHindrance pair = pair_hindrance_->at(gap / a);
      const Vec3 n = e * (1.0 / r);
      const Vec3 v = members[i].ambient.velocity - members[j].ambient.velocity;
      const Vec3 turn = 0.5 * (members[i].ambient.spin + members[j].ambient.spin);
      const Vec3 strain = v - cross(turn, e);
      const Vec3 across = strain - n * dot(strain, n);
      change[i] -= 0.5 * pair.shear * across;
      change[j] += 0.5 * pair.shear * across;

      PairTerm term;
      term.first = members[i].body;
      term.second = members[j].body;
      term.row_first = normal_row(bodies, members[i], n, a);
      term.row_second = -normal_row(bodies, members[j], n, a);
      term.strength = 0.5 * pair.squeeze;
      term.drive = 0.5 * pair.drive * dot(v, n);
      out.pair_loads.push_back(
          options_.colloid_forces ? options_.colloid_forces->force(gap) / drag_ : 0.0);
      term.drive += out.pair_loads.back();
      out.pairs.push_back(term);
    }
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    members[i].ambient.velocity += change[i];
  }
}

void OneWayMotion::add_surfaces(const std::vector<RigidBody>& bodies,
                                Assembly& out) const {
  const double a = options_.radius;
  const Box& box = surfaces_.box();
  std::vector<NearSurface> near;
  for (const Member& member : out.members) {
    const auto b = static_cast<std::size_t>(member.body);
    HeldColloid held = isolated();
    Vector6 load = Vector6::Zero();
    load.head<3>() = eigen(options_.weight) / drag_;
    const int id = bodies[b].members[static_cast<std::size_t>(member.index)].id;
    if (id >= 0 && id < static_cast<int>(options_.given.size())) {
      const BodyWrench& given = options_.given[static_cast<std::size_t>(id)];
      load.head<3>() += eigen(given.force) / drag_;
      load.tail<3>() += eigen(given.torque) / (drag_ * a);
    }
    const bool forces =
        options_.grain_forces || options_.wall_forces || options_.colloid_forces;
    if (wall_hindrance_ || forces) {
      surfaces_.near(member.position, near);
      for (const NearSurface& surface : near) {
        if (!is_surface(box, surface.id)) {
          continue;
        }
        if (wall_hindrance_) {
          wall_hindrance_->add(surface, contact_gap(options_.rules, box, surface.id),
                               member.ambient, held);
        }
        if (forces) {
          load.head<3>() += eigen(surface.normal) * surface_force(surface) / drag_;
        }
      }
    }
    let_shield_and_carry(member.ambient, a, held);
    held.drive += load;
    BodySystem& system = out.systems[b];
    if (bodies[b].size() == 1) {
      system.resistance += held.resistance;
      system.drive += held.drive;
      out.loads[b] += load;
    } else {
      const Matrix6 t =
          shift_of(bodies[b].arms[static_cast<std::size_t>(member.index)], a);
      system.resistance += t.transpose() * held.resistance * t;
      system.drive += t.transpose() * held.drive;
      out.loads[b] += t.transpose() * load;
    }
  }
}

OneWayMotion::Assembly OneWayMotion::assemble(
    const std::vector<RigidBody>& bodies) const {
  Assembly out;
  out.members = members_of(bodies);
  out.systems.resize(bodies.size());
  out.loads.assign(bodies.size(), Vector6::Zero());
  for (Member& member : out.members) {
    member.ambient = flow_.around(member.position, options_.radius);
  }
  if (pair_hindrance_) {
    add_pairs(bodies, out);
  }
  add_surfaces(bodies, out);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].bonds.empty()) {
      continue;
    }
    out.systems[b].freedom =
        motions_at_rest(bond_contacts(bodies[b], surfaces_.box(), options_.radius));
  }
  return out;
}

ContactRow OneWayMotion::contact_row(const std::vector<RigidBody>& bodies,
                                     const Contact& contact) const {
  const auto b = static_cast<std::size_t>(contact.body);
  const auto m = static_cast<std::size_t>(contact.member);
  const Vec3 x = bodies[b].position(m);
  Vec3 n;
  ContactRow row;
  row.first = contact.body;
  if (contact.other_body >= 0) {
    const auto other = static_cast<std::size_t>(contact.other_body);
    const auto other_m = static_cast<std::size_t>(contact.other_member);
    const Vec3 e = shortest(surfaces_.box(), x, bodies[other].position(other_m));
    n = e * (1.0 / norm(e));
    row.second = contact.other_body;
    row.row_second = -normal_row(bodies[other], other_m, n, options_.radius);
  } else {
    n = surfaces_.seen_from(x, contact.fixed).normal;
  }
  row.row_first = normal_row(bodies[b], m, n, options_.radius);
  return row;
}

Motion OneWayMotion::motion(const std::vector<RigidBody>& bodies,
                            const std::vector<Contact>& contacts,
                            const std::vector<BodyWrench>& extra) const {
  Assembly assembly = assemble(bodies);
  for (std::size_t b = 0; b < extra.size(); ++b) {
    assembly.systems[b].drive.head<3>() += eigen(extra[b].force) / drag_;
    assembly.systems[b].drive.tail<3>() +=
        eigen(extra[b].torque) / (drag_ * options_.radius);
  }
  std::vector<ContactRow> rows;
  rows.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    rows.push_back(contact_row(bodies, contact));
  }
  const BodyMotions solved = solve_motion(assembly.systems, assembly.pairs, rows);
  Motion out;
  for (const Vector6& motion : solved.motion) {
    out.velocity.push_back(plain(motion.head<3>()));
    out.spin.push_back(plain(motion.tail<3>()) * (1.0 / options_.radius));
  }
  for (double push : solved.contact_force) {
    out.contact_push.push_back(push * drag_);
  }
  for (const Vector6& wrench : solved.bond_wrench) {
    out.bond_wrench.push_back(from_wrench(wrench, drag_, options_.radius));
  }
  return out;
}

std::vector<BodyWrench> OneWayMotion::thermal_wrenches(
    const std::vector<RigidBody>& bodies, const std::vector<Vector6>& normals,
    double temperature, double step) const {
  const Assembly assembly = assemble(bodies);
  // <F F'> = 2 kT (6 pi mu a R) / step, F = 6 pi mu a f.
  const double scale = std::sqrt(2.0 * kBoltzmann * temperature * drag_ / step);
  std::vector<BodyWrench> out;
  for (const Vector6& w :
       correlated_wrenches(assembly.systems, assembly.pairs, normals)) {
    out.push_back(from_wrench(w, scale, options_.radius));
  }
  return out;
}

std::vector<BodyWrench> OneWayMotion::held_wrenches(
    const std::vector<RigidBody>& bodies) const {
  std::vector<BodyWrench> out;
  for (const BodySystem& system : assemble(bodies).systems) {
    out.push_back(from_wrench(system.drive, drag_, options_.radius));
  }
  return out;
}

// What common units, (U, a w) and (F, T/a) over the drag, leave out: 1 and a in turn.
Eigen::VectorXd OneWayMotion::arms(Eigen::Index size) const {
  Eigen::VectorXd arm = Eigen::VectorXd::Ones(size);
  for (Eigen::Index n = 0; n < size; ++n) {
    arm[n] = n % 6 < 3 ? 1.0 : options_.radius;
  }
  return arm;
}

Eigen::MatrixXd OneWayMotion::in_si(const Eigen::MatrixXd& resistance) const {
  const Eigen::VectorXd arm = arms(resistance.rows());
  return drag_ * arm.asDiagonal() * resistance * arm.asDiagonal();
}

LinearMotion OneWayMotion::linear(const std::vector<RigidBody>& bodies,
                                  const std::vector<Contact>& pressed) const {
  const Assembly assembly = assemble(bodies);
  const auto n = 6 * static_cast<Eigen::Index>(bodies.size());
  Eigen::MatrixXd resistance = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd drive(n), load(n);
  Eigen::MatrixXd freedom = Eigen::MatrixXd::Zero(n, n);
  Eigen::Index columns = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto at = 6 * static_cast<Eigen::Index>(b);
    const BodySystem& system = assembly.systems[b];
    resistance.block<6, 6>(at, at) = system.resistance;
    drive.segment<6>(at) = system.drive;
    load.segment<6>(at) = assembly.loads[b];
    freedom.block(at, columns, 6, system.freedom.cols()) = system.freedom;
    columns += system.freedom.cols();
  }
  freedom.conservativeResize(n, columns);
  for (std::size_t p = 0; p < assembly.pairs.size(); ++p) {
    const PairTerm& pair = assembly.pairs[p];
    Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
    row.segment<6>(6 * static_cast<Eigen::Index>(pair.first)) = pair.row_first;
    row.segment<6>(6 * static_cast<Eigen::Index>(pair.second)) = pair.row_second;
    resistance += pair.strength * row * row.transpose();
    drive += pair.drive * row;
    load += assembly.pair_loads[p] * row;
  }
  if (!pressed.empty() && columns > 0) {
    Eigen::MatrixXd rows =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(pressed.size()), n);
    for (std::size_t c = 0; c < pressed.size(); ++c) {
      const ContactRow row = contact_row(bodies, pressed[c]);
      const auto i = static_cast<Eigen::Index>(c);
      rows.row(i).segment<6>(6 * static_cast<Eigen::Index>(row.first)) =
          row.row_first.transpose();
      if (row.second >= 0) {
        rows.row(i).segment<6>(6 * static_cast<Eigen::Index>(row.second)) =
            row.row_second.transpose();
      }
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> split(rows * freedom);
    freedom = split.dimensionOfKernel() > 0 ? Eigen::MatrixXd(freedom * split.kernel())
                                            : Eigen::MatrixXd(n, 0);
  }
  LinearMotion out;
  out.resistance = in_si(resistance);
  const Eigen::VectorXd arm = arms(n);
  out.drive = drag_ * arm.cwiseProduct(drive);
  out.load = drag_ * arm.cwiseProduct(load);
  out.motions = arm.cwiseInverse().asDiagonal() * freedom;
  return out;
}

Matrix6 OneWayMotion::narrow_gaps(const Vec3& position, double cell) const {
  Matrix6 sum = Matrix6::Zero();
  std::vector<NearSurface> near;
  surfaces_.near(position, near);
  for (const NearSurface& surface : near) {
    if (is_surface(surfaces_.box(), surface.id)) {
      sum += unresolved_beside(*wall_hindrance_, surface, options_.radius,
                               contact_gap(options_.rules, surfaces_.box(), surface.id),
                               cell);
    }
  }
  return sum;
}

Eigen::MatrixXd OneWayMotion::lubrication(const std::vector<RigidBody>& bodies,
                                          double cell) const {
  const auto n = 6 * static_cast<Eigen::Index>(bodies.size());
  Eigen::MatrixXd beside = Eigen::MatrixXd::Zero(n, n);   // units of small_matrix.h
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(n, n);  // SI, over mu
  const std::vector<Member> members = members_of(bodies);
  const double a = options_.radius;
  const auto arm_of = [&](const Member& member) {
    return bodies[static_cast<std::size_t>(member.body)]
        .arms[static_cast<std::size_t>(member.index)];
  };
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& one = members[i];
    const auto at = 6 * static_cast<Eigen::Index>(one.body);
    if (wall_hindrance_) {
      const Matrix6 t = shift_of(arm_of(one), a);
      beside.block<6, 6>(at, at) += t.transpose() * narrow_gaps(one.position, cell) * t;
    }
    for (std::size_t j = i + 1; pair_hindrance_ && j < members.size(); ++j) {
      const Member& two = members[j];
      if (one.body == two.body) {
        continue;
      }
      const Vec3 e = shortest(surfaces_.box(), two.position, one.position);
      if (norm(e) - 2.0 * a >= kResolvedCells * cell) {
        continue;
      }
      const Matrix12 pair =
          unresolved_between(pair_hindrance_->resistance(), {one.position, a},
                             {one.position + e, a}, options_.rules.colloid_gap, cell);
      const std::array<Matrix6, 2> to_member{shift_of(arm_of(one), 1.0),
                                             shift_of(arm_of(two), 1.0)};
      const std::array<Eigen::Index, 2> place{at,
                                              6 * static_cast<Eigen::Index>(two.body)};
      for (Eigen::Index p = 0; p < 2; ++p) {
        for (Eigen::Index q = 0; q < 2; ++q) {
          const auto k = static_cast<std::size_t>(p);
          const auto l = static_cast<std::size_t>(q);
          between.block<6, 6>(place[k], place[l]) +=
              to_member[k].transpose() * pair.block<6, 6>(6 * p, 6 * q) * to_member[l];
        }
      }
    }
  }
  return in_si(beside) + options_.viscosity * between;
}

}  // namespace colloid
