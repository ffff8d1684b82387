#include "commands/run.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"
#include "io/checkpoint.h"
#include "io/provenance.h"
#include "io/result_file.h"
#include "scene/read_scene.h"
#include "tiers/tier.h"

namespace colloid {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr int kSchemaVersion = 1;
constexpr double kTerminalSeconds = 0.2;  // between lines of progress
constexpr double kPlainSeconds = 10.0;

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

extern "C" void ask_to_stop(int) {
  stop_asked = true;
}

void listen_to_signals() {
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  // A second signal ends the program at once.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
}

std::string clock_text(double seconds) {
  if (!std::isfinite(seconds)) {
    return "?";
  }
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

// Time, retained colloids, critical diameter and what is left to wait: one line that is
// overwritten on a terminal, a line now and then elsewhere.
class ProgressLine {
 public:
  void operator()(const Progress& progress) {
    const auto now = Clock::now();
    const auto since = [&](Clock::time_point t) {
      return std::chrono::duration<double>(now - t).count();
    };
    if (first_time_ < 0.0) {
      first_time_ = progress.time;  // a continued run has not computed the time before
      start_ = now;
    }
    if (since(last_) < (terminal_ ? kTerminalSeconds : kPlainSeconds) &&
        progress.time < progress.duration) {
      return;
    }
    last_ = now;
    const double done = progress.time - first_time_;
    const double left = done > 0.0
                            ? since(start_) * (progress.duration - progress.time) / done
                            : HUGE_VAL;
    std::fputs(fmt::format("{}{:.3f} of {:g} s, {} retained, l_c {:.2f} um, {} left{}",
                           terminal_ ? "\r" : "", progress.time, progress.duration,
                           progress.retained, 1e6 * progress.critical_diameter,
                           clock_text(left), terminal_ ? "   " : "\n")
                   .c_str(),
               stderr);
    std::fflush(stderr);
    written_ = true;
  }
  void end() const {
    if (written_ && terminal_) {
      std::fputs("\n", stderr);
    }
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool written_ = false;
  double first_time_ = -1.0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = Clock::now();
};

Json number_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json result_json(const Realisation& r, const std::string& path) {
  Json out;
  out["schema_version"] = kSchemaVersion;
  out["result"] = path;
  out["seed"] = std::to_string(r.seed);
  out["tier"] = r.tier;
  out["tier_reason"] = r.tier_reason;
  out["ending"] = r.ending == Ending::clogged ? "clogged" : "duration";
  out["time_s"] = r.duration;
  out["t1_s"] = number_or_null(r.t1);
  out["tc_s"] = number_or_null(r.tc);
  out["alpha_deg"] = number_or_null(r.alpha_deg);
  out["critical_diameter_m"] = number_or_null(r.series.back().critical_diameter);
  out["permeability_ratio"] = number_or_null(r.series.back().permeability_ratio);
  out["counts"] = {{"injected", r.counts.injected}, {"delayed", r.counts.delayed},
                   {"mobile", r.counts.mobile},     {"bonded", r.counts.bonded},
                   {"retained", r.counts.retained}, {"traversed", r.counts.traversed}};
  for (const auto* numbers : {&r.deterministic, &r.cost}) {
    for (const auto& [name, value] : *numbers) {
      out["solver"][name] = number_or_null(value);
    }
  }
  return out;
}

std::string result_summary(const Realisation& r, const std::string& path) {
  const auto seconds = [](double t) {
    return std::isfinite(t) ? fmt::format("{:.4f} s", t) : std::string("not reached");
  };
  const SeriesRow& last = r.series.back();
  return fmt::format(
      "tier                {} ({})\n"
      "first retention     {}\n"
      "clogging            {}\n"
      "at the end          {:g} s: {} injected, {} retained, {} traversed, {} mobile, "
      "{} waiting\n"
      "critical diameter   {:.6g} m\n"
      "permeability ratio  {:.4g}\n"
      "result              {}\n",
      r.tier, r.tier_reason, seconds(r.t1), seconds(r.tc), r.duration, r.counts.injected,
      r.counts.retained, r.counts.traversed, r.counts.mobile, r.counts.delayed,
      last.critical_diameter, last.permeability_ratio, path);
}

class Run : public Command {
 public:
  explicit Run(TierTable tiers) : tiers_(std::move(tiers)) {}

  void declare_options(CLI::App& app) override {
    app.add_option("scene", scene_, "Scene file (JSON)")->required();
    app.add_option("-o,--output", output_, "Result file (HDF5)")->required();
    app.add_option("--seed", seed_, "Seed of the injections, 0 to 2^64 - 1")
        ->capture_default_str();
    app.add_option("--checkpoint", checkpoint_,
                   "Continue from this file if it is there; save to it at intervals and "
                   "on SIGTERM and SIGINT");
    app.add_option("--checkpoint-interval", interval_,
                   "Wall time between checkpoints [s]")
        ->check(CLI::Range(0.0, 1e9))
        ->capture_default_str();
    app.add_option("--threads", threads_, "Threads of the flow solver")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_flag("--progress", progress_,
                 "Show simulated time, retained colloids, "
                 "critical diameter and remaining time");
    app.add_flag("--json", json_, "Print one JSON object when done");
  }

  int run() const override {
    const SceneFile file = read_scene(scene_);
    check_starting_colloids(file);
    RunOptions options;
    options.seed = parse_seed(seed_, "--seed");
    const TierDecision decision = choose_tier(file.scene, tiers_, threads_);
    if (!decision.warning.empty()) {
      std::cerr << fmt::format("{}: {}\n", tiers_.program, decision.warning);
    }
    options.tier_reason = decision.reason;
    options.checkpoint = checkpoint_;
    options.checkpoint_interval = interval_;
    options.threads = threads_;
    options.stop = &stop_asked;
    ProgressLine line;
    if (progress_) {
      options.progress = [&](const Progress& progress) { line(progress); };
    }
    listen_to_signals();
    std::optional<ResultFile> result;
    open_result(result, file.scene);
    const std::optional<Realisation> realisation = decision.tier.run(file.scene, options);
    line.end();
    if (!realisation) {
      std::cerr << (checkpoint_.empty()
                        ? "interrupted; without --checkpoint nothing was kept\n"
                        : fmt::format("interrupted; continue with --checkpoint {}\n",
                                      checkpoint_));
      return exit_interrupted;
    }
    if (!result) {
      return exit_finished;
    }
    result->finish(*realisation);
    if (!checkpoint_.empty()) {
      std::error_code ignored;  // none was written, or it will be refused or replayed
      std::filesystem::remove(checkpoint_, ignored);
    }
    std::cout << (json_ ? result_json(*realisation, output_).dump(2) + "\n"
                        : result_summary(*realisation, output_));
    return exit_finished;
  }

 private:
  // By the first process; the others do not begin what it cannot write.
  void open_result(std::optional<ResultFile>& result, const Scene& scene) const {
    std::exception_ptr refused;
    try {
      if (tiers_.writes_result) {
        result.emplace(output_, collect_provenance(arguments()), scene);
      }
    } catch (...) {
      refused = std::current_exception();
    }
    const bool all_go_on = !tiers_.on_all || tiers_.on_all(refused == nullptr);
    if (refused) {
      std::rethrow_exception(refused);
    }
    require(all_go_on, output_, "cannot be written by the first process");
  }

  // The command as it was given; the system keeps it for us.
  static std::vector<std::string> arguments();

  TierTable tiers_;
  std::string scene_;
  std::string output_;
  std::string seed_ = "1";
  std::string checkpoint_;
  double interval_ = 600.0;
  int threads_ = 1;
  bool progress_ = false;
  bool json_ = false;
};

std::vector<std::string> Run::arguments() {
  std::FILE* file = std::fopen("/proc/self/cmdline", "rb");
  std::vector<std::string> out(1);
  if (file != nullptr) {
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
      if (c == 0) {
        out.emplace_back();
      } else {
        out.back() += static_cast<char>(c);
      }
    }
    std::fclose(file);
    out.pop_back();
  }
  return out;
}

}  // namespace

std::unique_ptr<Command> make_run(TierTable tiers) {
  return std::make_unique<Run>(std::move(tiers));
}

}  // namespace colloid
