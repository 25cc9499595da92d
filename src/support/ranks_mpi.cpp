/// Talks to other ranks by MPI. Only the thread that makes a call does so.

#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>

#include "support/ranks.hpp"

namespace rollcon {
namespace {

void require(int code, const char* what) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  MPI_Error_string(code, text, &length);
  fail(Status::err_internal, "%s failed: %s", what, text);
}

}  // namespace

Ranks Ranks::of(std::int32_t communicator) {
  int runs = 0, ended = 0;
  MPI_Initialized(&runs);
  MPI_Finalized(&ended);
  if (!runs || ended) fail(Status::err_state, "MPI does not run: call MPI_Init before, and MPI_Finalize after this");
  const MPI_Comm comm = MPI_Comm_f2c(communicator);
  if (comm == MPI_COMM_NULL)
    fail(Status::err_argument,
         "communicator is %d, which is none; allowed: MPI_Comm_c2f() of a communicator, in Fortran its handle",
         communicator);
  Ranks ranks;
  ranks.communicator_ = communicator;
  require(MPI_Comm_rank(comm, &ranks.rank_), "MPI_Comm_rank");
  require(MPI_Comm_size(comm, &ranks.size_), "MPI_Comm_size");
  return ranks;
}

void Ranks::least(std::int64_t* value, int n) const {
  require(MPI_Allreduce(MPI_IN_PLACE, value, n, MPI_INT64_T, MPI_MIN, MPI_Comm_f2c(communicator_)), "MPI_Allreduce");
}

void Ranks::take_from(int rank, void* bytes, int n) const {
  require(MPI_Bcast(bytes, n, MPI_BYTE, rank, MPI_Comm_f2c(communicator_)), "MPI_Bcast");
}

void Ranks::join(std::uint8_t* bytes, std::int64_t n) const {
  constexpr std::int64_t most = 1 << 28;
  for (std::int64_t first = 0; first < n; first += most)
    require(MPI_Allreduce(MPI_IN_PLACE, bytes + first, static_cast<int>(std::min(most, n - first)), MPI_BYTE, MPI_BOR,
                          MPI_Comm_f2c(communicator_)),
            "MPI_Allreduce");
}

}  // namespace rollcon
