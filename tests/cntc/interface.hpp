#pragma once
#include <gtest/gtest.h>
#include <rollcon_cntc.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace cntc_test {

/// Returns the path of a folder that this process alone writes to, because several run at a time; it is removed in the
/// end.
inline const std::string& folder() {
  struct Folder {
    std::string path = (std::filesystem::path(CNTC_TEST_FOLDER) / std::to_string(getpid())).string();
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder own;
  return own.path;
}

/// Numbers of a patch or contact.
struct Found {
  double fn = 0, tx = 0, ty = 0, mz = 0, pen = 0, pmax = 0, ksi = 0, eta = 0, phi = 0;
  double area = 0, stick = 0, slip = 0;
  int mx = 0, my = 0;
};

/// A result element of the interface, spoken to as its callers do; it is finalized at the end, unless it stays.
class Element {
 public:
  Element(int ire, int module, int icp, bool stays = false) : ire_(ire), icp_(icp), stays_(stays) {
    int version = 0, error = 0;
    const int zero = 0;
    cntc_initializefirst(&version, &error, &zero, "", folder().c_str(), "cntc_test", &zero, &length_, &nine_);
    cntc_initialize(&ire_, &module, &version, &error, "", &zero);
  }
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;
  ~Element() {
    if (!stays_) cntc_finalize(&ire_);
  }

  using Setter = void (*)(const int*, const int*, const int*, const int*, const double*);
  using WheelSetter = void (*)(const int*, const int*, const int*, const double*);

  void flags(std::initializer_list<std::pair<int, int>> list) {
    std::vector<int> codes, values;
    for (const auto& [code, value] : list) {
      codes.push_back(code);
      values.push_back(value);
    }
    const int n = int(codes.size());
    cntc_setflags(&ire_, &icp_, &n, codes.data(), values.data());
  }
  int flag(int code) {
    int value = -777;
    const int one = 1;
    cntc_getflags(&ire_, &icp_, &one, &code, &value);
    return value;
  }
  void set(Setter function, int method, std::vector<double> values) {
    const int n = int(values.size());
    values.push_back(0);
    function(&ire_, &icp_, &method, &n, values.data());
  }
  void set(WheelSetter function, int method, std::vector<double> values) {
    const int n = int(values.size());
    values.push_back(0);
    function(&ire_, &method, &n, values.data());
  }
  void normal_force(double fn) { cntc_setnormalforce(&ire_, &icp_, &fn); }
  void penetration(double pen) { cntc_setpenetration(&ire_, &icp_, &pen); }
  void vertical_force(double fz) { cntc_setverticalforce(&ire_, &fz); }
  void velocity(double v) { cntc_setreferencevelocity(&ire_, &icp_, &v); }
  void creepages(double x, double y, double phi) { cntc_setcreepages(&ire_, &icp_, &x, &y, &phi); }
  void rolling(double chi, double dq) { cntc_setrollingstepsize(&ire_, &icp_, &chi, &dq); }
  void forces(double x, double y) { cntc_settangentialforces(&ire_, &icp_, &x, &y); }
  void profile(bool wheel, const std::vector<double>& yz) {
    const int n = int(yz.size() / 2), ints = 6, reals = 2, options[6] = {wheel, 0, 0, -1, 1, 0};
    const double numbers[2] = {1, 0};
    cntc_setprofileinputvalues(&ire_, &n, yz.data(), &ints, options, &reals, numbers);
  }
  int calculate() {
    int error = -777;
    cntc_calculate(&ire_, &icp_, &error);
    return error;
  }
  int patches() {
    int n = -1;
    cntc_getnumcontactpatches(&ire_, &n);
    return n;
  }
  Found found(int icp) {
    Found f;
    cntc_getcontactforces(&ire_, &icp, &f.fn, &f.tx, &f.ty, &f.mz);
    cntc_getpenetration(&ire_, &icp, &f.pen);
    cntc_getmaximumpressure(&ire_, &icp, &f.pmax);
    cntc_getcreepages(&ire_, &icp, &f.ksi, &f.eta, &f.phi);
    cntc_getcontactpatchareas(&ire_, &icp, &f.area, &f.stick, &f.slip);
    cntc_getnumelements(&ire_, &icp, &f.mx, &f.my);
    return f;
  }
  Found found() { return found(icp_); }
  /// Solves, expects the error code 0 or a count of elements at the border, and returns what was found.
  Found solved() {
    EXPECT_GE(calculate(), 0);
    return found(icp_ > 0 ? icp_ : 1);
  }
  /// Returns pn, px and py of all elements.
  std::array<std::vector<double>, 3> tractions(int icp) {
    const Found f = found(icp);
    const int n = f.mx * f.my;
    std::array<std::vector<double>, 3> p;
    for (auto& v : p) v.resize(size_t(n));
    cntc_gettractions(&ire_, &icp, &n, p[0].data(), p[1].data(), p[2].data());
    return p;
  }
  std::vector<double> field(int which, size_t n) {
    std::vector<double> v(n, -777);
    const int length = int(n);
    cntc_getfielddata(&ire_, &icp_, &which, &length, v.data());
    return v;
  }
  std::array<double, 38> location(int icp) {
    std::array<double, 38> v{};
    const int n = 38;
    cntc_getcontactlocation(&ire_, &icp, &n, v.data());
    return v;
  }
  std::array<double, 24> global_forces(int icp) {
    std::array<double, 24> v{};
    const int n = 24;
    cntc_getglobalforces(&ire_, &icp, &n, v.data());
    return v;
  }
  std::array<double, 6> position() {
    std::array<double, 6> v{};
    const int n = 6;
    cntc_getwheelsetposition(&ire_, &n, v.data());
    return v;
  }
  const int* ire() const { return &ire_; }
  const int* icp() const { return &icp_; }

 private:
  int ire_, icp_;
  bool stays_;
  int length_ = int(folder().size()), nine_ = 9;
};

/// Prints ours beside the reference, and tells whether they agree.
inline bool near(const char* what, double ours, double reference, double bound) {
  const double off = ours > reference ? ours - reference : reference - ours;
  std::printf("  %-28s %14.6g %14.6g  off %9.2e, bound %9.2e\n", what, ours, reference, off, bound);
  return off <= bound;
}

/// A small contact, and a wheel of S1002 on 60E1 on a coarse grid.
void set_small(Element& e, double ksi);
void set_wheel(Element& e);

/// Points of rollcon's closed profiles, as a file would have them.
std::vector<double> profile_points(const char* shape);

}  // namespace cntc_test
