#include "commands/measure.h"

#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands/regime_json.h"
#include "core/error.h"
#include "scene/read_scene.h"
#include "scene/sphere_table.h"
#include "tiers/measurement.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;
constexpr const char* kFaceNames[kFaces] = {"x-", "x+", "y-", "y+", "z-", "z+"};

Json vector_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Json wrench_json(const Wrench& w) {
  return {{"force_N", vector_json(w.force)}, {"torque_N_m", vector_json(w.torque)}};
}

Json flow_json(const Measurement& m) {
  const StokesStatistics& s = m.statistics;
  return {{"converged", s.converged},
          {"iterations", s.iterations},
          {"relative_residual", s.relative_residual},
          {"work_units", s.work_units},
          {"seconds", s.seconds},
          {"setup_seconds", s.setup_seconds},
          {"residual_ns_per_cell", s.residual_ns_per_cell},
          {"subgrid_openings", s.subgrid_openings},
          {"pressure_drop_Pa", m.pressure_drop},
          {"flow_rate_m3_s", m.flow_rate},
          {"superficial_velocity_m_s", vector_json(m.superficial_velocity)},
          {"permeability_m2", number_or_null(m.permeability)},
          {"body_force_N_m3", vector_json(m.body_force)}};
}

Json measurement_json(const Measurement& m) {
  Json out;
  out["schema_version"] = kSchemaVersion;
  out["grid"] = {{"cells", m.cells},
                 {"cell_size_m", std::cbrt(m.spacing.x * m.spacing.y * m.spacing.z)},
                 {"spacing_m", vector_json(m.spacing)}};
  out["flow"] = flow_json(m);
  out["critical_diameter_m"] = number_or_null(m.critical.value);
  out["critical_diameter"] = {
      {"error_m", m.critical.error},
      {"blocked", m.critical.blocked},
      {"bottleneck_m",
       m.critical.blocked ? Json(nullptr) : vector_json(m.critical.bottleneck)}};
  out["spheres"] = Json::array();
  for (const Wrench& w : m.forces.spheres) {
    out["spheres"].push_back(wrench_json(w));
  }
  for (std::size_t f = 0; f < kFaces; ++f) {
    out["faces"][kFaceNames[f]] = {{"force_N", vector_json(m.forces.faces[f])}};
  }
  out["bodies"] = Json::array();
  for (const BodyMeasurement& body : m.bodies) {
    Json entry = wrench_json(body.wrench);
    entry["velocity_m_s"] = vector_json(body.velocity);
    entry["angular_velocity_rad_s"] = vector_json(body.spin);
    out["bodies"].push_back(entry);
  }
  out["regime"] = regime_json(m.regime);
  if (!m.profile.empty()) {
    for (const ProfilePoint& p : m.profile) {
      out["profile"].push_back({{"position_m", vector_json(p.position)},
                                {"velocity_m_s", vector_json(p.velocity)}});
    }
  }
  return out;
}

std::string summary(const Measurement& m) {
  std::string out = fmt::format(
      "grid                 {} x {} x {} cells of {:.4g} m\n"
      "flow                 {} iterations, residual {:.1e}, {:.0f} work units, {:.3f} s\n"
      "pressure drop        {:.6g} Pa\n"
      "flow rate            {:.6g} m^3/s\n"
      "superficial velocity ({:.4g}, {:.4g}, {:.4g}) m/s\n"
      "permeability         {:.6g} m^2\n"
      "critical diameter    {:.9g} m +- {:.1g} m\n",
      m.cells[0], m.cells[1], m.cells[2],
      std::cbrt(m.spacing.x * m.spacing.y * m.spacing.z), m.statistics.iterations,
      m.statistics.relative_residual, m.statistics.work_units, m.statistics.seconds,
      m.pressure_drop, m.flow_rate, m.superficial_velocity.x, m.superficial_velocity.y,
      m.superficial_velocity.z, m.permeability, m.critical.value, m.critical.error);
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    const BodyMeasurement& body = m.bodies[b];
    out += fmt::format(
        "body {:<15} ({:.4g}, {:.4g}, {:.4g}) m/s, ({:.4g}, {:.4g}, {:.4g}) rad/s\n", b,
        body.velocity.x, body.velocity.y, body.velocity.z, body.spin.x, body.spin.y,
        body.spin.z);
  }
  if (m.statistics.subgrid_openings > 0) {
    out += fmt::format("sub-grid throats     {} faces opened by their conductance\n",
                       m.statistics.subgrid_openings);
  }
  return out;
}

/// CLI::Range lets NaN pass.
CLI::Validator number_within(double low, double high) {
  return {[low, high](std::string& text) {
            double value = 0.0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && value >= low && value <= high
                       ? std::string()
                       : fmt::format("is {}, expected a number in [{:g}, {:g}]", text,
                                     low, high);
          },
          fmt::format("FLOAT in [{:g} - {:g}]", low, high)};
}

class Measure : public Command {
 public:
  void declare_options(CLI::App& app) override {
    app.add_option("scene", scene_, "Scene file (JSON)")->required();
    app.add_option("--deposit", deposit_,
                   "Retained colloids: CSV x_m,y_m,z_m,diameter_m");
    auto* grid = app.add_option_group("grid", "At most one:");
    grid->add_option("--cells-per-colloid", choice_.cells_per_colloid,
                     "Cells per colloid diameter")
        ->check(number_within(0.5, 1000.0));
    grid->add_option("--cells-per-diameter", choice_.cells_per_diameter,
                     "Cells per diameter of the smallest sphere")
        ->check(number_within(0.5, 1000.0));
    grid->add_option("--cells", cells_, "Cells along x, y, z")
        ->expected(3)
        ->check(CLI::Range(1, 100000));
    grid->require_option(0, 1);
    app.add_option("--profile", profile_,
                   "X0 Y0 Z0 X1 Y1 Z1 N: velocity at N points of a line [m]")
        ->expected(7);
    app.add_option("--threads", threads_, "Threads of the flow solver")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_flag("--json", json_, "One JSON object (the default)");
    app.add_flag("--summary", summary_, "A few lines for people instead");
  }

  int run() const override {
    const SceneFile file = read_scene(scene_);
    MeasureOptions options;
    options.grid = choice_;
    if (!cells_.empty()) {
      options.grid.cells = {cells_[0], cells_[1], cells_[2]};
    }
    options.threads = threads_;
    options.line = line();
    if (deposit_) {
      options.deposit = read_sphere_table(*deposit_, file.scene.geometry.box);
    }
    const Measurement measurement = measure(file.scene, options);
    std::cout << (summary_ ? summary(measurement)
                           : measurement_json(measurement).dump(2) + "\n");
    return exit_finished;
  }

 private:
  std::optional<Line> line() const {
    if (profile_.empty()) {
      return std::nullopt;
    }
    for (double x : profile_) {
      require(std::isfinite(x), "--profile", "expected seven finite numbers");
    }
    const double count = profile_[6];
    require(count == std::floor(count) && count >= 2.0 && count <= 1e6, "--profile",
            fmt::format("N is {:g}, expected a whole number in [2, 1e6]", count));
    return Line{{profile_[0], profile_[1], profile_[2]},
                {profile_[3], profile_[4], profile_[5]},
                static_cast<int>(count)};
  }

  std::string scene_;
  std::optional<std::string> deposit_;
  GridChoice choice_;
  std::vector<int> cells_;
  std::vector<double> profile_;
  int threads_ = 1;
  bool json_ = false;
  bool summary_ = false;
};

}  // namespace

std::unique_ptr<Command> make_measure() {
  return std::make_unique<Measure>();
}

}  // namespace colloid
