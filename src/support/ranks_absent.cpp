/// Stands in for MPI in a build without it: there is one rank.

#include "support/ranks.hpp"

namespace rollcon {

Ranks Ranks::of(std::int32_t /*communicator*/) {
  fail(Status::err_unsupported, "this build of rollcon is without MPI (ROLLCON_WITH_MPI=OFF)");
}

std::int32_t Ranks::handle() const {
  return 0;
}

void Ranks::least(std::int64_t* /*value*/, int /*n*/) const {}
void Ranks::take_from(int /*rank*/, void* /*bytes*/, int /*n*/) const {}
void Ranks::join(std::uint8_t* /*bytes*/, std::int64_t /*n*/) const {}

}  // namespace rollcon
