#include "tiers/transient/dem.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/error.h"
#include "core/text.h"
#include "tiers/transient/dem_engine.h"
#include "tiers/transient/dem_forces.h"

namespace colloid {

namespace {

constexpr const char* kStep = "/fidelity/dem_step";
constexpr const char* kDamaged = "what was saved of the colloids is damaged";

// Who saved the colloids.
constexpr char kOfLiggghts = 'L';
constexpr char kOfOurs = 'S';

bool any_mobile(const std::vector<DemState>& states) {
  return std::any_of(states.begin(), states.end(),
                     [](const DemState& state) { return !state.held; });
}

void check(const DemOptions& options) {
  const auto positive = [](double value, const char* name) {
    require(value > 0.0 && std::isfinite(value), "DEM", [&] {
      return std::string(name) + " is " + shortest(value) + ", must be positive";
    });
  };
  positive(options.radius, "the colloids' radius");
  positive(options.density, "the colloids' density");
  positive(options.viscosity, "the viscosity");
  positive(options.colloid.young_modulus, "the colloids' Young's modulus");
  positive(options.grain.young_modulus, "the grains' Young's modulus");
  positive(options.step, "the step");
  if (options.lubrication) {
    positive(options.lubrication_cell, "the cell of lubrication");
  }
  for (const double nu : {options.colloid.poisson_ratio, options.grain.poisson_ratio}) {
    require(nu >= 0.0 && nu <= 0.5, "DEM", [&] {
      return "Poisson's ratio is " + shortest(nu) + ", must be in [0, 0.5]";
    });
  }
  require(options.restitution >= 0.05 && options.restitution <= 1.0, "DEM", [&] {
    return "the restitution is " + shortest(options.restitution) +
           ", must be in [0.05, 1]";
  });
  require(options.friction >= 0.0, "DEM", "the friction must not be negative");
}

std::vector<std::string> doubts(const DemOptions& options) {
  const DemStepLimits limits = step_limits(options);
  const double largest = limits.largest();
  require(options.step <= largest, kStep, [&] {
    return "is " + shortest(options.step) + " s, must be at most " + shortest(largest) +
           " s: " + limits.what();
  });
  std::vector<std::string> out;
  if (options.step > 0.5 * largest) {
    out.push_back("the DEM step of " + shortest(options.step) +
                  " s is more than half of what is stable, " + shortest(largest) +
                  " s: " + limits.what());
  }
  return out;
}

template <class Action>
auto as_input(Action&& action) {
  try {
    return action();
  } catch (const EngineError& error) {
    throw InputError("DEM", std::string("LIGGGHTS refuses: ") + error.what());
  }
}

}  // namespace

class Dem::Parts {
 public:
  Parts(const DemOptions& given, const std::vector<Sphere>& spheres)
      : options(given), grains(spheres) {
    check(options);
    warnings = doubts(options);
    forces.emplace(options, grains);
    as_input([&] {
      engine = std::make_unique<DemEngine>(options, grains, *forces);
      return 0;
    });
  }

  DemOptions options;
  std::vector<Sphere> grains;
  std::vector<std::string> warnings;
  std::optional<DemForces> forces;
  std::unique_ptr<DemEngine> engine;
};

Dem::Dem(const DemOptions& options, const std::vector<Sphere>& grains)
    : parts_(std::make_unique<Parts>(options, grains)) {}
Dem::~Dem() = default;
Dem::Dem(Dem&&) noexcept = default;
Dem& Dem::operator=(Dem&&) noexcept = default;

void Dem::add(const DemState& state) {
  as_input([&] {
    parts_->engine->add(state);
    return 0;
  });
}

void Dem::remove(int id) {
  parts_->engine->remove(id);
  parts_->forces->forget(id);
}

void Dem::hold(int id) {
  parts_->engine->hold(id);
}

DemStep Dem::advance(double duration, const std::vector<DemLoad>& loads) {
  std::vector<int> mobile;
  const std::vector<DemState> before = states();
  for (const DemState& state : before) {
    if (!state.held) {
      mobile.push_back(state.id);
    }
  }
  // A whole number of sub-steps, but for rounding in the quotient.
  const long steps =
      std::max(1L, std::lround(std::ceil(duration / parts_->options.step - 1e-9)));
  const double step = duration / static_cast<double>(steps);
  parts_->forces->begin(step, loads);
  if (!mobile.empty()) {
    try {
      parts_->engine->run(steps, step);
    } catch (const EngineError& error) {
      throw ConvergenceError(std::string("DEM: LIGGGHTS: ") + error.what());
    }
  }
  const std::vector<DemState> after = states();
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i >= after.size() || after[i].id != before[i].id) {
      throw ConvergenceError("DEM: colloid " + std::to_string(before[i].id) +
                             " left the box and is lost");
    }
  }
  return parts_->forces->finish(duration, mobile);
}

std::vector<DemState> Dem::states() const {
  std::vector<DemState> out = parts_->engine->states();
  for (DemState& state : out) {
    state.position = wrapped(parts_->options.box, state.position);
  }
  std::sort(out.begin(), out.end(),
            [](const DemState& a, const DemState& b) { return a.id < b.id; });
  return out;
}
std::vector<DemBond> Dem::bonds() const {
  return parts_->forces->bonds();
}
std::vector<int> Dem::aggregate(int id) const {
  return parts_->forces->aggregate(id);
}
long Dem::bonds_broken() const {
  return parts_->forces->bonds_broken();
}
const std::vector<std::string>& Dem::warnings() const {
  return parts_->warnings;
}

std::string Dem::save() {
  const std::vector<DemState> states = parts_->engine->states();
  std::string out = parts_->forces->save();
  if (any_mobile(states)) {
    return out + kOfLiggghts + parts_->engine->save();
  }
  // LIGGGHTS saves no state without mobile colloids; contacts have no history then.
  out += kOfOurs;
  out.append(reinterpret_cast<const char*>(states.data()),
             states.size() * sizeof(DemState));
  return out;
}

void Dem::restore(const std::string& saved) {
  std::string rest = saved;
  Parts& parts = *parts_;
  parts.forces->restore(rest);
  const char kind = rest.empty() ? '\0' : rest.front();
  require(kind == kOfLiggghts || kind == kOfOurs, "DEM", kDamaged);
  rest.erase(0, 1);
  as_input([&] {
    if (kind == kOfLiggghts) {
      parts.engine =
          std::make_unique<DemEngine>(parts.options, parts.grains, *parts.forces, rest);
      return 0;
    }
    require(rest.size() % sizeof(DemState) == 0, "DEM", kDamaged);
    std::vector<DemState> states(rest.size() / sizeof(DemState));
    std::copy(rest.begin(), rest.end(), reinterpret_cast<char*>(states.data()));
    parts.engine =
        std::make_unique<DemEngine>(parts.options, parts.grains, *parts.forces);
    for (const DemState& state : states) {
      parts.engine->add(state);
    }
    return 0;
  });
}

}  // namespace colloid
