#pragma once
/// Does what a host does with the library, from the first handle to the last: the flows that the programs of this
/// folder run in unusual surroundings. Each returns its results, to be compared bit by bit with those of the same flow
/// elsewhere.

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rollcon.h"

namespace hosts {

/// Reports a call that ended with a status that the host did not expect.
struct Unexpected : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Makes the calls of a flow. Hosts derive their own, to meddle before and after each.
class Caller {
 public:
  virtual ~Caller() = default;
  /// Throws Unexpected at a negative status.
  void operator()(const char* name, const std::function<std::int32_t()>& function);
  /// Number of threads of every context and body of the flow.
  int threads = 1;
  /// Is called with each contact that is made, before its first solve.
  std::function<void(rollcon_contact*)> made_contact;
  rollcon_context* context = nullptr;

 protected:
  virtual std::int32_t make(const char* name, const std::function<std::int32_t()>& function);
};

struct Flow {
  const char* name;
  const char* feature;  ///< feature that it cannot run without; null: none
  std::vector<double> (*run)(Caller&);
};

/// Returns the flows whose features this build has.
std::vector<Flow> flows();

/// Returns a flow by its name.
Flow flow(const std::string& name);

/// Says whether the bits of two results are equal, also those of NaN.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b);
/// Returns the largest difference over the largest entry of the second.
double difference(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the folder where flows write files, made for this process and removed at its end.
const std::string& folder();

/// Holds the program's verdict: prints what is wrong and counts it.
class Verdict {
 public:
  /// Returns false if it is wrong.
  bool expect(bool right, const char* format, ...) __attribute__((format(printf, 3, 4)));
  int exit_code() const { return wrong_ > 0; }

 private:
  int wrong_ = 0;
};

}  // namespace hosts
