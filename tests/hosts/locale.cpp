/// Tests a host whose locale writes 1,5 for 1.5 and groups digits: files and texts of the library do not change, and
/// options set by text are read literally.

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <locale>

#include "flows.hpp"

namespace {

using namespace hosts;

struct Comma final : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Sets a German locale, which lies in a folder of the test's own then; returns false if the machine cannot make one.
bool set_german() {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8")) return true;
  const std::string make = "localedef -f UTF-8 -i de_DE '" + folder() + "/de_DE.UTF-8' 2>/dev/null";
  if (std::system(make.c_str()) != 0) return false;
  setenv("LOCPATH", folder().c_str(), 1);
  return std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
}

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns all texts that the library makes: a file, a plan, failures, descriptions of options.
std::string texts() {
  std::string all;
  std::vector<char> text(20000);
  Caller call;
  call.made_contact = [&](rollcon_contact* c) {
    const auto add_error = [&](std::int32_t status) {
      all += std::to_string(status) + " " + rollcon_last_error() + "\n";
    };
    rollcon_contact_solve(c);
    rollcon_contact_get_plan(c, 20000, text.data(), nullptr);
    // The last lines of the plan tell times.
    all += std::string(text.data()).substr(0, 200);
    if (rollcon_has_feature("vtu")) {
      const std::string file = folder() + "/locale.vtu";
      rollcon_contact_write(c, file.c_str());
      all += content(file);
    }
    const double friction = -0.125;
    add_error(rollcon_contact_set_real(c, "tolerance", 1234.5));
    add_error(rollcon_contact_set_friction(c, "coulomb", 1, &friction));
    add_error(rollcon_contact_set_rolling(c, -1.5));
    add_error(rollcon_contact_set_int(c, "max_iterations", 12345678));
    add_error(rollcon_contact_set_str(c, "operators", "1,5"));
    add_error(rollcon_contact_set_str(c, "operators", "dense"));
  };
  call.threads = 1;
  flow("dense").run(call);
  for (std::int32_t i = 0; i < rollcon_option_count(ROLLCON_OF_CONTACT); ++i) {
    std::int64_t needed = 0;
    rollcon_option_info(ROLLCON_OF_CONTACT, i, 20000, nullptr, text.data(), &needed, nullptr, nullptr, nullptr,
                        nullptr);
    all += text.data();
  }
  return all;
}

}  // namespace

int main() {
  Verdict verdict;
  std::vector<std::vector<double>> right;
  for (const Flow& f : flows()) {
    Caller call;
    right.push_back(f.run(call));
  }
  const std::string plain = texts();
  verdict.expect(plain.find("1234.5") != std::string::npos, "the texts hold numbers");
  for (const bool german : {true, false}) {
    const char* name = german ? "de_DE.UTF-8" : "std::locale with a comma";
    std::setlocale(LC_ALL, "C");
    if (german && !set_german()) {
      std::printf("no German locale to be had\n");
      continue;
    }
    if (german) {
      char number[20];
      std::snprintf(number, sizeof number, "%.1f", 1.5);
      verdict.expect(std::string(number) == "1,5", "the locale does not work: %s", number);
      std::locale::global(std::locale("de_DE.UTF-8"));
    } else {
      std::locale::global(std::locale(std::locale::classic(), new Comma));
    }
    const std::string here = texts();
    std::size_t same = 0;
    while (same < plain.size() && same < here.size() && plain[same] == here[same]) ++same;
    verdict.expect(here == plain, "%s: texts differ:\n%s\n%s", name, plain.substr(same, 80).c_str(),
                   here.substr(same, 80).c_str());
    std::size_t i = 0;
    for (const Flow& f : flows()) {
      Caller call;
      verdict.expect(same_bits(f.run(call), right[i++]), "%s: %s has other results", name, f.name);
    }
    std::printf("%s: %zu characters of texts are the same\n", name, here.size());
  }
  return verdict.exit_code();
}
