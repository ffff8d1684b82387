// Hands the planes of a level to threads.
#pragma once

#include <vector>

namespace colloid {

/// Calls work(k) for k = 0 .. count - 1, each k once, on `threads` threads.
template <class Work>
void for_planes(int count, int threads, const Work& work) {
#ifdef PORECLOG_OPENMP
  if (threads > 1) {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int k = 0; k < count; ++k) {
      work(k);
    }
    return;
  }
#else
  (void)threads;
#endif
  for (int k = 0; k < count; ++k) {
    work(k);
  }
}

/// Sum of term(k) over the planes, in the order of k: the same for any number of threads.
template <class Term>
double sum_planes(int count, int threads, const Term& term) {
  std::vector<double> part(static_cast<std::size_t>(count));
  for_planes(count, threads, [&](int k) { part[static_cast<std::size_t>(k)] = term(k); });
  double sum = 0.0;
  for (double p : part) {
    sum += p;
  }
  return sum;
}

}  // namespace colloid
