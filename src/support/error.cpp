#include "support/error.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace rollcon {

Status worse(Status a, Status b) {
  constexpr Status order[] = {Status::cancelled,  Status::not_converged, Status::derailed,
                              Status::too_deep,   Status::coarse,        Status::rim_contact,
                              Status::inaccurate, Status::no_contact,    Status::ok};
  for (Status* const s : {&a, &b})
    if (static_cast<std::int32_t>(*s) < 0) *s = Status::not_converged;
  return *std::find_if(std::begin(order), std::end(order) - 1, [&](Status s) { return s == a || s == b; });
}

void fail(Status status, const char* format, ...) {
  std::va_list args;
  va_start(args, format);
  std::va_list again;
  va_copy(again, args);
  const int length = std::vsnprintf(nullptr, 0, format, args);
  va_end(args);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  if (length > 0) std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  throw Error(status, std::move(text));
}

}  // namespace rollcon
