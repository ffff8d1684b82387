// one_rank_fails RANK CODE HOW: that rank (or `both`) ends with CODE and a complaint; the
// others wait for it for ever (HOW alone) or end well (HOW after).
#include <cstdlib>
#include <string>

#include <mpi.h>

#include "tiers/transient/runtime.h"

int main(int argc, char** argv) {
  colloid::Runtime runtime(argc, argv);
  const std::string who = argv[1];
  const bool fails = who == "both" || std::atoi(who.c_str()) == runtime.rank();
  if (fails) {
    return runtime.end(std::atoi(argv[2]), "something is wrong\n");
  }
  if (std::string(argv[3]) == "alone") {
    MPI_Barrier(MPI_COMM_WORLD);
  }
  return runtime.end(0, "");
}
