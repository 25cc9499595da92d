/// The plan as text: one line for each thing that the scene did not need, and what was used.

#include <cstdarg>
#include <cstdio>

#include "contact/state.hpp"

namespace rollcon {
namespace {

void line(std::string& text, const char* format, ...) __attribute__((format(printf, 2, 3)));

void line(std::string& text, const char* format, ...) {
  char buffer[256];
  std::va_list args;
  va_start(args, format);
  std::vsnprintf(buffer, sizeof buffer, format, args);
  va_end(args);
  text += buffer;
  text += '\n';
}

}  // namespace

std::string describe_plan(const SolverState& s, const Body& body1, const Body& body2) {
  std::string text;
  const ContactOperators& op = s.problem.op;
  for (const Body* body : {&body1, &body2})
    if (body->rigid()) line(text, "body %d: rigid, no compliance", body == &body1 ? 1 : 2);
  if (!body1.rigid() && !body2.rigid())
    line(text, "both half-spaces: one compliance with summed constants");
  if (s.frictionless) {
    line(text, "friction is zero: no tangential unknowns%s",
         op.tangential ? "" : ", no convective operator assembled");
  } else if (!op.coupled) {
    line(text, "(1-2nu)/G equal on both sides: normal problem first, alone; no coupling blocks");
  } else {
    line(text, "normal and tangential problems coupled: solved together");
  }
  if (op.tangential)
    line(text, "convective scheme: %s",
         *s.scheme == Scheme::godunov         ? "godunov"
         : *s.scheme == Scheme::least_squares ? "least_squares"
                                              : "characteristic");
  for (int m = 0; m < 4; ++m)
    if (s.problem.by_force[static_cast<std::size_t>(m)]) {
      static constexpr const char* names[] = {"longitudinal creepage", "lateral creepage",
                                              "approach", "spin"};
      line(text, "%s: unknown of the Newton system (its load is given)", names[m]);
    }
  line(text, "operators: %lld nodes, %.1f MB, assembled %lld time(s) by this contact",
       static_cast<long long>(op.nodes), static_cast<double>(op.bytes()) / 1e6,
       static_cast<long long>(s.assemblies));
  line(text, "last solve: %lld factorisation(s), %lld Krylov iteration(s)",
       static_cast<long long>(s.factorizations), static_cast<long long>(s.linear_iterations));
  return text;
}

}  // namespace rollcon
