#pragma once
/// Long work in the middle of a call asks here whether its caller still wants it: loops of parallel.hpp by themselves,
/// others between their parts by check_interrupt().

namespace rollcon {

/// Thrown out of work that its caller asked to stop; no failure.
struct Cancelled {};

/// Whom the work of this thread asks, while it lives; the one before it is asked again after that.
class Interrupt {
 public:
  Interrupt();
  virtual ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Of this thread; null: nobody asks.
  static Interrupt* current();
  /// Throws Cancelled if a stop is wanted. `own`: this is the thread that made it, and the host is told that the work
  /// goes on, ten times a second at most.
  void check(bool own = true);
  /// Whether a stop is wanted; any thread, no call of the host.
  virtual bool wanted() const = 0;

 protected:
  /// Tells the host.
  virtual void tell() = 0;

 private:
  Interrupt* former_;
  double told_;
};

/// Does nothing where nobody can ask for a stop.
void check_interrupt();

}  // namespace rollcon
