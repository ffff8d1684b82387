#include "tiers/transient/shared_dem.h"

#include "core/error.h"
#include "tiers/transient/ranks.h"

namespace colloid {

namespace {

void put(std::vector<double>& out, const Vec3& v) {
  out.insert(out.end(), {v.x, v.y, v.z});
}

class Reader {
 public:
  explicit Reader(const std::vector<double>& values) : values_(values) {}
  double number() { return values_.at(next_++); }
  int integer() { return static_cast<int>(number()); }
  Vec3 vector() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }

 private:
  const std::vector<double>& values_;
  std::size_t next_ = 0;
};

std::vector<double> packed(const DemStep& step) {
  std::vector<double> out{static_cast<double>(step.steps),
                          static_cast<double>(step.means.size()),
                          static_cast<double>(step.events.size())};
  for (const DemMean& mean : step.means) {
    out.push_back(mean.id);
    put(out, mean.force);
    put(out, mean.torque);
  }
  for (const DemEvent& event : step.events) {
    out.insert(out.end(),
               {static_cast<double>(event.kind), static_cast<double>(event.colloid),
                static_cast<double>(event.other), event.time});
  }
  return out;
}

DemStep unpacked(const std::vector<double>& values) {
  Reader read(values);
  DemStep step;
  step.steps = static_cast<long>(read.number());
  step.means.resize(static_cast<std::size_t>(read.number()));
  step.events.resize(static_cast<std::size_t>(read.number()));
  for (DemMean& mean : step.means) {
    mean.id = read.integer();
    mean.force = read.vector();
    mean.torque = read.vector();
  }
  for (DemEvent& event : step.events) {
    event.kind = static_cast<DemEvent::Kind>(read.integer());
    event.colloid = read.integer();
    event.other = read.integer();
    event.time = read.number();
  }
  return step;
}

}  // namespace

SharedDem::SharedDem(const DemOptions& options, const std::vector<Sphere>& grains) {
  on_first_rank([&] { dem_ = std::make_unique<Dem>(options, grains); });
}

// An error of rank 0 is everyone's, so that all ranks end alike.
template <class Action>
void SharedDem::on_first_rank(const Action& action) {
  std::string error;
  std::string where;
  if (this_rank() == 0) {
    try {
      action();
    } catch (const InputError& e) {
      where = e.where();
      error = e.why();
    } catch (const ConvergenceError& e) {
      error = e.what();
    }
  }
  broadcast(where);
  broadcast(error);
  if (!where.empty()) {
    throw InputError(where, error);
  }
  if (!error.empty()) {
    throw ConvergenceError(error);
  }
}

void SharedDem::share() {
  std::vector<double> values;
  if (this_rank() == 0) {
    const std::vector<DemState> states = dem_->states();
    const std::vector<DemBond> bonds = dem_->bonds();
    values = {static_cast<double>(states.size()), static_cast<double>(bonds.size()),
              static_cast<double>(dem_->bonds_broken())};
    for (const DemState& state : states) {
      values.push_back(state.id);
      put(values, state.position);
      put(values, state.velocity);
      put(values, state.spin);
      values.push_back(state.held ? 1.0 : 0.0);
    }
    for (const DemBond& bond : bonds) {
      values.insert(values.end(),
                    {static_cast<double>(bond.first), static_cast<double>(bond.second),
                     bond.rigid ? 1.0 : 0.0, bond.tension, bond.largest_tension});
    }
  }
  broadcast(values);
  Reader read(values);
  states_.resize(static_cast<std::size_t>(read.number()));
  bonds_.resize(static_cast<std::size_t>(read.number()));
  broken_ = static_cast<long>(read.number());
  for (DemState& state : states_) {
    state.id = read.integer();
    state.position = read.vector();
    state.velocity = read.vector();
    state.spin = read.vector();
    state.held = read.number() != 0.0;
  }
  for (DemBond& bond : bonds_) {
    bond.first = read.integer();
    bond.second = read.integer();
    bond.rigid = read.number() != 0.0;
    bond.tension = read.number();
    bond.largest_tension = read.number();
  }
}

void SharedDem::add(const DemState& state) {
  on_first_rank([&] { dem_->add(state); });
  share();
}

void SharedDem::remove(int id) {
  on_first_rank([&] { dem_->remove(id); });
  share();
}

void SharedDem::hold(int id) {
  on_first_rank([&] { dem_->hold(id); });
  share();
}

DemStep SharedDem::advance(double duration, const std::vector<DemLoad>& loads) {
  std::vector<double> values;
  on_first_rank([&] { values = packed(dem_->advance(duration, loads)); });
  broadcast(values);
  share();
  return unpacked(values);
}

std::string SharedDem::save() {
  std::string bytes;
  on_first_rank([&] { bytes = dem_->save(); });
  broadcast(bytes);
  return bytes;
}

void SharedDem::restore(const std::string& saved) {
  on_first_rank([&] { dem_->restore(saved); });
  share();
}

}  // namespace colloid
