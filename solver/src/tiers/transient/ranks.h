// The processes that share one realisation.  One process needs no mpirun: everything here
// then does nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace colloid {

int this_rank();
int rank_count();

/// Sums over all ranks, in place, the same on each.
void sum_over_ranks(double* values, std::size_t count);
double largest_over_ranks(double value);

/// Rank 0's values, on every rank.
void broadcast(std::vector<double>& values);
void broadcast(std::string& text);

/// The concatenation of every rank's values, in the order of the ranks.
std::vector<double> gather_all(const std::vector<double>& own);
std::vector<std::int64_t> gather_all(const std::vector<std::int64_t>& own);

}  // namespace colloid
