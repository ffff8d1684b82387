#include "campaign/slurm_options.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"
#include "campaign/key_reader.h"

namespace colloid {

namespace {

using nlohmann::json;

constexpr const char* kNameCharacters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.,-";
constexpr const char* kValueCharacters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.,:+@%/=&|*()[]-";
constexpr std::size_t kLongestName = 128;
constexpr std::size_t kLongestOption = 256;

/// Where a job runs, what it gets, when it may begin, who is told.
const std::vector<std::string> kOptions{
    "begin",
    "comment",
    "constraint",
    "contiguous",
    "core-spec",
    "cpu-freq",
    "cpus-per-gpu",
    "cpus-per-task",
    "deadline",
    "distribution",
    "exclude",
    "exclusive",
    "gpus",
    "gpus-per-node",
    "gpus-per-task",
    "gres",
    "hint",
    "licenses",
    "mail-type",
    "mail-user",
    "mem-bind",
    "mem-per-gpu",
    "nice",
    "nodelist",
    "nodes",
    "ntasks-per-core",
    "ntasks-per-node",
    "oversubscribe",
    "prefer",
    "priority",
    "qos",
    "reservation",
    "spread-job",
    "switches",
    "threads-per-core",
    "tmp",
    "use-min-nodes",
    "wckey",
};

void read_name(KeyReader& read, const char* key, std::string& value) {
  const json* found = read.find(key);
  if (found == nullptr) {
    return;
  }
  const std::string text = found->is_string() ? found->get<std::string>() : "";
  require(!text.empty() && text.size() <= kLongestName && text[0] != '-' &&
              text.find_first_not_of(kNameCharacters) == std::string::npos,
          read.pointer_to(key),
          fmt::format("is {}, expected 1 to {} letters, digits or _.,- that do not begin "
                      "with -",
                      shown(*found), kLongestName));
  value = text;
}

void check_option(const json& given, const std::string& where) {
  const std::string text = given.is_string() ? given.get<std::string>() : "";
  require(text.size() > 2 && text.size() <= kLongestOption && text.rfind("--", 0) == 0 &&
              text.find_first_not_of(kValueCharacters) == std::string::npos,
          where,
          fmt::format("is {}, expected an option of sbatch such as \"--qos=long\", of "
                      "letters, digits and _.,:+@%/=&|*()[]- alone",
                      shown(given)));
  const std::string name = text.substr(2, text.find('=') - 2);
  require(std::find(kOptions.begin(), kOptions.end(), name) != kOptions.end(), where,
          fmt::format("--{} cannot be given here (partition, account, memory, ranks and "
                      "time have keys of their own; what a job does is poreclog's); the "
                      "nearest is --{}; known: {}",
                      name, nearest(name, kOptions), fmt::join(kOptions, ", ")));
}

}  // namespace

SlurmOptions read_slurm_options(const json& value, const std::string& pointer) {
  SlurmOptions options;
  KeyReader read(value, pointer);
  read_name(read, "partition", options.partition);
  read_name(read, "account", options.account);
  read.integer("memory_MiB", 0, 100'000'000, options.memory_MiB);
  read.integer("realisations_per_task", 0, 100'000, options.realisations_per_task);
  read.word("launcher", {"mpirun", "srun"}, options.launcher);
  if (const json* list = read.find("options")) {
    const std::string where = read.pointer_to("options");
    require(list->is_array(), where,
            fmt::format("is {}, expected a list of texts", shown(*list)));
    for (std::size_t i = 0; i < list->size(); ++i) {
      check_option((*list)[i], fmt::format("{}/{}", where, i));
    }
    options.options = list->get<std::vector<std::string>>();
  }
  read.finish();
  return options;
}

json to_json(const SlurmOptions& options) {
  json out{{"memory_MiB", options.memory_MiB},
           {"realisations_per_task", options.realisations_per_task},
           {"launcher", options.launcher},
           {"options", options.options}};
  if (!options.partition.empty()) {
    out["partition"] = options.partition;
  }
  if (!options.account.empty()) {
    out["account"] = options.account;
  }
  return out;
}

}  // namespace colloid
