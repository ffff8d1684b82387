/* Stands in for poreclog-solve-transient where ranks are tested: every rank says who it is
 * and where, by MPI; then rank 0 does what fake_solver does (FAKE_SOLVER names it). */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

int main(int argc, char** argv) {
  int rank = 0;
  int size = 0;
  char host[256] = "";
  (void)argc;
  MPI_Init(NULL, NULL);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  gethostname(host, sizeof host - 1);
  char (*hosts)[sizeof host] = malloc((size_t)size * sizeof host);
  MPI_Gather(host, sizeof host, MPI_CHAR, hosts, sizeof host, MPI_CHAR, 0, MPI_COMM_WORLD);
  int status = 0;
  if (rank == 0) {
    for (int i = 0; i < size; ++i) {
      printf("rank%d/%d %s\n", i, size, hosts[i]);
    }
    fflush(stdout);
    const pid_t solver = fork();
    if (solver == 0) {
      execv(getenv("FAKE_SOLVER"), argv);
      _exit(127);
    }
    waitpid(solver, &status, 0);
  }
  free(hosts);
  MPI_Bcast(&status, 1, MPI_INT, 0, MPI_COMM_WORLD);
  MPI_Finalize();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 4;
}
