/* Counts a program's MPI calls, by name, with the bytes it sends and the seconds it waits in them.
   Preloaded (mpicc -shared -fPIC -O2 mpi_calls.c -o mpi_calls.so; mpirun -x LD_PRELOAD=...): the
   profiling interface of the MPI standard (MPI 3.1, chapter 14).  At its end rank 0 prints
   "mpi NAME CALLS BYTES SECONDS" to standard error, a line for each name that it called. */
#include <mpi.h>
#include <stdio.h>

enum { ALLREDUCE, ALLTOALL, ALLTOALLV, ALLGATHER, ALLGATHERV, IALLGATHER, BCAST, GATHERV, SCATTERV,
       SEND, BSEND, ISEND, RECV, IRECV, WAIT, WAITALL, PROBE, NAMES };
static const char* const names[NAMES] = {
    "Allreduce", "Alltoall", "Alltoallv", "Allgather", "Allgatherv", "Iallgather", "Bcast", "Gatherv",
    "Scatterv", "Send", "Bsend", "Isend", "Recv", "Irecv", "Wait", "Waitall", "Probe"};
static long calls[NAMES];
static double bytes[NAMES];
static double seconds[NAMES];

static double size_of(int count, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  return (double)count * size;
}

static double sum_of(const int counts[], MPI_Datatype type, MPI_Comm comm) {
  int ranks = 0;
  double sum = 0.0;
  PMPI_Comm_size(comm, &ranks);
  for (int i = 0; i < ranks; ++i) {
    sum += size_of(counts[i], type);
  }
  return sum;
}

/* The call `what`, counted under `name` as sending `sent` bytes. */
#define COUNT(name, sent, what)           \
  const double begin = PMPI_Wtime();      \
  const int error = what;                 \
  seconds[name] += PMPI_Wtime() - begin;  \
  bytes[name] += (sent);                  \
  ++calls[name];                          \
  return error

int MPI_Allreduce(const void* in, void* out, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c) {
  COUNT(ALLREDUCE, size_of(n, t), PMPI_Allreduce(in, out, n, t, op, c));
}
int MPI_Alltoall(const void* in, int n, MPI_Datatype t, void* out, int m, MPI_Datatype u, MPI_Comm c) {
  COUNT(ALLTOALL, size_of(n, t), PMPI_Alltoall(in, n, t, out, m, u, c));
}
int MPI_Alltoallv(const void* in, const int n[], const int d[], MPI_Datatype t, void* out,
                  const int m[], const int e[], MPI_Datatype u, MPI_Comm c) {
  COUNT(ALLTOALLV, sum_of(n, t, c), PMPI_Alltoallv(in, n, d, t, out, m, e, u, c));
}
int MPI_Allgather(const void* in, int n, MPI_Datatype t, void* out, int m, MPI_Datatype u, MPI_Comm c) {
  COUNT(ALLGATHER, size_of(n, t), PMPI_Allgather(in, n, t, out, m, u, c));
}
int MPI_Allgatherv(const void* in, int n, MPI_Datatype t, void* out, const int m[], const int d[],
                   MPI_Datatype u, MPI_Comm c) {
  COUNT(ALLGATHERV, size_of(n, t), PMPI_Allgatherv(in, n, t, out, m, d, u, c));
}
int MPI_Iallgather(const void* in, int n, MPI_Datatype t, void* out, int m, MPI_Datatype u, MPI_Comm c,
                   MPI_Request* r) {
  COUNT(IALLGATHER, size_of(n, t), PMPI_Iallgather(in, n, t, out, m, u, c, r));
}
int MPI_Bcast(void* b, int n, MPI_Datatype t, int root, MPI_Comm c) {
  COUNT(BCAST, size_of(n, t), PMPI_Bcast(b, n, t, root, c));
}
int MPI_Gatherv(const void* in, int n, MPI_Datatype t, void* out, const int m[], const int d[],
                MPI_Datatype u, int root, MPI_Comm c) {
  COUNT(GATHERV, size_of(n, t), PMPI_Gatherv(in, n, t, out, m, d, u, root, c));
}
int MPI_Scatterv(const void* in, const int n[], const int d[], MPI_Datatype t, void* out, int m,
                 MPI_Datatype u, int root, MPI_Comm c) {
  COUNT(SCATTERV, size_of(m, u), PMPI_Scatterv(in, n, d, t, out, m, u, root, c));
}
int MPI_Send(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {
  COUNT(SEND, size_of(n, t), PMPI_Send(b, n, t, to, tag, c));
}
int MPI_Bsend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) {
  COUNT(BSEND, size_of(n, t), PMPI_Bsend(b, n, t, to, tag, c));
}
int MPI_Isend(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r) {
  COUNT(ISEND, size_of(n, t), PMPI_Isend(b, n, t, to, tag, c, r));
}
int MPI_Recv(void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Status* s) {
  COUNT(RECV, 0.0, PMPI_Recv(b, n, t, from, tag, c, s));
}
int MPI_Irecv(void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Request* r) {
  COUNT(IRECV, 0.0, PMPI_Irecv(b, n, t, from, tag, c, r));
}
int MPI_Wait(MPI_Request* r, MPI_Status* s) {
  COUNT(WAIT, 0.0, PMPI_Wait(r, s));
}
int MPI_Waitall(int n, MPI_Request r[], MPI_Status s[]) {
  COUNT(WAITALL, 0.0, PMPI_Waitall(n, r, s));
}
int MPI_Probe(int from, int tag, MPI_Comm c, MPI_Status* s) {
  COUNT(PROBE, 0.0, PMPI_Probe(from, tag, c, s));
}

int MPI_Finalize(void) {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (int i = 0; rank == 0 && i < NAMES; ++i) {
    if (calls[i] > 0) {
      fprintf(stderr, "mpi %s %ld %.0f %.6f\n", names[i], calls[i], bytes[i], seconds[i]);
    }
  }
  return PMPI_Finalize();
}
