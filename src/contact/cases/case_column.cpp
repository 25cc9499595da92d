/// Finds columns of a list's results by name.

#include <algorithm>
#include <cstring>
#include <string>

#include "contact/cases/solve_many.hpp"
#include "contact/statistics.hpp"

namespace rollcon {

CaseColumn case_column(const char* name, std::size_t length, std::int64_t parameters, std::int64_t nodes) {
  using Kind = CaseColumn::Kind;
  struct Named {
    const char* name;
    CaseColumn column;
  };
  const Named known[] = {{"force", {.kind = Kind::force, .width = 3}},
                         {"moment", {.kind = Kind::moment, .width = 3}},
                         {"approach", {.kind = Kind::approach, .width = 1}},
                         {"creep", {.kind = Kind::creep, .width = 3}},
                         {"tilt", {.kind = Kind::tilt, .width = 2}},
                         {"derivatives", {.kind = Kind::derivatives, .width = 10 * parameters}},
                         {"tractions", {.kind = Kind::tractions, .width = 3 * nodes}}};
  const auto is = [&](const char* other) {
    return std::strlen(other) == length && std::memcmp(other, name, length) == 0;
  };
  std::string allowed;
  for (const Named& n : known) {
    if (is(n.name)) return n.column;
    allowed += (allowed.empty() ? "" : ", ") + std::string(n.name);
  }
  for (const Statistic& s : statistics()) {
    if (!s.of_cases) continue;
    if (is(s.info.name)) return {.kind = Kind::number, .number = s.value, .width = 1};
    allowed += ", " + std::string(s.info.name);
  }
  fail(Status::err_option, "columns has '%.*s'; allowed: %s", static_cast<int>(std::min<std::size_t>(length, 60)), name,
       allowed.c_str());
}

}  // namespace rollcon
