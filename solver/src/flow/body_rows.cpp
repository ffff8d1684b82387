#include "flow/body_rows.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "flow/row_balance.h"

namespace colloid {

namespace {

// Of the largest, below which an entry has cancelled: inside a body.
constexpr double kCancelled = 1e-12;

// Calls visit(indices, entry) once for every place near a moving sphere.
template <class Visit>
void for_near(const WallRows& rows, int component, const Visit& visit) {
  const Grid& grid = rows.grid();
  std::vector<std::size_t> places;
  for (const WallRows::IndexBox& box : rows.moving_boxes(component)) {
    for (int k = box.begin[2]; k < box.end[2]; ++k) {
      for (int j = box.begin[1]; j < box.end[1]; ++j) {
        for (int i = box.begin[0]; i < box.end[0]; ++i) {
          places.push_back(grid.index(i, j, k));
        }
      }
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (std::size_t q : places) {
    visit(grid.place(q), q);
  }
}

}  // namespace

BodyRows::BodyRows(const WallRows& rows, const std::vector<Body>& bodies)
    : bodies_(bodies.size()), first_sphere_(rows.fixed_count()) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const Sphere& sphere : bodies[b].spheres) {
      body_of_sphere_.push_back(b);
      arm_of_sphere_.push_back(sphere.center - bodies[b].centre);
    }
  }
  const auto n = static_cast<Eigen::Index>(size());
  self_ = Eigen::MatrixXd::Zero(n, n);
  volumes_ = Eigen::MatrixXd::Zero(n, 3);
  make_columns(rows);
  make_rows(rows);
}

// Component of U + w x r as a linear form of (U, w); the moment of a unit force likewise.
RigidMotion BodyRows::velocity_of(int component, int sphere,
                                  const Vec3& from_center) const {
  Vec3 along;
  along[component] = 1.0;
  const Vec3 arm =
      from_center + arm_of_sphere_[static_cast<std::size_t>(sphere - first_sphere_)];
  const Vec3 turn = cross(arm, along);
  RigidMotion form;
  form << along.x, along.y, along.z, turn.x, turn.y, turn.z;
  return form;
}

void BodyRows::make_columns(const WallRows& rows) {
  const auto& m = rows.coefficients();
  std::vector<WallRows::SurfaceTerm> terms;
  for (int c = 0; c < 3; ++c) {
    const auto s = static_cast<std::size_t>(c);
    for_near(rows, c, [&](const std::array<int, 3>& at, std::size_t q) {
      if (m.row_scale[s][q] > 0.0F) {
        rows.surface_terms(c, at, terms);
        add_open_row(c, q, terms);
      } else if (!rows.on_given_face(c, at)) {
        add_closed_face(rows, c, at);
      }
    });
  }
  sort_columns(rows.grid());
  for_near(rows, pressure, [&](const std::array<int, 3>& at, std::size_t q) {
    if (m.cell_scale[q] <= 0.0F) {
      closed_cells_.push_back(q);
      cell_neighbours_.push_back(open_neighbours(rows, at));
    }
  });
}

void BodyRows::add_open_row(int component, std::size_t q,
                            const std::vector<WallRows::SurfaceTerm>& terms) {
  const auto s = static_cast<std::size_t>(component);
  for (const auto& term : terms) {
    if (term.sphere < first_sphere_) {
      continue;
    }
    const std::size_t body = body_of(term.sphere);
    const RigidMotion form =
        term.weight * velocity_of(component, term.sphere, term.from_center);
    if (!columns_.empty() && columns_.back().component == s && columns_.back().at == q &&
        columns_.back().body == body) {
      columns_.back().coefficient += form;
    } else {
      columns_.push_back({s, q, body, form});
    }
  }
}

// Its velocity, which also enters the divergence of the cells on both sides: -D lift.
void BodyRows::add_closed_face(const WallRows& rows, int component,
                               const std::array<int, 3>& at) {
  const Grid& grid = rows.grid();
  const auto s = static_cast<std::size_t>(component);
  const NearestSurface owner = rows.nearest(component, at[0], at[1], at[2]);
  if (owner.sphere < first_sphere_) {
    return;
  }
  const std::size_t body = body_of(owner.sphere);
  const RigidMotion form = velocity_of(component, owner.sphere, owner.from_center);
  closed_.push_back({s, grid.index(at[0], at[1], at[2]), body, form});
  for (int side = 0; side < 2; ++side) {
    std::array<int, 3> cell = at;
    cell[s] -= side;
    cell = grid.wrapped(cell);
    if (!grid.contains(pressure, cell)) {
      continue;
    }
    const std::size_t p = grid.index(cell[0], cell[1], cell[2]);
    if (rows.coefficients().cell_scale[p] > 0.0F) {
      const double over_width = static_cast<double>(
          rows.axes()[s].divergence[static_cast<std::size_t>(cell[s]) + 1]);
      const double sign = side == 0 ? 1.0 : -1.0;
      columns_.push_back({pressure, p, body, sign * over_width * form});
    }
  }
}

void BodyRows::sort_columns(const Grid& grid) {
  std::stable_sort(columns_.begin(), columns_.end(), [&](const Term& a, const Term& b) {
    return grid.place(a.at)[2] < grid.place(b.at)[2];
  });
  planes_.assign(static_cast<std::size_t>(grid.cells[2]) + 2, columns_.size());
  for (std::size_t n = columns_.size(); n-- > 0;) {
    planes_[static_cast<std::size_t>(grid.place(columns_[n].at)[2])] = n;
  }
  for (std::size_t k = planes_.size() - 1; k-- > 0;) {
    planes_[k] = std::min(planes_[k], planes_[k + 1]);
  }
}

// What one body's wrench takes of every entry, in the order of the entries.
struct BodyRows::Forms {
  std::array<std::map<std::size_t, RigidMotion>, 4> of_component;

  void add(int component, std::size_t entry, const RigidMotion& form) {
    of_component[static_cast<std::size_t>(component)]
        .try_emplace(entry, RigidMotion::Zero())
        .first->second += form;
  }
  double largest() const {
    double size = 0.0;
    for (const auto& entries : of_component) {
      for (const auto& [entry, form] : entries) {
        size = std::max(size, form.lpNorm<Eigen::Infinity>());
      }
    }
    return size;
  }
};

void BodyRows::make_rows(const WallRows& rows) {
  const RowBalance balance(rows);
  std::vector<Forms> forms(bodies_);
  for (int c = 0; c < 3; ++c) {
    for_near(rows, c, [&](const std::array<int, 3>& at, std::size_t) {
      const NearestSurface surface = rows.nearest(c, at[0], at[1], at[2]);
      if (rows.on_given_face(c, at) || surface.sphere < first_sphere_) {
        return;
      }
      const std::size_t body = body_of(surface.sphere);
      const RigidMotion form = velocity_of(c, surface.sphere, surface.from_center);
      balance.visit(
          c, at,
          [&](std::size_t entry, double w) { forms[body].add(c, entry, w * form); },
          [&](std::size_t entry, double w) {
            forms[body].add(pressure, entry, w * form);
          },
          [&](int, std::size_t entry, double w) {
            forms[body].add(c, entry, -w * form);
          });
      volumes_.block<6, 1>(6 * static_cast<Eigen::Index>(body), c) +=
          balance.volume(c, at) * form;
    });
  }
  for (std::size_t b = 0; b < bodies_; ++b) {
    const double least = kCancelled * forms[b].largest();
    for (int c = 0; c < 4; ++c) {
      for (const auto& [entry, form] :
           forms[b].of_component[static_cast<std::size_t>(c)]) {
        if (form.lpNorm<Eigen::Infinity>() > least) {
          sort_out(rows, {static_cast<std::size_t>(c), entry, b, form});
        }
      }
    }
  }
}

// An entry of D: of an unknown, of something given, or of a closed face or cell.
void BodyRows::sort_out(const WallRows& rows, const Term& term) {
  const Grid& grid = rows.grid();
  const auto& m = rows.coefficients();
  const int component = static_cast<int>(term.component);
  const std::array<int, 3> at = grid.wrapped(grid.place(term.at));
  if (!grid.contains(component, at) ||
      (component < 3 && rows.on_given_face(component, at))) {
    given_.push_back(term);
    return;
  }
  const std::size_t q = grid.index(at[0], at[1], at[2]);
  const auto& open = component < 3 ? m.row_scale[term.component] : m.cell_scale;
  if (open[q] > 0.0F) {
    rows_.push_back({term.component, q, term.body, term.coefficient});
    return;
  }
  if (component == pressure) {
    const auto neighbours = open_neighbours(rows, at);
    for (std::size_t n : neighbours) {
      rows_.push_back({term.component, n, term.body,
                       term.coefficient / static_cast<double>(neighbours.size())});
    }
    return;
  }
  const NearestSurface owner = rows.nearest(component, at[0], at[1], at[2]);
  if (owner.sphere >= first_sphere_) {
    self_.block<6, 6>(6 * static_cast<Eigen::Index>(term.body),
                      6 * static_cast<Eigen::Index>(body_of(owner.sphere))) +=
        term.coefficient *
        velocity_of(component, owner.sphere, owner.from_center).transpose();
  }
}

template <class Real>
void BodyRows::add_columns(const Eigen::VectorXd& v, StokesVector<Real>& w, int k) const {
  for (std::size_t n = planes_[static_cast<std::size_t>(k)];
       n < planes_[static_cast<std::size_t>(k) + 1]; ++n) {
    const Term& term = columns_[n];
    const double value =
        term.coefficient.dot(v.segment<6>(6 * static_cast<Eigen::Index>(term.body)));
    w.a[term.component][term.at] += static_cast<Real>(value);
  }
}

template <class Real>
Eigen::VectorXd BodyRows::apply_rows(const StokesVector<Real>& x) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size()));
  for (const Term& term : rows_) {
    sum.segment<6>(6 * static_cast<Eigen::Index>(term.body)) +=
        static_cast<double>(x.a[term.component][term.at]) * term.coefficient;
  }
  return sum;
}

Eigen::VectorXd BodyRows::constant(const Vec3& force,
                                   const StokesVector<double>& lift) const {
  Eigen::VectorXd sum = volumes_ * Eigen::Vector3d(force.x, force.y, force.z);
  for (const Term& term : given_) {
    sum.segment<6>(6 * static_cast<Eigen::Index>(term.body)) +=
        lift.a[term.component][term.at] * term.coefficient;
  }
  return sum;
}

void BodyRows::fill_bodies(const Eigen::VectorXd& v, StokesVector<double>& x) const {
  for (const Term& term : closed_) {
    x.a[term.component][term.at] =
        term.coefficient.dot(v.segment<6>(6 * static_cast<Eigen::Index>(term.body)));
  }
}

void BodyRows::fill_pressure(StokesVector<double>& x) const {
  auto& p = x.a[pressure];
  for (std::size_t n = 0; n < closed_cells_.size(); ++n) {
    double sum = 0.0;
    for (std::size_t q : cell_neighbours_[n]) {
      sum += p[q];
    }
    const std::size_t count = cell_neighbours_[n].size();
    p[closed_cells_[n]] = count > 0 ? sum / static_cast<double>(count) : 0.0;
  }
}

void BodyRows::clear(const WallRows& rows, StokesVector<double>& x) const {
  const auto& m = rows.coefficients();
  for (const Term& term : closed_) {
    if (m.row_scale[term.component][term.at] <= 0.0F) {
      x.a[term.component][term.at] = 0.0;
    }
  }
  for (std::size_t q : closed_cells_) {
    if (m.cell_scale[q] <= 0.0F) {
      x.a[pressure][q] = 0.0;
    }
  }
}

template void BodyRows::add_columns(const Eigen::VectorXd&, StokesVector<float>&,
                                    int) const;
template void BodyRows::add_columns(const Eigen::VectorXd&, StokesVector<double>&,
                                    int) const;
template Eigen::VectorXd BodyRows::apply_rows(const StokesVector<float>&) const;
template Eigen::VectorXd BodyRows::apply_rows(const StokesVector<double>&) const;

}  // namespace colloid
