#pragma once
/// Shares work among the processes of an MPI program, all of which make the same calls with the same data. A process
/// alone is rank 0 of 1, and shares nothing.

#include <cstdint>
#include <type_traits>
#include <vector>

#include "support/error.hpp"

namespace rollcon {

class Ranks {
 public:
  Ranks() = default;
  /// Takes the ranks of MPI's communicator, given by its Fortran handle. Throws err_unsupported in a build without MPI,
  /// and err_state where MPI does not run or the handle is none.
  static Ranks of(std::int32_t communicator);

  int size() const { return size_; }
  /// Returns how many of the ranks share this one's machine and its memory.
  int on_machine() const { return on_machine_; }
  /// Returns the Fortran handle of the communicator, or of one that has this rank alone; 0 in a build without MPI.
  /// Throws err_state where MPI does not run.
  std::int32_t handle() const;

  /// Says whether work i is this rank's.
  bool mine(std::int64_t i) const { return i % size_ == rank_; }

  /// Does a call's work, which may give() in between. If it throws on one rank it throws on all of them, so that
  /// none waits for another. They get the status of the first rank that fails, and its text after its number.
  template <class Work>
  auto together(const Work& work) const {
    if (size_ == 1) return work();
    try {
      if constexpr (std::is_void_v<decltype(work())>) {
        work();
        return agree(0);
      } else {
        auto result = work();
        agree(0);
        return result;
      }
    } catch (const OfAnother&) {
      throw;
    } catch (...) {
      disagree();
    }
  }

  /// Gives `count` rows of `bytes` bytes, `stride` bytes apart, to all ranks: known[i] says whether this rank has row
  /// i, and in the end whether any has. Rows that none has stay as they are. Ranks that have a row have the same one.
  void give(void* rows, std::int64_t count, std::int64_t bytes, std::int64_t stride,
            std::vector<std::uint8_t>& known) const;
  /// Tells all ranks that this one goes on with `count` rows. Throws if another rank fails, with its status.
  void agree(std::int64_t count) const;
  /// Returns the least of all ranks' values.
  std::int64_t least(std::int64_t value) const;
  /// Replaces bytes by those of rank 0.
  void take_from_first(void* bytes, std::int64_t n) const;

 private:
  struct OfAnother {};  ///< marks exceptions that all ranks know of
  template <class Thrown>
  struct OnAll;
  /// Tells all ranks of the exception in flight, from a catch block, and throws what all of them throw.
  [[noreturn]] void disagree() const;
  void tell(Status status, const char* text, std::int64_t count) const;

  // Only the members below know MPI.
  /// Replaces each value by the least of all ranks.
  void least(std::int64_t* value, int n) const;
  /// Replaces bytes by those of a rank.
  void take_from(int rank, void* bytes, int n) const;
  /// Replaces bytes by the bitwise or of all ranks.
  void join(std::uint8_t* bytes, std::int64_t n) const;

  std::int32_t communicator_ = 0;
  int rank_ = 0, size_ = 1, on_machine_ = 1;
};

/// Shares the work of this thread among the ranks, all of which do the same, while an object of this class lives.
/// Without one each rank works for itself.
class SharedWork {
 public:
  explicit SharedWork(const Ranks& ranks);
  ~SharedWork();
  SharedWork(const SharedWork&) = delete;
  SharedWork& operator=(const SharedWork&) = delete;

  static const Ranks& ranks();

 private:
  const Ranks* former_;
};

}  // namespace rollcon
