#include "tiers/transient/runtime.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>
#include <vector>

#include <Pstream.H>
#include <error.H>
#include <fcntl.h>
#include <foamVersion.H>
#include <messageStream.H>
#include <mpi.h>
#include <unistd.h>

namespace colloid {

namespace {

using Clock = std::chrono::steady_clock;

// For ranks that fail for the same reason to find each other.
constexpr std::chrono::seconds kGrace{2};
constexpr std::chrono::milliseconds kPause{1};

void silence_and_catch() {
  Foam::messageStream::level = 0;
  Foam::infoDetailLevel = 0;
  Foam::FatalError.throwExceptions();
  Foam::FatalIOError.throwExceptions();
}

void point_to_nothing(int descriptor) {
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0) {
    ::dup2(nothing, descriptor);
    ::close(nothing);
  }
}

}  // namespace

Runtime::Runtime(int& argc, char**& argv) {
  silence_and_catch();
  MPI_Init(&argc, &argv);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  if (ranks_ > 1) {
    Foam::UPstream::init(argc, argv, false);  // on one rank it refuses
  }
  if (rank_ > 0) {
    error_output_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
    point_to_nothing(STDOUT_FILENO);
    point_to_nothing(STDERR_FILENO);
  }
  if (Foam::foamVersion::api != OPENFOAM) {
    // Its classes are laid out otherwise than in the headers.
    throw std::runtime_error("the library of OpenFOAM is of version " +
                             std::to_string(Foam::foamVersion::api) + ", expected " +
                             std::to_string(OPENFOAM));
  }
}

Runtime::~Runtime() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized == 0) {
    MPI_Finalize();
  }
}

bool Runtime::on_all(bool holds) const {
  int all_hold = holds ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all_hold, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return all_hold == 1;
}

int Runtime::end(int exit_code, const std::string& complaint) {
  std::vector<int> codes(static_cast<std::size_t>(ranks_), 0);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Comm comm = MPI_COMM_WORLD;
  MPI_Iallgather(&exit_code, 1, MPI_INT, codes.data(), 1, MPI_INT, comm, &request);
  const auto begin = Clock::now();
  int all_are_here = 0;
  for (MPI_Test(&request, &all_are_here, MPI_STATUS_IGNORE); all_are_here == 0;
       MPI_Test(&request, &all_are_here, MPI_STATUS_IGNORE)) {
    if (exit_code != 0 && Clock::now() - begin > kGrace) {
      complain(complaint);
      MPI_Abort(MPI_COMM_WORLD, exit_code);
    }
    std::this_thread::sleep_for(kPause);
  }
  const auto failed =
      std::find_if(codes.begin(), codes.end(), [](int code) { return code != 0; });
  if (failed - codes.begin() == rank_) {
    complain(complaint);
  }
  MPI_Finalize();
  return failed == codes.end() ? 0 : *failed;
}

void Runtime::complain(const std::string& complaint) const {
  const std::string text =
      (rank_ == 0 ? "" : "rank " + std::to_string(rank_) + ": ") + complaint;
  if (!complaint.empty() && ::write(error_output_, text.data(), text.size()) < 0) {
    std::fputs(text.c_str(), stderr);
  }
}

}  // namespace colloid
