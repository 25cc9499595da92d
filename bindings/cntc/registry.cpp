#include "registry.hpp"

#include <rollcon.h>

#include <array>
#include <ctime>
#include <mutex>

#include "contact_solver.hpp"
#include "log.hpp"
#include "text.hpp"
#include "wheel_solver.hpp"

namespace cntc {

Problem::Problem(int ire_, int icp_, int module_) : ire(ire_), icp(icp_), module(module_) {
  if (module == 3) {
    patches.resize(1);
    in.digits.ifvari = 4;
  }
}
Problem::~Problem() = default;

namespace {

struct Element {
  int module = 0;
  std::map<int, std::shared_ptr<Problem>> problems;
};

struct Registry {
  std::mutex lock;
  Session session;
  std::array<std::unique_ptr<Element>, most_ire + 1> elements;
  int alive = 0;
};

Registry& registry() {
  static Registry instance;
  return instance;
}

std::string box_line(const std::string& text) {
  return print("   |  %-66s  |\n", text.c_str());
}

std::string title() {
  const std::string edge = "   " + std::string(72, '-') + "\n";
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
#ifdef _WIN32
  localtime_s(&parts, &now);
#else
  localtime_r(&now, &parts);
#endif
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d", &parts);
  // Parsers of out-files look for "detailed investigation of 3D" on the second line.
  return edge + box_line("rollcon - detailed investigation of 3D frictional rolling contact") + box_line("") +
         box_line(print("version %s, interface of CONTACT, version %d", rollcon_version_string(), interface_version)) +
         box_line(std::string("run on ") + date) + box_line("(c) the rollcon authors, BSD-3-Clause") + box_line("") +
         edge + "\n";
}

}  // namespace

Session session() {
  const std::lock_guard guard(registry().lock);
  return registry().session;
}

void begin_session(bool screen, const std::string& wrkdir, const std::string& outdir, const std::string& expnam,
                   bool program) {
  const std::lock_guard guard(registry().lock);
  Session& s = registry().session;
  if (s.begun) return;
  s.begun = true;
  s.program = program;
  s.wrkdir = wrkdir;
  s.outdir = outdir;
  s.expnam = expnam.empty() ? "contact_addon" : expnam;
  const std::string folder = folder_of(s.expnam);
  if (!folder.empty()) {
    if (s.wrkdir.empty()) s.wrkdir = folder;
    s.expnam = s.expnam.substr(folder.size() + 1);
  }
  log_open(in_folder(s.outdir.empty() ? s.wrkdir : s.outdir, s.expnam + ".out"), screen);
  log_write(title());
}

void end_session() {
  const std::lock_guard guard(registry().lock);
  for (auto& element : registry().elements) element.reset();
  registry().alive = 0;
  log_close();
  const Session old = registry().session;
  registry().session = Session{};
  registry().session.idebug = old.idebug;
  registry().session.openmp = old.openmp;
}

void set_global(int Session::*flag, int value) {
  const std::lock_guard guard(registry().lock);
  registry().session.*flag = value;
}

int module_of(int ire) {
  const std::lock_guard guard(registry().lock);
  const auto& element = registry().elements[size_t(ire)];
  return element ? element->module : 0;
}

bool make_element(int ire, int module) {
  const std::lock_guard guard(registry().lock);
  auto& element = registry().elements[size_t(ire)];
  if (element) return true;
  if (registry().alive >= most_alive) return false;
  element = std::make_unique<Element>();
  element->module = module;
  ++registry().alive;
  return true;
}

bool free_element(int ire) {
  bool last = false;
  {
    const std::lock_guard guard(registry().lock);
    auto& element = registry().elements[size_t(ire)];
    if (!element) return false;
    element.reset();
    last = --registry().alive == 0;
  }
  if (last) end_session();
  return true;
}

std::shared_ptr<Problem> problem_of(int ire, int icp) {
  const std::lock_guard guard(registry().lock);
  const auto& element = registry().elements[size_t(ire)];
  if (!element) return nullptr;
  const int key = element->module == 1 ? -1 : icp;
  auto& problem = element->problems[key];
  if (!problem) {
    problem = std::make_shared<Problem>(ire, key, element->module);
    problem->in.digits.idebug = registry().session.idebug;
    problem->in.digits.openmp = registry().session.openmp;
  }
  return problem;
}

}  // namespace cntc
