#include "tiers/transient/ranks.h"

#include <algorithm>
#include <numeric>

#include <mpi.h>

namespace colloid {

namespace {

bool several() {
  int initialised = 0;
  MPI_Initialized(&initialised);
  return initialised != 0 && rank_count() > 1;
}

template <class T>
std::vector<T> gather(const std::vector<T>& own, MPI_Datatype type) {
  if (!several()) {
    return own;
  }
  const auto ranks = static_cast<std::size_t>(rank_count());
  const int count = static_cast<int>(own.size());
  std::vector<int> counts(ranks);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  std::vector<int> starts(ranks, 0);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<T> all(static_cast<std::size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(own.data(), count, type, all.data(), counts.data(), starts.data(), type,
                 MPI_COMM_WORLD);
  return all;
}

template <class Container>
void share(Container& values, MPI_Datatype type) {
  if (!several()) {
    return;
  }
  auto size = static_cast<std::int64_t>(values.size());
  MPI_Bcast(&size, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  values.resize(static_cast<std::size_t>(size));
  MPI_Bcast(values.data(), static_cast<int>(size), type, 0, MPI_COMM_WORLD);
}

}  // namespace

int this_rank() {
  int initialised = 0;
  int rank = 0;
  MPI_Initialized(&initialised);
  if (initialised != 0) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  }
  return rank;
}

int rank_count() {
  int initialised = 0;
  int count = 1;
  MPI_Initialized(&initialised);
  if (initialised != 0) {
    MPI_Comm_size(MPI_COMM_WORLD, &count);
  }
  return count;
}

void sum_over_ranks(double* values, std::size_t count) {
  if (several() && count > 0) {
    MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(count), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
  }
}

double largest_over_ranks(double value) {
  if (several()) {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  }
  return value;
}

void broadcast(std::vector<double>& values) {
  share(values, MPI_DOUBLE);
}

void broadcast(std::string& text) {
  share(text, MPI_CHAR);
}

std::vector<double> gather_all(const std::vector<double>& own) {
  return gather(own, MPI_DOUBLE);
}

std::vector<std::int64_t> gather_all(const std::vector<std::int64_t>& own) {
  return gather(own, MPI_INT64_T);
}

}  // namespace colloid
