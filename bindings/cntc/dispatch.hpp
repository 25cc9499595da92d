#pragma once
#include <cmath>
#include <exception>
#include <tuple>
#include <type_traits>

#include "log.hpp"
#include "registry.hpp"

namespace cntc {

/// Names the modules that a function is for, and the contact problems (icp) that it takes in each.
enum class Category {
  none,          // no result element, or a result element alone
  gap,           // module 3, icp > 0
  wheel,         // module 1, no icp
  patch,         // module 1, icp > 0
  sum_or_patch,  // module 1, icp -1 or > 0
  input,         // module 1: -1, module 3: > 0
  result,        // modules 1 and 3, icp > 0
  both           // module 1: -1 or > 0, module 3: > 0
};

enum Refusal {
  bad_ire = -101,
  not_module1 = -102,
  not_module3 = -103,
  bad_icp = -104,
  icp_wanted = -105,
  icp_unwanted = -106,
  in_use = 305
};

/// Holds a call that was admitted; its problem is locked.
struct Call {
  const char* name;
  Problem& p;
  int icp;                         // icp of the caller; -1: the whole wheel
  std::string* refusal = nullptr;  // takes what would go to the log

  Inputs& in() const { return p.in; }
  const Units& units() const { return p.in.units; }
  /// Returns the result of the patch, or a null pointer with a line in the log.
  ContactResult* result() const;
  /// Returns the result of the patch with its elements, which are filled now if they were not before.
  ContactResult* elements() const;
};

/// Writes a line to the log, or to the refusal of the call.
void say(const Call& c, const char* format, ...) __attribute__((format(printf, 2, 3)));

/// Checks ire, icp and module, and makes the problem if there is none; returns 0 or the code of a refusal.
int admit(Category category, int ire, int icp, bool has_icp);
const char* refusal_text(int code);

/// Holds the last argument of a function that answers with an error code.
struct ErrorCode {
  int& value;
};

template <class T, class A>
decltype(auto) pass(A* pointer) {
  if constexpr (std::is_pointer_v<T>) {
    return static_cast<A*>(pointer);
  } else if constexpr (std::is_same_v<T, ErrorCode>) {
    return ErrorCode{*pointer};
  } else {
    return static_cast<A&>(*pointer);
  }
}

template <class T, class A>
bool finite(A* argument) {
  if constexpr (std::is_same_v<T, double>) return std::isfinite(*argument);
  return true;
}

template <class... T, class... A>
void apply_body(Call& c, void (*body)(Call&, T...), A*... arguments) {
  if (((!std::is_pointer_v<T> && !arguments) || ...)) return say(c, "an argument is NULL");
  if (!(finite<T>(arguments) && ...)) return say(c, "a number is not finite");
  body(c, pass<T>(arguments)...);
}

/// A body that takes a result is called with that of the patch, if there is one.
template <class R, class... T, class... A>
void apply_body(Call& c, void (*body)(Call&, const R&, T...), A*... arguments) requires std::is_base_of_v<Totals, R> {
  if (((!std::is_pointer_v<T> && !arguments) || ...)) return say(c, "an argument is NULL");
  if (const ContactResult* r = std::is_same_v<R, Totals> ? c.result() : c.elements())
    body(c, *r, pass<T>(arguments)...);
}

/// Tells whether a body answers with an error code, which its function has as its last argument.
template <class Body>
constexpr bool answers = false;
template <class... T>
constexpr bool answers<void (*)(T...)> = (std::is_same_v<T, ErrorCode> || ...);

/// Admits a call, or refuses it with a line in the log.
template <Category category, class Body, class... A>
void enter(const char* name, Body body, const int* ire, const int* icp, A*... arguments) {
  if (!ire || !icp) return log_line(name, 0, 0, "an argument is NULL");
  int* error = nullptr;
  if constexpr (answers<Body>) error = std::get<sizeof...(A) - 1>(std::tuple(arguments...));
  int code = admit(category, *ire, *icp, category != Category::wheel);
  if (!code) {
    const std::shared_ptr<Problem> problem = problem_of(*ire, *icp);
    std::unique_lock<std::mutex> guard;
    if (problem) guard = std::unique_lock(problem->mutex, std::try_to_lock);
    if (!problem) {
      code = CNTC_err_icp;
    } else if (!guard.owns_lock()) {
      code = in_use;
    } else {
      Call c{name, *problem, problem->module == 1 && *icp <= 0 ? -1 : *icp};
      try {
        return apply_body(c, body, arguments...);
      } catch (const std::exception& e) {
        if (error) *error = CNTC_err_other;
        return say(c, "failed: %s", e.what());
      }
    }
  }
  if (error) *error = code;
  log_line(name, *ire, *icp, "%s", refusal_text(code));
}

template <Category category, class Body, class... A>
void run(const char* name, Body body, const int* ire, const int* icp,
         A*... arguments) requires(category != Category::none && category != Category::wheel) {
  enter<category>(name, body, ire, icp, arguments...);
}

template <Category category, class Body, class... A>
void run(const char* name, Body body, const int* ire, A*... arguments) requires(category == Category::wheel) {
  static const int whole = -1;
  enter<category>(name, body, ire, &whole, arguments...);
}

template <Category category, class Body, class... A>
void run(const char* name, Body body, A*... arguments) requires(category == Category::none) {
  try {
    body(name, arguments...);
  } catch (const std::exception& e) {
    log_line(name, 0, 0, "failed: %s", e.what());
  }
}

}  // namespace cntc
