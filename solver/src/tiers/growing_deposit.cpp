#include "tiers/growing_deposit.h"

#include <cmath>
#include <utility>

namespace colloid {

GrowingDeposit::GrowingDeposit(const Scene& scene, DepositFlow& flow,
                               FixedSurfaces& surfaces)
    : scene_(scene),
      flow_(flow),
      surfaces_(surfaces),
      radius_(0.5 * scene.colloids->diameter),
      spheres_(scene.geometry.spheres),
      first_permeability_(flow.permeability()) {
  observe({});
}

// What can pass now.
void GrowingDeposit::observe(const DepositBatch& batch) {
  for (std::size_t i = 0; i < batch.ids.size(); ++i) {
    surfaces_.add_colloid(batch.ids[i], batch.spheres[i]);
    spheres_.push_back(batch.spheres[i]);
  }
  CriticalDiameterOptions search;
  search.flow_axis = flow_.solver().flow_axis();
  const CriticalDiameter before = critical_;
  search.before = batch.ids.empty() ? nullptr : &before;
  critical_ = critical_diameter(surfaces_.box(), spheres_, search);
}

std::vector<Sphere> GrowingDeposit::add(std::vector<RetainedColloid> colloids,
                                        double time, RunState& state) {
  Realisation& r = state.realisation;
  DepositBatch batch;
  for (RetainedColloid& colloid : colloids) {
    colloid.order = static_cast<long>(r.retained.size()) + 1;
    colloid.time = time;
    if (std::isnan(colloid.contact_time)) {
      colloid.contact_time = time;
    }
    if (colloid.layer == Layer::first && std::isnan(r.t1)) {
      r.t1 = time;
      r.alpha_deg = colloid.alpha_deg;
    }
    batch.ids.push_back(static_cast<int>(colloid.colloid));
    batch.spheres.push_back({colloid.position, radius_});
    r.retained.push_back(std::move(colloid));
  }
  observe(batch);
  if (critical_.value < 2.0 * radius_ && std::isnan(r.tc)) {
    r.tc = time;
  }
  if (critical_.blocked && std::isnan(r.blocked_since)) {
    r.blocked_since = time;
  }
  if (critical_.blocked && scene_.drive.inlet_velocity) {
    flow_.add_unsolved(batch.spheres);
    flow_.block();
  } else {
    flow_.add(batch.spheres);
  }
  state.deposit.push_back(batch);
  return std::move(batch.spheres);
}

bool GrowingDeposit::ends_run(const Realisation& realisation) const {
  return scene_.stop_when == StopWhen::clogged && !std::isnan(realisation.tc);
}

void GrowingDeposit::save(Checkpoint& checkpoint) const {
  checkpoint.reals["deposit_flow"] = flow_.state();
  checkpoint.reals["first_permeability"] = {first_permeability_};
  checkpoint.integers["deposit_flow_counts"] = {flow_.solves(), flow_.iterations(),
                                                flow_.blocked() ? 1 : 0};
}

void GrowingDeposit::restore(const Checkpoint& checkpoint, const RunState& state) {
  for (const DepositBatch& batch : state.deposit) {
    observe(batch);
    flow_.add_unsolved(batch.spheres);
  }
  first_permeability_ = checkpoint.reals.at("first_permeability").at(0);
  const auto& counts = checkpoint.integers.at("deposit_flow_counts");
  flow_.restore(checkpoint.reals.at("deposit_flow"), counts.at(2) != 0,
                static_cast<long>(counts.at(0)), static_cast<long>(counts.at(1)));
}

}  // namespace colloid
