#include "dispatch.hpp"

#include <cstdarg>
#include <cstdio>

#include "wheel_solver.hpp"

namespace cntc {

int admit(Category category, int ire, int icp, bool has_icp) {
  if (ire < 1 || ire > most_ire) return bad_ire;
  if (has_icp && (icp > most_icp && module_of(ire) != 1)) return bad_icp;
  if (has_icp && (icp < -1 || icp > 99)) return bad_icp;
  int module = module_of(ire);
  if (!module) {
    module = category == Category::wheel ? 1 : category == Category::gap ? 3 : icp <= 0 ? 1 : 3;
    if (module == 3 && icp > most_icp) return bad_icp;
    begin_session(false, "", "", "");
    if (!make_element(ire, module)) return bad_ire;
  }
  const bool positive = icp > 0;
  if (module == 1) {
    if (category == Category::gap) return not_module1;
    if (category == Category::input && positive) return icp_unwanted;
    if ((category == Category::patch || category == Category::result) && !positive) return icp_wanted;
    return 0;
  }
  if (category == Category::wheel || category == Category::patch || category == Category::sum_or_patch)
    return not_module3;
  return positive ? 0 : icp_wanted;
}

const char* refusal_text(int code) {
  switch (code) {
    case bad_ire:
      return "result element is not 1 to 999, or 100 are alive";
    case not_module1:
      return "this function is not for module 1";
    case not_module3:
      return "this function is not for module 3";
    case bad_icp:
      return "contact problem is out of range";
    case icp_wanted:
      return "this function needs a contact problem icp > 0";
    case icp_unwanted:
      return "this function is for the whole wheel: icp is -1";
    case in_use:
      return "this contact problem is being used by another thread";
    default:
      return "there is no such contact problem";
  }
}

void say(const Call& c, const char* format, ...) {
  char text[2048];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (c.refusal) {
    *c.refusal = text;
  } else {
    log_line(c.name, c.p.ire, c.icp, "%s", text);
  }
}

ContactResult* Call::elements() const {
  ContactResult* r = result();
  if (r && r->deferred) p.wheel->fill_elements(p, size_t(icp - 1));
  return r;
}

ContactResult* Call::result() const {
  const int k = p.module == 3 ? 1 : icp;
  if (k >= 1 && size_t(k) <= p.patches.size()) return &p.patches[size_t(k - 1)];
  log_line(name, p.ire, icp, "there is no such patch");
  return nullptr;
}

}  // namespace cntc
