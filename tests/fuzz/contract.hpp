#pragma once
/// Checks what the header promises of every call: a broken promise aborts the program.

#include <rollcon.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

/// Aborts, saying what is wrong, unless `good`.
void require(bool good, const std::string& what);

/// Checks that the status is one that the header lists for the function. After a failure the context's text begins with
/// the function's name; a null context is not asked.
std::int32_t checked(const char* function, const rollcon_context* context, std::int32_t status);

/// Returns the names of options of contacts and bodies, and of statistics of both.
const std::vector<std::string>& known_names();

/// Holds an output of the caller's, marked before the call, and exactly as long as it says.
template <class T>
class Output {
 public:
  explicit Output(std::int64_t n) : entry_(static_cast<std::size_t>(n), mark()) {}
  T* data() { return entry_.data(); }
  const std::vector<T>& values() const { return entry_; }
  bool untouched(std::size_t from = 0) const {
    for (std::size_t i = from; i < entry_.size(); ++i)
      if (entry_[i] != mark()) return false;
    return true;
  }

 private:
  static T mark() { return static_cast<T>(113); }
  std::vector<T> entry_;
};

bool all_finite(const std::vector<double>& values);

}  // namespace fuzz
