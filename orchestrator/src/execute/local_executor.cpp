#include "execute/local_executor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "attempt/protocol.h"
#include "base/error.h"
#include "base/file_lock.h"
#include "base/files.h"

namespace colloid {

namespace {

constexpr double kPace = 0.5;         // [s] our own children wake us by SIGCHLD
constexpr double kPaceAdopted = 0.1;  // [s] others' children do not

}  // namespace

LocalExecutor::LocalExecutor(int workers, std::string keeper)
    : workers_(static_cast<std::size_t>(workers)), keeper_(std::move(keeper)) {
  assert(workers > 0);
}

std::size_t LocalExecutor::free_slots() const {
  return workers_ - std::min(workers_, running_.size());
}

void LocalExecutor::submit(const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    while (!idle_.empty() && !idle_.back().begin(job)) {
      idle_.pop_back();  // somebody has killed it
    }
    if (idle_.empty()) {
      idle_.emplace_back(keeper_);
      require(idle_.back().begin(job), keeper_, "ends as soon as it is started");
    }
    running_.emplace(job.id, Running{std::move(idle_.back()), job.folder});
    idle_.pop_back();
  }
}

bool LocalExecutor::adopt(const Job& job) {
  const bool runs = is_running(job.folder);
  if (runs) {
    running_.emplace(job.id, Running{std::nullopt, job.folder});
  }
  return runs;
}

bool LocalExecutor::has_ended(Running& job) {
  if (job.keeper) {
    const std::optional<int> ending = job.keeper->ending();
    if (!ending) {
      return false;
    }
    if (*ending != KeeperProcess::kGone) {
      if (*ending > kFolderNotMade && failure_.empty()) {
        failure_ = fmt::format("{}: the folder cannot be made: {}", job.folder,
                               std::strerror(*ending - kFolderNotMade));
      }
      idle_.push_back(std::move(*job.keeper));
      return true;
    }
    // Killed: the solver goes an instant later, and the lock with it.
    job.keeper.reset();
  }
  return !is_running(job.folder);
}

std::vector<std::int64_t> LocalExecutor::poll() {
  for (auto job = running_.begin(); job != running_.end();) {
    if (has_ended(job->second)) {
      ended_.push_back(job->first);
      job = running_.erase(job);
    } else {
      ++job;
    }
  }
  if (!failure_.empty() && !std::exchange(has_told_, true)) {
    throw StorageError(failure_);
  }
  return std::exchange(ended_, {});
}

void LocalExecutor::cancel(Stop how) {
  for (const auto& [id, job] : running_) {
    const pid_t keeper =
        job.keeper ? job.keeper->process() : keeper_of(job.folder).process;
    if (keeper > 0) {
      ::kill(keeper, how == Stop::politely ? SIGTERM : SIGQUIT);
    }
  }
}

double LocalExecutor::pace() const {
  const bool adopted = std::any_of(running_.begin(), running_.end(),
                                   [](const auto& job) { return !job.second.keeper; });
  return adopted ? kPaceAdopted : kPace;
}

bool is_running(const std::string& attempt_folder) {
  return FileLock::is_held(attempt_folder + "/lock");
}

Keeper keeper_of(const std::string& attempt_folder) {
  Keeper keeper;
  std::istringstream text(read_if_there(attempt_folder + "/lock").value_or(""));
  text >> keeper.process >> keeper.host;
  return keeper;
}

std::string host_name() {
  static const std::string host = [] {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return std::string(name.data());
  }();
  return host;
}

std::string find_keeper() {
  const std::filesystem::path here =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::string path = (here / "poreclog-attempt").string();
  require(::access(path.c_str(), X_OK) == 0, path,
          "is not there; it belongs beside poreclog");
  return path;
}

}  // namespace colloid
