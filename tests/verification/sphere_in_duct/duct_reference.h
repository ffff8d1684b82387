// reference.csv, and what follows from it, for the tiers that are compared with it.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace colloid {

// Developed flow of a square duct: k/W^2 and u_max/u_mean of the exact series.
constexpr double kDuctPermeability = 0.0351442537;
constexpr double kDuctPeak = 2.09626;

// A row of reference.csv; the forces over 6 pi mu a, torques over 8 pi mu a^3.
struct DuctReference {
  double size = 0.0, offset = 0.0;  ///< over W
  double k_f = 0.0, k_c = 0.0, k_t = 0.0;
  double f_held = 0.0, t_held = 0.0;
  double rise_moves = 0.0, drop_held = 0.0;
  double residual = 0.0;
};

inline std::vector<DuctReference> square_ducts() {
  std::ifstream file(PORECLOG_SOURCE_DIR
                     "/tests/verification/sphere_in_duct/reference.csv");
  std::vector<DuctReference> out;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string name;
    std::getline(fields, name, ',');
    if (name != "square") {
      continue;
    }
    std::vector<double> x;
    for (std::string field; std::getline(fields, field, ',');) {
      x.push_back(std::stod(field));
    }
    out.push_back({x.at(0), x.at(1), x.at(2), x.at(3), x.at(5), x.at(6), x.at(7), x.at(8),
                   x.at(10), x.at(11)});
  }
  if (out.size() != 7) {
    throw std::runtime_error("reference.csv: expected seven square ducts");
  }
  return out;
}

// Of a free sphere in the developed flow at its flux: speed over u_max, spin times a over
// u_max.
struct DuctMotion {
  double speed = 0.0, spin = 0.0;
};

inline DuctMotion free_motion(const DuctReference& r) {
  // R [U; a w] = held wrench, torques in units of 6 pi mu a^2.
  const double a = 0.5 * r.size;
  const double turn = 4.0 / 3.0 * r.k_t;
  const double torque = 4.0 / 3.0 * r.t_held * a;
  const double determinant = r.k_f * turn - r.k_c * r.k_c;
  return {(turn * r.f_held - r.k_c * torque) / determinant,
          (r.k_f * torque - r.k_c * r.f_held) / determinant};
}

}  // namespace colloid
