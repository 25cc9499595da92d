#pragma once
/// Lets long work in the middle of a call ask whether its caller still wants it: loops of parallel.hpp ask by
/// themselves, others between their parts by check_interrupt().

namespace rollcon {

/// Is thrown out of work that its caller asked to stop; it is no failure.
struct Cancelled {};

/// Is asked by the work of this thread while it lives; the one before it is asked again after that.
class Interrupt {
 public:
  Interrupt();
  virtual ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Returns the one of this thread; null if nobody asks.
  static Interrupt* current();
  /// Throws Cancelled if a stop is wanted. With `own` the caller is the thread that made it, and the host is told that
  /// the work goes on, ten times a second at most.
  void check(bool own = true);
  /// Says whether a stop is wanted; any thread may ask, and the host is not called.
  virtual bool wanted() const = 0;

 protected:
  /// Tells the host that the work goes on.
  virtual void tell() = 0;

 private:
  Interrupt* former_;
  double told_;
};

/// Does nothing where nobody can ask for a stop.
void check_interrupt();

}  // namespace rollcon
