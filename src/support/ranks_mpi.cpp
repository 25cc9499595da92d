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

void require_mpi() {
  int runs = 0, ended = 0;
  MPI_Initialized(&runs);
  MPI_Finalized(&ended);
  if (!runs || ended) fail(Status::err_state, "MPI does not run: call MPI_Init before, and MPI_Finalize after this");
}

}  // namespace

Ranks Ranks::of(std::int32_t communicator) {
  require_mpi();
  const MPI_Comm comm = MPI_Comm_f2c(communicator);
  if (comm == MPI_COMM_NULL)
    fail(Status::err_argument,
         "communicator is %d, which is none; allowed: MPI_Comm_c2f() of a communicator, in Fortran its handle",
         communicator);
  Ranks ranks;
  ranks.communicator_ = communicator;
  require(MPI_Comm_rank(comm, &ranks.rank_), "MPI_Comm_rank");
  require(MPI_Comm_size(comm, &ranks.size_), "MPI_Comm_size");
  MPI_Comm machine = MPI_COMM_NULL;
  require(MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine), "MPI_Comm_split_type");
  require(MPI_Comm_size(machine, &ranks.on_machine_), "MPI_Comm_size");
  require(MPI_Comm_free(&machine), "MPI_Comm_free");
  return ranks;
}

std::int32_t Ranks::handle() const {
  if (size_ > 1) return communicator_;
  require_mpi();
  return static_cast<std::int32_t>(MPI_Comm_c2f(MPI_COMM_SELF));
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
