#include "execute/slurm_journal.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/clock.h"
#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"

namespace colloid {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNameDigits = 10;  // of a hash: no two folders share a name

/// Names of the submissions' folders, ascending.
std::vector<std::string> numbered(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (fs::directory_iterator entry(folder, none), end; entry != end;
       entry.increment(none)) {
    const std::string name = entry->path().filename().string();
    if (name.find_first_not_of("0123456789") == std::string::npos) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end(), [](const auto& a, const auto& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return names;
}

Submission read_submission(const std::string& folder) {
  Submission submission;
  submission.folder = folder;
  submission.number = std::atoi(folder.substr(folder.rfind('/') + 1).c_str());
  const std::string file = folder + "/submission.json";
  const auto parsed =
      nlohmann::json::parse(read_if_there(file).value_or(""), nullptr, false);
  if (!parsed.is_object()) {
    throw StorageError(file + " is not what was written there");
  }
  submission.name = parsed.at("name").get<std::string>();
  submission.per_task = parsed.at("per_task").get<long>();
  std::istringstream list(read_if_there(folder + "/list").value_or(""));
  for (std::string line; std::getline(list, line);) {
    submission.attempts.push_back(line);
  }
  if (const auto job = read_if_there(folder + "/job")) {
    submission.job = std::atoll(job->c_str());
  }
  return submission;
}

}  // namespace

SlurmJournal::SlurmJournal(const std::string& folder, std::string campaign)
    : folder_(folder + "/slurm"), campaign_(std::move(campaign)) {}

std::vector<Submission> SlurmJournal::open() const {
  std::vector<Submission> out;
  for (const std::string& name : numbered(folder_)) {
    const std::string folder = folder_ + "/" + name;
    if (!is_file(folder + "/closed")) {
      out.push_back(read_submission(folder));
    }
  }
  return out;
}

Submission SlurmJournal::next() const {
  const std::vector<std::string> names = numbered(folder_);
  Submission submission;
  submission.number = names.empty() ? 1 : std::atoi(names.back().c_str()) + 1;
  submission.folder = fmt::format("{}/{:06}", folder_, submission.number);
  // The time tells it from that of a run folder of the same name that was removed.
  const std::string hash =
      sha256(fmt::format("{} {} {}", submission.folder, utc_now(), ::getpid()));
  submission.name = fmt::format("poreclog-{}-{}-{}", campaign_, submission.number,
                                hash.substr(0, kNameDigits));
  return submission;
}

void SlurmJournal::begin(const Submission& submission, const std::string& script) const {
  const std::string part = submission.folder + ".part";
  std::error_code error;
  fs::remove_all(part, error);  // of one that was killed here
  make_folder(part);
  std::string list;
  for (const std::string& folder : submission.attempts) {
    list += folder + "\n";
  }
  write_whole(part + "/list", list, true);
  write_whole(part + "/script", script, true);
  const nlohmann::json record{{"schema_version", 1},
                              {"name", submission.name},
                              {"per_task", submission.per_task},
                              {"written", utc_now()}};
  write_whole(part + "/submission.json", record.dump(1) + "\n", true);
  if (::rename(part.c_str(), submission.folder.c_str()) != 0) {
    throw StorageError(
        fmt::format("{}: cannot be made: {}", submission.folder, std::strerror(errno)));
  }
}

void SlurmJournal::accept(Submission& submission, std::int64_t job) const {
  write_whole(submission.folder + "/job", fmt::format("{}\n", job), true);
  submission.job = job;
}

void SlurmJournal::close(const Submission& submission) const {
  write_whole(submission.folder + "/closed", utc_now() + "\n", true);
}

}  // namespace colloid
