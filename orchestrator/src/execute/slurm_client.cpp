#include "execute/slurm_client.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/subprocess.h"

namespace colloid {

namespace {

constexpr const char* kPatience = "60";  // [s] for one answer
constexpr std::size_t kJobsPerCall = 500;

ProgramOutput ask(std::vector<std::string> words) {
  words.insert(words.begin(), {"timeout", "--kill-after=5", kPatience});
  return run_program(words);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string user_id() {
  return std::to_string(::geteuid());
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() < 18 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

/// The value of "Key = value" or "Key=value"; empty if there is none.
std::string value_of(const std::string& text, const std::string& key) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = (" " + line).find(" " + key);
    if (at == std::string::npos) {
      continue;
    }
    std::size_t begin = line.find_first_not_of(' ', at + key.size());
    if (begin == std::string::npos || line[begin] != '=') {
      continue;
    }
    begin = line.find_first_not_of(' ', begin + 1);
    return begin == std::string::npos ? ""
                                      : line.substr(begin, line.find(' ', begin) - begin);
  }
  return "";
}

/// "12|3|PENDING|Resources|name"; none if it is the line of no array's task.  An array
/// that was cancelled before its tasks began may be one line with the index N/A.
std::optional<SlurmTask> task_from(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == '|' && cells.size() < 5) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  const bool all = cells.size() == 5 && cells[1] == "N/A";
  if (cells.size() != 5 || !is_number(cells[0]) || !(all || is_number(cells[1]))) {
    return std::nullopt;
  }
  return SlurmTask{std::stoll(cells[0]), all ? SlurmTask::kAll : std::stoi(cells[1]),
                   cells[2], cells[3], cells[4]};
}

}  // namespace

std::optional<bool> is_active_state(const std::string& state) {
  static const std::set<std::string> active{
      "PENDING",      "RUNNING",     "COMPLETING", "CONFIGURING",  "SUSPENDED",
      "REQUEUED",     "REQUEUE_FED", "RESIZING",   "SIGNALING",    "REQUEUE_HOLD",
      "SPECIAL_EXIT", "STAGE_OUT",   "STOPPED",    "RESV_DEL_HOLD"};
  static const std::set<std::string> ended{
      "COMPLETED", "CANCELLED", "FAILED",   "TIMEOUT",       "NODE_FAIL",
      "PREEMPTED", "BOOT_FAIL", "DEADLINE", "OUT_OF_MEMORY", "REVOKED"};
  if (active.count(state) > 0) {
    return true;
  }
  return ended.count(state) > 0 ? std::optional(false) : std::nullopt;
}

double slurm_seconds(const std::string& text) {
  if (text.empty() || text == "UNLIMITED" || text == "NONE" || text == "INFINITE") {
    return 0.0;
  }
  const std::size_t dash = text.find('-');
  const double days = dash == std::string::npos ? 0.0 : std::atof(text.c_str());
  std::istringstream rest(dash == std::string::npos ? text : text.substr(dash + 1));
  std::vector<double> parts;
  for (std::string part; std::getline(rest, part, ':');) {
    parts.push_back(std::atof(part.c_str()));
  }
  // After days, hours come first; without them, the last of two or three is seconds.
  parts.resize(std::max<std::size_t>(parts.size(), dash == std::string::npos ? 1 : 3));
  double seconds = 0.0;
  for (const double part : parts) {
    seconds = 60.0 * seconds + part;
  }
  return 86400.0 * days + (parts.size() == 1 ? 60.0 * seconds : seconds);
}

SlurmClient::SlurmClient() {
  for (const char* name :
       {"SQUEUE_ACCOUNT",   "SQUEUE_ALL",         "SQUEUE_ARRAY",   "SQUEUE_ARRAY_UNIQUE",
        "SQUEUE_CLUSTERS",  "SQUEUE_FEDERATION",  "SQUEUE_FORMAT",  "SQUEUE_FORMAT2",
        "SQUEUE_LICENSES",  "SQUEUE_LOCAL",       "SQUEUE_NAMES",   "SQUEUE_PARTITION",
        "SQUEUE_PRIORITY",  "SQUEUE_QOS",         "SQUEUE_SIBLING", "SQUEUE_SORT",
        "SQUEUE_STATES",    "SQUEUE_USERS",       "SACCT_FORMAT",   "SCANCEL_ACCOUNT",
        "SCANCEL_BATCH",    "SCANCEL_FULL",       "SCANCEL_HURRY",  "SCANCEL_INTERACTIVE",
        "SCANCEL_NAME",     "SCANCEL_PARTITION",  "SCANCEL_QOS",    "SCANCEL_STATE",
        "SCANCEL_USER",     "SCANCEL_WCKEY",      "SBATCH_WAIT",    "SBATCH_ARRAY_INX",
        "SBATCH_TEST_ONLY", "SLURM_RESTART_COUNT"}) {
    ::unsetenv(name);
  }
}

SlurmLimits SlurmClient::limits(const std::string& partition) const {
  const ProgramOutput config = ask({"scontrol", "show", "config"});
  require(config.exit_code == 0, "slurm",
          fmt::format("`scontrol show config` failed (is this a machine from which jobs "
                      "are submitted?): {}",
                      first_line(config.err)));
  SlurmLimits limits;
  const std::string size = value_of(config.out, "MaxArraySize");
  const std::string count = value_of(config.out, "MaxJobCount");
  require(is_number(size) && is_number(count), "slurm",
          "`scontrol show config` does not say MaxArraySize and MaxJobCount");
  limits.array_size = std::stol(size);
  limits.job_count = std::stol(count);
  require(limits.array_size > 1, "slurm", "job arrays are switched off (MaxArraySize)");
  const ProgramOutput partitions = ask({"scontrol", "show", "partition", "-o"});
  std::istringstream lines(partitions.out);
  for (std::string line; std::getline(lines, line);) {
    const std::string name = value_of(line, "PartitionName");
    if (partition.empty() ? value_of(line, "Default") == "YES" : name == partition) {
      limits.seconds = slurm_seconds(value_of(line, "MaxTime"));
    }
  }
  return limits;
}

SlurmClient::Submitted SlurmClient::submit(const std::vector<std::string>& words) const {
  std::vector<std::string> all{"sbatch", "--parsable"};
  all.insert(all.end(), words.begin(), words.end());
  const ProgramOutput output = ask(std::move(all));
  const std::string line = first_line(output.out);
  const std::string job = line.substr(0, line.find(';'));  // job;cluster
  Submitted submitted;
  submitted.message = first_line(output.err);
  if (output.exit_code == 0 && is_number(job)) {
    submitted.job = std::stoll(job);
  }
  return submitted;
}

std::optional<std::vector<SlurmTask>> SlurmClient::tasks() const {
  const ProgramOutput output = ask({"squeue", "--noheader", "--array", "--states=all",
                                    "--user=" + user_id(), "--format=%F|%K|%T|%r|%j"});
  if (output.exit_code != 0) {
    return std::nullopt;
  }
  std::vector<SlurmTask> tasks;
  std::istringstream lines(output.out);
  for (std::string line; std::getline(lines, line);) {
    if (auto task = task_from(line)) {
      tasks.push_back(std::move(*task));
    }
  }
  return tasks;
}

Answer SlurmClient::knows(std::int64_t job) const {
  const ProgramOutput output = ask({"scontrol", "show", "job", std::to_string(job)});
  if (output.exit_code == 0) {
    return Answer::yes;
  }
  return output.err.find("Invalid job id") != std::string::npos ? Answer::no
                                                                : Answer::none;
}

std::optional<std::int64_t> SlurmClient::accounted(const std::string& name) const {
  const ProgramOutput output =
      ask({"sacct", "--noheader", "--parsable2", "--allocations", "--format=JobID",
           "--starttime=now-30days", "--name=" + name, "--user=" + user_id()});
  const std::string line = first_line(output.out);
  const std::string job = line.substr(0, line.find('_'));  // 12_3: a task of array 12
  return output.exit_code == 0 && is_number(job) ? std::optional(std::stoll(job))
                                                 : std::nullopt;
}

void SlurmClient::cancel(const std::vector<std::int64_t>& jobs,
                         const std::string& signal) const {
  for (std::size_t begin = 0; begin < jobs.size(); begin += kJobsPerCall) {
    std::vector<std::string> words{"scancel", "--quiet"};
    if (!signal.empty()) {
      words.insert(words.end(), {"--full", "--signal=" + signal});
    }
    const std::size_t end = std::min(jobs.size(), begin + kJobsPerCall);
    for (std::size_t i = begin; i < end; ++i) {
      words.push_back(std::to_string(jobs[i]));
    }
    ask(std::move(words));  // whether they have stopped is asked of squeue
  }
}

}  // namespace colloid
