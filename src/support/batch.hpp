#pragma once
/// Collects the answers of a list, which the ranks of the context and the threads of parallel_for find one by one. An
/// answer that fails leaves the others as they are.

#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "support/context.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {

class Batch {
 public:
  /// Marks all answers as cancelled until they are found.
  Batch(std::int64_t answers, const Context& context)
      : context_(context), status_(at(answers), Status::cancelled), taken_(at(answers), 0) {}

  /// Takes the status that find() returns; returns false if it threw, and takes its exception. Any thread may call it.
  template <class Find>
  bool take(std::int64_t i, const Find& find) {
    taken_[at(i)] = 1;
    try {
      status_[at(i)] = find();
      return true;
    } catch (const Cancelled&) {
      // The status stays cancelled.
    } catch (...) {
      keep_failure(i);
    }
    return false;
  }

  /// Gives all ranks the statuses that any of them has taken, and the numbers. `row` of each rank has `width` numbers
  /// for each answer, `stride` apart. All ranks call it with the same lists.
  void give(double* row, std::int64_t width, std::int64_t stride);
  /// Gives answer i the status of answer `from`.
  void repeat(std::int64_t i, std::int64_t from) { status_[at(i)] = status_[at(from)]; }
  /// Logs failures in the order of the list, with `what` the name of an entry. Returns the worst status. Fills status,
  /// which may be null, with each one.
  Status finish(const char* what, std::int32_t* status);

 private:
  void keep_failure(std::int64_t i);

  const Context& context_;
  std::vector<Status> status_;
  std::vector<std::uint8_t> taken_;  ///< by this rank
  std::mutex mutex_;                 ///< guards the members below
  std::vector<std::pair<std::int64_t, std::string>> failures_;
};

}  // namespace rollcon
