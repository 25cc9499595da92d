#pragma once
/// Holds what a contact remembers between steps in time: the tractions at the end of the last one.

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "contact/problem/prescribed.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

struct Iterate;

/// Holds a frame and the pair's compliance there.
struct FrameOfPast {
  Frame frame;
  std::unique_ptr<Compliance> compliance;  ///< made when tractions are carried to another frame
};

/// Holds the contact at the end of a step.
struct PastStep {
  bool loaded = false;            ///< false: the bodies are at rest, unstressed
  std::vector<double> lambda[3];  ///< t1, t2, n
  MotionValues motion{};          ///< the approach from no datum
  double time = 0;
  std::int64_t steps = 0;
  std::int64_t mesh = -1;  ///< revision of the frame's nodes and elements
  std::shared_ptr<FrameOfPast> on;

  /// Takes tractions and motions of an iterate whose approach counts from the datum.
  void take(const Iterate& iterate, double datum);
};

struct StepWorkspace {
  std::vector<double> traction, displacement;  ///< three values a node
  std::vector<std::int32_t> apart;             ///< nodes whose particles do not touch before the step
  std::vector<double> image[3];
};

struct StepHistory {
  PastStep last;    ///< start of the next step
  PastStep before;  ///< start of the last step
  bool can_repeat = false;
  bool of_steps = false;           ///< the last solve was a step: `last` is what it left
  bool failed = false;             ///< the last solve, a steady one, found nothing
  bool iterate_is_last = false;    ///< the iterate is that of `last`
  std::vector<double> carried[3];  ///< displacements a step before of the particles that are at the nodes now
  StepWorkspace work;

  std::size_t bytes() const;
};

}  // namespace rollcon
