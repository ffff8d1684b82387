#include "ingest/prospect.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/files.h"
#include "ingest/attempt_folder.h"
#include "ingest/standing.h"
#include "store/schema.h"

namespace colloid {

namespace {

/// What the database knows of a realisation.
struct Known {
  bool ingested = false;
  int forgiven = 0;
  std::map<int, Cause> attempts;
};

struct Verdict {
  std::string action;
  std::string reason;
  std::string text;
};

constexpr const char* kFromEnsemble =
    "FROM realisation r JOIN ensemble e ON e.id = r.ensemble "
    "JOIN point p ON p.id = e.point JOIN campaign c ON c.id = p.campaign ";
constexpr const char* kOfEnsemble = "WHERE c.name = ? AND p.hash = ? AND e.tier = ?";

Statement ask_of(const Database& database, const std::string& sql, const Plan& plan,
                 const Ensemble& ensemble) {
  const auto point =
      std::find_if(plan.points.begin(), plan.points.end(),
                   [&](const DesignPoint& p) { return p.number == ensemble.point; });
  Statement statement = database.prepare(sql);
  statement.bind(1, plan.campaign).bind(2, point->hash).bind(3, ensemble.tier);
  return statement;
}

std::vector<Known> known_of(const Plan& plan, const Ensemble& ensemble,
                            const std::string& path) {
  std::vector<Known> known(static_cast<std::size_t>(plan.realisations));
  if (!is_file(path)) {
    return known;
  }
  const Database database(path, Database::Access::read_only);
  check_schema(database);
  const auto at = [&](const Statement& row) -> Known* {
    const auto index = static_cast<std::size_t>(row.integer(0));
    return index < known.size() ? &known[index] : nullptr;
  };
  Statement rows =
      ask_of(database,
             fmt::format("SELECT r.idx, r.status = 'ingested', r.forgiven {}{}",
                         kFromEnsemble, kOfEnsemble),
             plan, ensemble);
  while (rows.step()) {
    if (Known* one = at(rows)) {
      one->ingested = rows.integer(1) != 0;
      one->forgiven = static_cast<int>(rows.integer(2));
    }
  }
  Statement attempts =
      ask_of(database,
             fmt::format("SELECT r.idx, a.number, a.cause {}JOIN attempt a ON "
                         "a.realisation = r.id {} AND r.status <> 'ingested'",
                         kFromEnsemble, kOfEnsemble),
             plan, ensemble);
  while (attempts.step()) {
    if (Known* one = at(attempts)) {
      one->attempts[static_cast<int>(attempts.integer(1))] =
          cause_named(attempts.text(2));
    }
  }
  return known;
}

Verdict verdict_of_ended(const std::vector<AttemptRecord>& attempts, int forgiven,
                         const Limits& limits, const std::string& realisation) {
  if (attempts.empty()) {
    return {"run", "never_tried", "never tried"};
  }
  const std::string last = name_of(attempts.back().cause);
  if (standing(attempts, forgiven, limits, realisation) == Status::failed) {
    return {"skip", "failed",
            fmt::format("failed ({}); `poreclog retry --failed` tries it again", last)};
  }
  const auto failures =
      std::count_if(attempts.begin(), attempts.end(), [&](const AttemptRecord& a) {
        return a.number > forgiven && counts_as_failure(a.cause);
      });
  const std::string how = is_file(realisation + "/checkpoint.h5")
                              ? "goes on from its checkpoint"
                              : "begins anew";
  if (failures == 0) {
    return {"run", "interrupted", fmt::format("ended early ({}); {}", last, how)};
  }
  return {"run", "attempts_left",
          fmt::format("{} of {} attempts failed ({}); {}", failures, limits.attempts,
                      last, how)};
}

Presence presence(const std::string& attempt, const AttemptWatch* watch) {
  const Presence elsewhere =
      watch == nullptr ? Presence::not_mine : watch->presence(attempt);
  return elsewhere != Presence::not_mine ? elsewhere : presence_here(attempt);
}

/// The same questions as Ingester::catch_up, in the same order.
Verdict verdict_of(const Known& known, const Limits& limits,
                   const std::string& realisation, bool has_folder,
                   const AttemptWatch* watch) {
  std::set<int> numbers;
  if (has_folder) {
    const std::vector<int> there = attempts_in(realisation);
    numbers.insert(there.begin(), there.end());
  }
  for (const auto& [number, cause] : known.attempts) {
    numbers.insert(number);
  }
  std::vector<AttemptRecord> ended;
  bool has_result = false;
  bool is_running = false;
  bool is_unknown = false;
  for (const int number : numbers) {
    const auto found = known.attempts.find(number);
    AttemptRecord attempt;
    attempt.number = number;
    if (found != known.attempts.end() && found->second != Cause::running) {
      attempt.cause = found->second;
      ended.push_back(attempt);
      continue;
    }
    const std::string folder = attempt_folder(realisation, number);
    const Presence now = presence(folder, watch);
    if (now == Presence::unknown) {
      is_unknown = true;
    } else if (now == Presence::active) {
      is_running = true;
    } else if (is_file(folder + "/result.h5")) {
      has_result = true;
    } else {
      ended.push_back(read_attempt(folder, number));
    }
  }
  if (has_result) {
    return {"ingest", "result_on_disk", "its result is on the disk, not in the database"};
  }
  if (is_running) {
    return {"take_over", "running",
            "an attempt runs or waits for its turn; it is taken over"};
  }
  if (is_unknown) {
    return {"skip", "unknown",
            "may be running on another machine; `poreclog retry --unknown` gives it up"};
  }
  return verdict_of_ended(ended, known.forgiven, limits, realisation);
}

void add(std::vector<Prospect>& classes, const Verdict& verdict, int index) {
  auto at = std::find_if(classes.begin(), classes.end(), [&](const Prospect& p) {
    return p.action == verdict.action && p.text == verdict.text;
  });
  if (at == classes.end()) {
    at = classes.insert(at, {verdict.action, verdict.reason, verdict.text, 0, {}});
  }
  ++at->count;
  if (!at->indices.empty() && at->indices.back().second == index - 1) {
    at->indices.back().second = index;
  } else {
    at->indices.emplace_back(index, index);
  }
}

}  // namespace

std::vector<Prospect> prospects(const Plan& plan, std::size_t ensemble,
                                const RunFolder& folder, const std::string& database,
                                const AttemptWatch* watch, const Wanted& wanted) {
  const std::vector<Known> known = known_of(plan, plan.ensembles[ensemble], database);
  const std::vector<int> started = folder.started(plan.ensembles[ensemble]);
  std::vector<Prospect> classes;
  for (int index = 0; index < plan.realisations; ++index) {
    const Known& one = known[static_cast<std::size_t>(index)];
    if (one.ingested) {
      add(classes, {"skip", "ingested", "ingested"}, index);
      continue;
    }
    const bool has_folder = std::binary_search(started.begin(), started.end(), index);
    Verdict verdict = verdict_of(
        one, plan.limits, folder.realisation(plan, {ensemble, index}), has_folder, watch);
    if (verdict.action == "run" && index >= wanted.realisations) {
      verdict = wanted.target_met
                    ? Verdict{"skip", "target_met", "the target is met without it"}
                    : Verdict{"wait", "target", "waits for the target's next decision"};
    }
    add(classes, verdict, index);
  }
  return classes;
}

}  // namespace colloid
