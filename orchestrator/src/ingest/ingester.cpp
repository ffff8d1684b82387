#include "ingest/ingester.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "ingest/attempt_folder.h"
#include "ingest/result_file.h"
#include "ingest/standing.h"

namespace colloid {

namespace {

namespace fs = std::filesystem;

/// Realisations in one transaction: few enough that other campaigns need not wait long.
constexpr int kTogether = 64;

bool is_there(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// A solver that refuses its input while there is a checkpoint may mean the checkpoint:
/// it goes to the attempt's folder, and the next attempt begins anew.
void put_checkpoint_aside(const std::string& realisation, const std::string& attempt) {
  std::error_code ignored;
  fs::rename(realisation + "/checkpoint.h5", attempt + "/checkpoint.refused.h5", ignored);
}

}  // namespace

std::vector<AttemptOf> Ingester::catch_up() {
  std::vector<AttemptOf> running;
  std::set<std::pair<std::size_t, int>> seen;
  Batch batch(store_);
  int count = 0;
  const auto catch_up_with = [&](const Item& item) {
    catch_up(item, running);
    if (++count % kTogether == 0) {
      batch.commit();
    }
  };
  for (std::size_t e = 0; e < plan_.ensembles.size(); ++e) {
    for (const int index : folder_.started(plan_.ensembles[e])) {
      const Item item{e, index};
      if (index < plan_.realisations && store_.status(item) != Status::ingested) {
        catch_up_with(item);
        seen.insert({e, index});
      }
    }
  }
  // Also late attempts of realisations that another attempt finished, and attempts whose
  // folder is gone.
  for (const Item& item : store_.with_running_attempts()) {
    if (seen.count({item.ensemble, item.index}) == 0) {
      catch_up_with(item);
    }
  }
  batch.commit();
  return running;
}

void Ingester::catch_up(const Item& item, std::vector<AttemptOf>& running) {
  const std::string realisation = folder_.realisation(plan_, item);
  if (const auto waiting =
          watch_ == nullptr ? std::nullopt : watch_->waiting(realisation);
      waiting && store_.status(item) == Status::active) {
    running.push_back({item, *waiting});
    return;
  }
  std::map<int, Cause> known;
  for (const AttemptRecord& attempt : store_.attempts(item)) {
    known[attempt.number] = attempt.cause;
  }
  std::set<int> open;
  for (const int number : attempts_in(realisation)) {
    const auto found = known.find(number);
    if (found == known.end() || found->second == Cause::running) {
      open.insert(number);
    }
  }
  for (const auto& [number, cause] : known) {
    if (cause == Cause::running) {
      open.insert(number);
    }
  }
  bool is_active = false;
  bool is_unknown = false;
  for (const int number : open) {
    const std::string folder = attempt_folder(realisation, number);
    const Presence now = presence(folder);
    if (now == Presence::unknown) {
      is_unknown = true;
      continue;
    }
    if (now == Presence::active) {
      running.push_back({item, number});
      is_active = true;
      continue;
    }
    settle(item, number);
  }
  if (store_.status(item) != Status::ingested) {
    const Status status = is_active    ? Status::active
                          : is_unknown ? Status::unknown
                                       : standing_of(item);
    if (status != store_.status(item)) {
      store_.set_status(item, status);
    }
  }
}

Presence Ingester::presence(const std::string& folder) {
  const Presence elsewhere =
      watch_ == nullptr ? Presence::not_mine : watch_->conclude(folder);
  if (elsewhere != Presence::not_mine) {
    return elsewhere;
  }
  const Presence here = presence_here(folder);
  const bool has_said = !is_there(folder) || is_there(folder + "/ending.json") ||
                        is_there(folder + "/result.h5");
  return here != Presence::ended || has_said || give_up(folder) ? here : Presence::active;
}

Settled Ingester::settle(const Item& item, int number, const std::string& command) {
  const std::string realisation = folder_.realisation(plan_, item);
  const std::string folder = attempt_folder(realisation, number);
  const bool was_ingested = store_.status(item) == Status::ingested;
  AttemptRecord attempt = read_attempt(folder, number, command);
  std::vector<Incident> incidents;
  if (is_there(folder + "/result.h5")) {
    try {
      const ResultRecord result = read_result(folder + "/result.h5");
      const std::string why = foreign(item, result);
      if (why.empty()) {
        attempt.cause = Cause::finished;
        was_ingested ? store_.compare(item, attempt, result)
                     : store_.ingest(item, attempt, result);
        std::error_code ignored;
        fs::remove(realisation + "/checkpoint.h5", ignored);
        return {Status::ingested, attempt.cause};
      }
      attempt.cause = Cause::foreign_result;
      attempt.message = why;
    } catch (const TornResult& torn) {
      attempt.cause = Cause::torn_result;
      attempt.message = torn.what();
    }
    incidents.push_back({name_of(attempt.cause), "result.h5: " + attempt.message});
  } else {
    attempt.message = last_message(folder);
  }
  if (attempt.cause == Cause::lost) {
    incidents.push_back({"lost", "ended without a trace"});
  }
  if (attempt.cause == Cause::refused && is_there(realisation + "/checkpoint.h5")) {
    put_checkpoint_aside(realisation, folder);
    incidents.push_back({"checkpoint_refused", attempt.message});
  }
  store_.end_attempt(item, attempt, store_.status(item), incidents);
  if (!was_ingested) {
    store_.set_status(item, standing_of(item));
  }
  return {store_.status(item), attempt.cause};
}

Status Ingester::standing_of(const Item& item) {
  return standing(store_.attempts(item), store_.forgiven(item), plan_.limits,
                  folder_.realisation(plan_, item));
}

std::string Ingester::foreign(const Item& item, const ResultRecord& result) {
  const std::uint64_t seed = seed_of(plan_, item);
  if (result.seed != seed) {
    return fmt::format("it is of seed {}, expected {}", result.seed, seed);
  }
  const Ensemble& ensemble = plan_.ensembles[item.ensemble];
  const bool any_tier = ensemble.tier == "auto";
  if (!any_tier && result.tier != ensemble.tier) {
    return fmt::format("it is of tier {}, expected {}", result.tier, ensemble.tier);
  }
  if (!result.scene.empty()) {
    const std::string expected =
        any_tier ? scene_hash_of(ensemble.scene.dump(), true) : ensemble.scene_hash;
    if (scene_hash_of(result.scene, any_tier) != expected) {
      return "it is of another scene";
    }
  }
  return "";
}

std::string Ingester::scene_hash_of(const std::string& scene, bool without_tier) {
  if (scene != last_scene_) {
    nlohmann::json parsed = nlohmann::json::parse(scene, nullptr, false);
    if (!parsed.is_object()) {
      return "";
    }
    if (without_tier && parsed.contains("fidelity")) {
      parsed["fidelity"].erase("tier");
    }
    last_scene_hash_ = hash_of_scene(std::move(parsed));
    last_scene_ = scene;
  }
  return last_scene_hash_;
}

}  // namespace colloid
