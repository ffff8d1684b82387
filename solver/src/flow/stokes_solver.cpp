#include "flow/stokes_solver.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

#include <Eigen/Dense>

#include "core/error.h"
#include "flow/clock.h"
#include "flow/connectivity.h"
#include "flow/halo.h"
#include "flow/kernels.h"
#include "flow/planes.h"

namespace colloid {

namespace {

using Kind = FlowDrive::Kind;

// Transverse response, relative, below which an axis needs no force to hold its mean
// zero.
constexpr double kUncoupled = 1e-9;
constexpr double kLoosest = 0.05;  // tolerance of a sideways unit problem

// Points per side at which a face of the inlet is sampled for its open part.
constexpr int kInletSamples = 16;

// Part of an inlet's width, next to a wall, left out of its mean pressure.
constexpr double kCoreMargin = 0.25;

std::string scientific(double value) {
  std::ostringstream text;
  text << std::scientific << std::setprecision(2) << value;
  return text.str();
}

FlowFaces make_faces(const StokesProblem& problem, double pressure_unit) {
  FlowFaces faces;
  for (std::size_t f = 0; f < kFaces; ++f) {
    FlowFace& face = faces[f];
    const int axis = axis_of(static_cast<int>(f));
    const bool upper = is_upper(static_cast<int>(f));
    switch (problem.box.faces[f]) {
      case FaceCondition::wall:
        if (problem.drive.kind == Kind::shear_rate && f == z_plus) {
          face.velocity.x = problem.drive.shear_rate * problem.box.size.z;
        }
        break;
      case FaceCondition::inlet:
        if (problem.drive.kind == Kind::inlet_velocity) {
          face.velocity[axis] = (upper ? -1.0 : 1.0) * problem.drive.inlet_velocity;
        } else {
          face.kind = FlowFace::Kind::pressure;
          face.pressure = problem.drive.pressure_drop / pressure_unit;
        }
        break;
      case FaceCondition::outlet:
        face.kind = FlowFace::Kind::pressure;
        break;
      case FaceCondition::periodic:
        face.kind = FlowFace::Kind::periodic;
        break;
      case FaceCondition::symmetry:
        face.kind = FlowFace::Kind::symmetry;
        break;
    }
  }
  return faces;
}

// Calls visit(i, j, k) with the indices of the faces on one face of the box, the index of
// the face along its axis included.
template <class Visit>
void for_boundary(const Grid& grid, int face, const Visit& visit) {
  const int axis = axis_of(face);
  const auto a = static_cast<std::size_t>(axis);
  const std::size_t t1 = (a + 1) % 3;
  const std::size_t t2 = (a + 2) % 3;
  std::array<int, 3> at{};
  at[a] = is_upper(face) ? grid.cells[a] : 0;
  for (at[t2] = 0; at[t2] < grid.cells[t2]; ++at[t2]) {
    for (at[t1] = 0; at[t1] < grid.cells[t1]; ++at[t1]) {
      visit(at);
    }
  }
}

std::size_t inner_cell(const Grid& grid, int face, std::array<int, 3> at) {
  if (is_upper(face)) {
    --at[static_cast<std::size_t>(axis_of(face))];
  }
  return grid.index(at[0], at[1], at[2]);
}

}  // namespace

StokesSolver::StokesSolver(const StokesProblem& problem, const StokesOptions& options)
    : problem_(problem), options_(options) {
  length_ = std::numeric_limits<double>::max();
  for (int a = 0; a < 3; ++a) {
    length_ = std::min(
        length_, problem_.box.size[a] / problem_.cells[static_cast<std::size_t>(a)]);
  }
  build();
}

void StokesSolver::build() {
  const double start = wall_seconds();
  faces_ = make_faces(problem_, pressure_unit());
  std::array<bool, 3> periodic{};
  for (int a = 0; a < 3; ++a) {
    periodic[static_cast<std::size_t>(a)] = problem_.box.periodic(a);
  }
  for (const Sphere& s : problem_.spheres) {
    grid_spheres_.push_back({s.center * (1.0 / length_), s.radius / length_});
  }
  rows_ = std::make_unique<WallRows>(
      make_grid(problem_.box.size * (1.0 / length_), problem_.cells, periodic), faces_);
  rows_->add(grid_spheres_);
  connect();
  multigrid_ = std::make_unique<Multigrid>(*rows_, faces_, grid_spheres_, CycleOptions{},
                                           options_.threads);
  krylov_ = std::make_unique<Fgmres>(*rows_);
  const std::size_t size = rows_->grid().size;
  x_ = StokesVector<double>(size);
  flow_ = StokesVector<double>(size);
  lift_ = StokesVector<double>(size);
  drive_ = StokesVector<double>(size);
  near_given_.assign(static_cast<std::size_t>(view(*rows_).end[2]), false);
  if (problem_.drive.kind == Kind::body_force) {
    grid_force_ = problem_.drive.body_force * (length_ / pressure_unit());
  }
  make_lift();
  make_drive();
  statistics_.setup_seconds = wall_seconds() - start;
}

void StokesSolver::add_spheres(const std::vector<Sphere>& spheres) {
  const double start = wall_seconds();
  std::vector<Sphere> added;
  for (const Sphere& s : spheres) {
    problem_.spheres.push_back(s);
    added.push_back({s.center * (1.0 / length_), s.radius / length_});
    grid_spheres_.push_back(added.back());
  }
  rows_->add(added);
  connect();
  multigrid_->add(added);
  make_lift();
  make_drive();
  clear_entries(rows_->closed_entries(), x_);
  for (auto& u : unit_) {
    if (!u.a[0].empty()) {
      clear_entries(rows_->closed_entries(), u);
    }
  }
  statistics_.setup_seconds = wall_seconds() - start;
}

// Every inlet with a given flux must reach an outlet.
void StokesSolver::connect() {
  const Grid& grid = rows_->grid();
  inlet_open_.assign(grid.size, true);
  statistics_.subgrid_openings = 0;
  blocked_ = false;
  std::vector<std::size_t> in, out;
  for (int f = 0; f < kFaces; ++f) {
    for_boundary(grid, f, [&](const std::array<int, 3>& at) {
      const std::size_t cell = inner_cell(grid, f, at);
      if (rows_->coefficients().cell_scale[cell] <= 0.0F) {
        return;
      }
      if (problem_.box.face(f) == FaceCondition::inlet) {
        in.push_back(cell);
      } else if (problem_.box.face(f) == FaceCondition::outlet) {
        out.push_back(cell);
      }
    });
  }
  Connectivity regions(*rows_, true);
  const auto open = [&] {
    if (!in.empty() || problem_.drive.kind == Kind::inlet_velocity) {
      return regions.joined(in, out);
    }
    const int axis = flow_axis();
    return axis < 0 || !problem_.box.periodic(axis) || winds_around(*rows_, axis);
  };
  if (!open()) {
    statistics_.subgrid_openings = open_subgrid_throats(*rows_, grid_spheres_);
    regions = Connectivity(*rows_, true);
    blocked_ = !open();
    require(!blocked_ || problem_.drive.kind != Kind::inlet_velocity,
            "/drive/inlet_velocity",
            "the way from the inlet to the outlet is blocked, no flux can be held; a "
            "pressure_drop can");
  }
  std::vector<bool> reaches(grid.size, false);
  for (std::size_t cell : out) {
    reaches[regions.label(cell)] = true;
  }
  for (std::size_t cell : in) {
    inlet_open_[cell] = reaches[regions.label(cell)];
  }
}

double StokesSolver::open_fraction(int component, const std::array<int, 3>& at) const {
  const Grid& grid = rows_->grid();
  const int t1 = (component + 1) % 3;
  const int t2 = (component + 2) % 3;
  const Vec3 centre = grid.location(component, at[0], at[1], at[2]);
  const auto width = [&](int t) {
    const auto s = static_cast<std::size_t>(t);
    return grid.width[s][static_cast<std::size_t>(at[s])];
  };
  if (rows_->nearest(component, at[0], at[1], at[2]).distance >
      0.5 * (width(t1) + width(t2))) {
    return 1.0;
  }
  int open = 0;
  for (int m = 0; m < kInletSamples; ++m) {
    for (int n = 0; n < kInletSamples; ++n) {
      Vec3 x = centre;
      x[t1] += ((m + 0.5) / kInletSamples - 0.5) * width(t1);
      x[t2] += ((n + 0.5) / kInletSamples - 0.5) * width(t2);
      bool solid = false;
      for (const Sphere& s : grid_spheres_) {
        solid = solid || norm(x - s.center) < s.radius;
      }
      open += solid ? 0 : 1;
    }
  }
  return static_cast<double>(open) / (kInletSamples * kInletSamples);
}

void StokesSolver::make_lift() {
  const Grid& grid = rows_->grid();
  clear_entries(given_, lift_);
  given_.clear();
  const auto give = [&](int component, std::size_t at, int k, double value) {
    if (value == 0.0) {
      return;
    }
    const auto c = static_cast<std::size_t>(component);
    lift_.a[c][at] = value;
    given_.push_back({c, at});
    for (int plane = k - 1; plane <= k + 1; ++plane) {
      if (plane >= 0 && plane < static_cast<int>(near_given_.size())) {
        near_given_[static_cast<std::size_t>(plane)] = true;
      }
    }
  };
  for (int f = 0; f < kFaces; ++f) {
    const FlowFace& face = faces_[static_cast<std::size_t>(f)];
    const int axis = axis_of(f);
    const std::ptrdiff_t beyond = grid.stride(axis) * (is_upper(f) ? 1 : -1);
    for_boundary(grid, f, [&](const std::array<int, 3>& at) {
      const std::size_t q = grid.index(at[0], at[1], at[2]);
      const std::size_t cell = inner_cell(grid, f, at);
      const auto ghost =
          static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + beyond);
      if (face.kind == FlowFace::Kind::pressure) {
        give(pressure, ghost, at[2], face.pressure);
      } else if (face.kind == FlowFace::Kind::velocity) {
        for (int c = 0; c < 3; ++c) {
          if (c != axis) {
            give(c, ghost, at[2], face.velocity[c]);
          } else if (face.velocity[c] != 0.0 && inlet_open_[cell] &&
                     rows_->coefficients().cell_scale[cell] > 0.0F) {
            give(c, q, at[2], face.velocity[c] * open_fraction(axis, at));
          }
        }
      }
    });
  }
}

// drive = S f - M lift in open rows and cells; the second part only in planes that see
// given values: for an inlet across z two or three of them.
void StokesSolver::make_drive() {
  const Grid& grid = rows_->grid();
  const LevelView level = view(*rows_);
  const auto& m = rows_->coefficients();
  double square = 0.0;
  for (int k = 0; k < level.end[2]; ++k) {
    const bool near_given = near_given_[static_cast<std::size_t>(k)];
    if (!near_given && dot(grid_force_, grid_force_) == 0.0) {
      continue;
    }
    if (near_given) {
      minus_apply_plane(level, lift_, drive_, k);
    }
    const std::size_t begin = grid.index(-1, -1, k);
    const std::size_t end = begin + static_cast<std::size_t>(grid.stride_z);
    for (std::size_t c = 0; c < 4; ++c) {
      const auto& open = c < 3 ? m.row_scale[c] : m.cell_scale;
      const double force = c < 3 ? grid_force_[static_cast<int>(c)] : 0.0;
      auto& b = drive_.a[c];
      for (std::size_t q = begin; q < end; ++q) {
        const double inner = near_given && open[q] > 0.0F ? b[q] : 0.0;
        b[q] = inner + force * static_cast<double>(open[q]);
      }
    }
    square += dot_plane(level, drive_, drive_, k);
  }
  drive_norm_ = std::sqrt(square);
}

void StokesSolver::superpose_flow() {
  for (std::size_t c = 0; c < 4; ++c) {
    auto& flow = flow_.a[c];
    if (problem_.drive.kind != Kind::mean_velocity) {
      flow = x_.a[c];
      continue;
    }
    std::fill(flow.begin(), flow.end(), 0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double force = grid_force_[static_cast<int>(axis)];
      if (force != 0.0) {
        for (std::size_t q = 0; q < flow.size(); ++q) {
          flow[q] += force * unit_[axis].a[c][q];
        }
      }
    }
    fill_halo(rows_->grid(), flow.data());
  }
  for (const Entry& e : given_) {
    flow_.a[e.component][e.at] += lift_.a[e.component][e.at];
  }
}

// 2-norm of the forces by pressure in the rows of x.
double StokesSolver::pressure_norm(StokesVector<double>& x) const {
  const LevelView level = view(*rows_);
  fill_halo(rows_->grid(), x[pressure]);
  return std::sqrt(sum_planes(level.end[2], options_.threads,
                              [&](int k) { return pressure_square_plane(level, x, k); }));
}

// The residual is the difference of viscous forces, forces by pressure and the drive, and
// is compared with the largest of them: the drive's alone would ask ever more of a throat
// that clogs, whose pressure grows (Arioli, Duff & Ruiz 1992).  The pressure is that of
// the solution at the start.
void StokesSolver::solve_system(const StokesVector<double>& b, StokesVector<double>& x,
                                BorderedPart* part, double drive_norm, double tolerance) {
  KrylovOptions krylov;
  krylov.max_iterations = options_.max_iterations;
  krylov.threads = options_.threads;
  const auto precondition = [&](const StokesVector<float>& r, StokesVector<float>& z,
                                bool light) { multigrid_->apply(r, z, light); };
  double scale = std::max(drive_norm, pressure_norm(x));
  double relative = 0.0;
  bool enough = false;
  while (!enough) {
    krylov.target = tolerance * scale;
    const double start = wall_seconds();
    const double cpu_start = processor_seconds();
    const KrylovStatistics found = krylov_->solve(b, x, part, precondition, krylov);
    // By processor time: other programs on the machine hardly change the ratio.
    statistics_.work_units += (processor_seconds() - cpu_start) / found.residual_seconds;
    statistics_.seconds += wall_seconds() - start;
    statistics_.iterations += found.iterations;
    statistics_.residual_ns_per_cell =
        1e9 * found.residual_seconds / static_cast<double>(rows_->grid().cell_count());
    if (!found.converged) {
      throw ConvergenceError(
          "Stokes solver: residual " + std::to_string(found.residual / scale) +
          " of the drive's or the pressure's after " + std::to_string(found.iterations) +
          " iterations, wanted " + scientific(tolerance));
    }
    // A deposit that opens lets the pressure fall, and more is asked.
    scale = std::min(scale, std::max(drive_norm, pressure_norm(x)));
    enough = found.residual <= tolerance * scale;
    relative = scale > 0.0 ? found.residual / scale : 0.0;
  }
  statistics_.relative_residual =
      std::max(statistics_.relative_residual, relative * options_.tolerance / tolerance);
}

void StokesSolver::start_statistics() {
  const double setup = statistics_.setup_seconds;
  const int openings = statistics_.subgrid_openings;
  statistics_ = StokesStatistics{};
  statistics_.setup_seconds = setup;
  statistics_.subgrid_openings = openings;
  statistics_.converged = true;
}

const StokesStatistics& StokesSolver::solve() {
  start_statistics();
  if (problem_.drive.kind == Kind::mean_velocity) {
    solve_mean_velocity();
    return statistics_;
  }
  solve_system(drive_, x_, nullptr, drive_norm_, options_.tolerance);
  superpose_flow();
  return statistics_;
}

namespace {

// Weight of the bodies' equations, as velocities, beside one row of the flow's.
constexpr double kBorderWeight = 1.0;

// The balances of the bodies as a border: q in units that make its own matrix about one.
class BodyBorder : public KrylovBorder {
 public:
  BodyBorder(const BodyRows& rows, const Eigen::MatrixXd& motions,
             const Eigen::MatrixXd& resistance, const Eigen::MatrixXd& guess,
             double weight)
      : rows_(rows),
        motions_(motions / weight),
        projection_(Eigen::MatrixXd::Zero(motions.cols(), motions.rows())) {
    if (motions.cols() > 0) {
      projection_ =
          weight *
          (motions.transpose() * guess * motions).ldlt().solve(motions.transpose());
    }
    own_ = projection_ * (resistance - rows.self()) * motions_;
  }

  std::size_t size() const override { return static_cast<std::size_t>(motions_.cols()); }
  void add_columns(const Eigen::VectorXd& q, StokesVector<double>& w,
                   int k) const override {
    rows_.add_columns(motions_ * q, w, k);
  }
  void add_columns(const Eigen::VectorXd& q, StokesVector<float>& w,
                   int k) const override {
    rows_.add_columns(motions_ * q, w, k);
  }
  Eigen::VectorXd rows(const StokesVector<double>& x,
                       const Eigen::VectorXd& q) const override {
    return own_ * q - projection_ * rows_.apply_rows(x);
  }
  Eigen::VectorXd rows(const StokesVector<float>& x,
                       const Eigen::VectorXd& q) const override {
    return own_ * q - projection_ * rows_.apply_rows(x);
  }
  Eigen::VectorXd right_side(const Eigen::VectorXd& wrench) const {
    return projection_ * wrench;
  }
  Eigen::VectorXd motion(const Eigen::VectorXd& q) const { return motions_ * q; }
  /// q of the motion nearest to v.
  Eigen::VectorXd unknowns(const Eigen::VectorXd& v) const {
    if (motions_.cols() == 0) {
      return Eigen::VectorXd::Zero(0);
    }
    return motions_.completeOrthogonalDecomposition().solve(v);
  }

 private:
  const BodyRows& rows_;
  Eigen::MatrixXd motions_, projection_, own_;
};

}  // namespace

// Grid units: angular velocities times the length unit; forces over viscosity and length.
Eigen::VectorXd StokesSolver::grid_motion(const Eigen::VectorXd& v) const {
  Eigen::VectorXd out = v;
  for (Eigen::Index n = 0; n < v.size(); ++n) {
    out[n] *= n % 6 < 3 ? 1.0 : length_;
  }
  return out;
}

Eigen::VectorXd StokesSolver::grid_wrench(const Eigen::VectorXd& wrench) const {
  Eigen::VectorXd out = wrench / (problem_.viscosity * length_);
  for (Eigen::Index n = 0; n < out.size(); ++n) {
    out[n] /= n % 6 < 3 ? 1.0 : length_;
  }
  return out;
}

Eigen::MatrixXd StokesSolver::grid_resistance(const Eigen::MatrixXd& resistance) const {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(resistance.rows());
  return grid_wrench(ones).asDiagonal() * resistance *
         grid_motion(ones).cwiseInverse().asDiagonal();
}

void StokesSolver::set_bodies(const std::vector<MovingBody>& bodies) {
  require(problem_.drive.kind != Kind::mean_velocity || bodies.empty(),
          "/drive/mean_velocity",
          "holds no flux past bodies that move; expected a body_force");
  const double start = wall_seconds();
  if (body_rows_) {
    body_rows_->fill_bodies(grid_motion(body_motion_), x_);
    body_rows_->fill_pressure(x_);
  }
  bodies_ = bodies;
  std::vector<Sphere> spheres;
  std::vector<BodyRows::Body> grid_bodies;
  moving_spheres_.clear();
  for (const MovingBody& body : bodies) {
    BodyRows::Body grid_body{body.centre * (1.0 / length_), {}};
    for (const Sphere& s : body.spheres) {
      const Sphere sphere{s.center * (1.0 / length_), s.radius / length_};
      grid_body.spheres.push_back(sphere);
      spheres.push_back(sphere);
      moving_spheres_.push_back({sphere, static_cast<Eigen::Index>(grid_bodies.size()),
                                 sphere.center - grid_body.centre});
    }
    grid_bodies.push_back(grid_body);
  }
  rows_->set_moving(spheres);
  connect();
  multigrid_->set_moving(spheres);
  make_lift();
  make_drive();
  clear_entries(rows_->closed_entries(), x_);
  if (body_rows_) {
    body_rows_->clear(*rows_, x_);
  }
  body_rows_ = std::make_unique<BodyRows>(*rows_, grid_bodies);
  body_motion_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(body_rows_->size()));
  statistics_.setup_seconds = wall_seconds() - start;
}

const StokesStatistics& StokesSolver::solve(const BodyBalance& balance) {
  if (bodies_.empty()) {
    return solve();
  }
  start_statistics();
  const Eigen::VectorXd given = grid_motion(balance.given);
  const auto n = given.size();
  const Eigen::VectorXd scale = grid_motion(Eigen::VectorXd::Ones(n));
  const Eigen::MatrixXd motions = scale.asDiagonal() * balance.motions;
  const Eigen::MatrixXd resistance = balance.resistance.size() == 0
                                         ? Eigen::MatrixXd::Zero(n, n)
                                         : grid_resistance(balance.resistance);
  const double weight = kBorderWeight * rows_->coefficients().diagonal;
  const BodyBorder border(*body_rows_, motions, resistance,
                          grid_resistance(balance.guess), weight);
  BorderedPart part{border, {}, {}};
  const Eigen::VectorXd at_rest = body_rows_->constant(grid_force_, lift_) +
                                  grid_wrench(balance.load) +
                                  (body_rows_->self() - resistance) * given;
  part.g = border.right_side(at_rest);
  part.q = border.unknowns(grid_motion(body_motion_) - given);

  StokesVector<double> right_side = drive_;
  double square = 0.0;
  const LevelView level = view(*rows_);
  for (int k = 0; k < level.end[2]; ++k) {
    body_rows_->add_columns(given, right_side, k);
    square += dot_plane(level, right_side, right_side, k);
  }
  solve_system(right_side, x_, &part, std::sqrt(square + part.g.squaredNorm()),
               options_.tolerance);
  const Eigen::VectorXd motion = given + border.motion(part.q);
  body_motion_ = motion.cwiseQuotient(scale);
  superpose_flow();
  body_rows_->fill_bodies(motion, flow_);
  return statistics_;
}

const Sphere& StokesSolver::sphere_in_rows(int sphere) const {
  const auto s = static_cast<std::size_t>(sphere);
  return s < grid_spheres_.size() ? grid_spheres_[s]
                                  : moving_spheres_.at(s - grid_spheres_.size()).sphere;
}

Vec3 StokesSolver::surface_velocity(int sphere, const Vec3& from_centre) const {
  const auto s = static_cast<std::size_t>(sphere);
  if (s < grid_spheres_.size()) {
    return {};
  }
  const MovingSphere& moving = moving_spheres_.at(s - grid_spheres_.size());
  const auto v = body_motion_.segment<6>(6 * moving.body);
  return Vec3{v[0], v[1], v[2]} +
         cross(Vec3{v[3], v[4], v[5]}, (moving.arm + from_centre) * length_);
}

Eigen::VectorXd StokesSolver::body_wrench() const {
  const Eigen::VectorXd motion = grid_motion(body_motion_);
  const Eigen::VectorXd wrench = body_rows_->apply_rows(x_) +
                                 body_rows_->self() * motion +
                                 body_rows_->constant(grid_force_, lift_);
  const Eigen::VectorXd units = grid_wrench(Eigen::VectorXd::Ones(wrench.size()));
  return wrench.cwiseQuotient(units);
}

void StokesSolver::solve_unit_force(int axis, double tolerance) {
  auto& x = unit_[static_cast<std::size_t>(axis)];
  if (x.a[0].empty()) {
    x = StokesVector<double>(rows_->grid().size);
  }
  grid_force_ = Vec3{};
  grid_force_[axis] = 1.0;
  make_drive();
  solve_system(drive_, x, nullptr, drive_norm_, tolerance);
}

// The body force that gives the mean velocity wanted: linear, so from unit responses.  An
// axis that is only pushed sideways needs a force smaller by the ratio of the responses,
// and its unit problem as much less accuracy.
// NOLINTNEXTLINE(readability-function-size): one linear problem, set up and solved
void StokesSolver::solve_mean_velocity() {
  const Vec3 wanted = problem_.drive.mean_velocity;
  std::array<double, 3> tolerance{};  // 0: axis not used, or done
  std::array<bool, 3> used{};
  for (std::size_t a = 0; a < 3; ++a) {
    const bool driven =
        problem_.box.periodic(static_cast<int>(a)) && wanted[static_cast<int>(a)] != 0.0;
    tolerance[a] = driven ? options_.tolerance : 0.0;
    used[a] = driven;
  }
  Eigen::Matrix3d mobility = Eigen::Matrix3d::Identity();
  for (bool more = true; more;) {
    more = false;
    for (int a = 0; a < 3; ++a) {
      double& wanted_tolerance = tolerance[static_cast<std::size_t>(a)];
      if (wanted_tolerance == 0.0) {
        continue;
      }
      solve_unit_force(a, wanted_tolerance);
      wanted_tolerance = 0.0;
      const Vec3 response = mean_velocity(unit_[static_cast<std::size_t>(a)]);
      require(response[a] > 0.0, "/drive/mean_velocity",
              "the spheres block the way along this axis, no flux can be held");
      for (int b = 0; b < 3; ++b) {
        mobility(b, a) = response[b];
        const auto s = static_cast<std::size_t>(b);
        const double sideways = std::abs(response[b]) / response[a];
        if (problem_.box.periodic(b) && !used[s] && sideways > kUncoupled) {
          used[s] = true;
          tolerance[s] = std::min(kLoosest, options_.tolerance / sideways);
          more = true;
        }
      }
    }
  }
  Eigen::Vector3d target(0.0, 0.0, 0.0);
  for (int a = 0; a < 3; ++a) {
    if (used[static_cast<std::size_t>(a)]) {
      target(a) = wanted[a];
    } else {
      mobility.row(a).setZero();
      mobility(a, a) = 1.0;
    }
  }
  const Eigen::Vector3d force = mobility.fullPivLu().solve(target);
  grid_force_ = {};
  for (int a = 0; a < 3; ++a) {
    if (used[static_cast<std::size_t>(a)]) {
      grid_force_[a] = force(a);
    }
  }
  superpose_flow();
}

std::vector<double> StokesSolver::state() const {
  std::vector<double> state{grid_force_.x, grid_force_.y, grid_force_.z};
  for (const StokesVector<double>* fields : {&x_, &unit_[0], &unit_[1], &unit_[2]}) {
    state.push_back(static_cast<double>(fields->a[0].size()));
    for (const auto& values : fields->a) {
      state.insert(state.end(), values.begin(), values.end());
    }
  }
  return state;
}

void StokesSolver::restore(const std::vector<double>& state) {
  const std::size_t size = rows_->grid().size;
  std::size_t next = 0;
  const auto take = [&] {
    require(next < state.size(), "flow state", "is cut short");
    return state[next++];
  };
  Vec3 force;
  for (int a = 0; a < 3; ++a) {
    force[a] = take();
  }
  std::array<StokesVector<double>, 4> fields;
  for (auto& field : fields) {
    const double count = take();
    if (count == 0.0) {
      continue;
    }
    require(count == static_cast<double>(size), "flow state",
            "belongs to another grid: " + std::to_string(static_cast<long long>(count)) +
                " entries an array, expected " + std::to_string(size));
    require(state.size() - next >= 4 * size, "flow state", "is cut short");
    for (auto& values : field.a) {
      const auto from = state.begin() + static_cast<std::ptrdiff_t>(next);
      values.assign(from, from + static_cast<std::ptrdiff_t>(size));
      next += size;
    }
  }
  require(next == state.size(), "flow state", "has more values than this grid");
  require(!fields[0].a[0].empty(), "flow state", "has no flow in it");
  grid_force_ = force;
  x_ = std::move(fields[0]);
  for (std::size_t a = 0; a < 3; ++a) {
    unit_[a] = std::move(fields[a + 1]);
  }
  superpose_flow();
}

Vec3 StokesSolver::mean_velocity(const StokesVector<double>& x) const {
  const Grid& grid = rows_->grid();
  Vec3 mean;
  for (int c = 0; c < 3; ++c) {
    const auto s = static_cast<std::size_t>(c);
    double sum = 0.0;
    for (int k = 0; k < grid.end(c, 2); ++k) {
      for (int j = 0; j < grid.end(c, 1); ++j) {
        for (int i = 0; i < grid.end(c, 0); ++i) {
          const std::array<int, 3> at{i, j, k};
          // A face on the box itself stands for half a cell.
          const bool half = !grid.periodic[s] && (at[s] == 0 || at[s] == grid.cells[s]);
          sum += (half ? 0.5 : 1.0) * x.a[s][grid.index(i, j, k)];
        }
      }
    }
    mean[c] = sum / static_cast<double>(grid.cell_count());
  }
  return mean;
}

double StokesSolver::largest_speed() const {
  const Grid& grid = rows_->grid();
  double largest = 0.0;
  for (int k = 0; k < grid.cells[2]; ++k) {
    for (int j = 0; j < grid.cells[1]; ++j) {
      for (int i = 0; i < grid.cells[0]; ++i) {
        const std::size_t q = grid.index(i, j, k);
        double square = 0.0;
        for (int c = 0; c < 3; ++c) {
          const auto& u = flow_.a[static_cast<std::size_t>(c)];
          const double mean =
              0.5 * (u[q] + u[q + static_cast<std::size_t>(grid.stride(c))]);
          square += mean * mean;
        }
        largest = std::max(largest, square);
      }
    }
  }
  return std::sqrt(largest) * velocity_unit();
}

int flow_axis(const StokesProblem& problem) {
  for (int f = 0; f < kFaces; ++f) {
    if (problem.box.face(f) == FaceCondition::inlet) {
      return axis_of(f);
    }
  }
  if (problem.drive.kind == Kind::body_force ||
      problem.drive.kind == Kind::mean_velocity) {
    const Vec3 v = problem.drive.kind == Kind::body_force ? problem.drive.body_force
                                                          : problem.drive.mean_velocity;
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
      axis = std::abs(v[a]) > std::abs(v[axis]) ? a : axis;
    }
    return v[axis] != 0.0 ? axis : -1;
  }
  return -1;
}

// Mean pressure on a face of the box, extrapolated linearly from the two cells inside.  A
// plug flow that meets a no-slip wall makes the pressure singular like 1/r in that
// corner, and the mean over the whole face grows like log(1/h); so the mean is taken over
// the core of the face, a quarter of its width away from walls.
double StokesSolver::face_pressure(int face) const {
  const FlowFace& condition = faces_[static_cast<std::size_t>(face)];
  if (condition.kind == FlowFace::Kind::pressure) {
    return condition.pressure;
  }
  const double core = mean_pressure_near(face, kCoreMargin);
  return std::isnan(core) ? mean_pressure_near(face, 0.0) : core;
}

double StokesSolver::mean_pressure_near(int face, double margin) const {
  const Grid& grid = rows_->grid();
  const int axis = axis_of(face);
  const std::ptrdiff_t inward = grid.stride(axis) * (is_upper(face) ? -1 : 1);
  const auto in_core = [&](const std::array<int, 3>& at) {
    for (int a = 0; a < 3; ++a) {
      const double extent = grid.position[static_cast<std::size_t>(a)].back();
      const double x =
          a == axis ? 0.5 : grid.centre(a, at[static_cast<std::size_t>(a)]) / extent;
      if ((problem_.box.face(2 * a) == FaceCondition::wall && x < margin) ||
          (problem_.box.face(2 * a + 1) == FaceCondition::wall && x > 1.0 - margin)) {
        return false;
      }
    }
    return true;
  };
  double sum = 0.0;
  int count = 0;
  for_boundary(grid, face, [&](const std::array<int, 3>& at) {
    const std::size_t first = inner_cell(grid, face, at);
    if (rows_->coefficients().cell_scale[first] <= 0.0F || !inlet_open_[first] ||
        !in_core(at)) {
      return;
    }
    const auto second =
        static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) + inward);
    const bool both = grid.cells[static_cast<std::size_t>(axis)] > 1 &&
                      rows_->coefficients().cell_scale[second] > 0.0F;
    const auto& p = flow_.a[pressure];
    sum += both ? 1.5 * p[first] - 0.5 * p[second] : p[first];
    ++count;
  });
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

Vec3 StokesSolver::body_force() const {
  return grid_force_ * (pressure_unit() / length_);
}

double StokesSolver::pressure_drop() const {
  const int axis = flow_axis();
  if (axis < 0) {
    return 0.0;
  }
  const double by_force = std::abs(body_force()[axis]) * problem_.box.size[axis];
  double in = 0.0;
  double out = 0.0;
  for (int f = 0; f < kFaces; ++f) {
    if (problem_.box.face(f) == FaceCondition::inlet) {
      in = face_pressure(f) * pressure_unit();
    } else if (problem_.box.face(f) == FaceCondition::outlet) {
      out = face_pressure(f) * pressure_unit();
    }
  }
  return in - out + by_force;
}

double StokesSolver::flow_rate() const {
  const int axis = flow_axis();
  if (axis < 0 || blocked_) {
    return 0.0;
  }
  const double area =
      problem_.box.size[(axis + 1) % 3] * problem_.box.size[(axis + 2) % 3];
  for (int f = 0; f < kFaces; ++f) {
    if (problem_.box.face(f) != FaceCondition::inlet) {
      continue;
    }
    double sum = 0.0;
    const Grid& grid = rows_->grid();
    for_boundary(grid, f, [&](const std::array<int, 3>& at) {
      sum += flow_.a[static_cast<std::size_t>(axis)][grid.index(at[0], at[1], at[2])];
    });
    const double faces = static_cast<double>(grid.cell_count()) /
                         grid.cells[static_cast<std::size_t>(axis)];
    return (is_upper(f) ? -1.0 : 1.0) * sum / faces * area;
  }
  return std::abs(superficial_velocity()[axis]) * area;
}

Vec3 StokesSolver::superficial_velocity() const {
  return mean_velocity(flow_);
}

double StokesSolver::permeability() const {
  const int axis = flow_axis();
  const double drop = pressure_drop();
  if (axis < 0 || drop == 0.0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double area =
      problem_.box.size[(axis + 1) % 3] * problem_.box.size[(axis + 2) % 3];
  return flow_rate() * problem_.viscosity * problem_.box.size[axis] / (area * drop);
}

}  // namespace colloid
