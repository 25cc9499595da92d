#include "contract.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace fuzz {
namespace {

using StatusesOf = std::map<std::string, std::set<std::int32_t>>;

/// Reads "Also returns:" of the comment before each declaration of a header, and what the opening of rollcon.h says of
/// all functions.
void read_header(const char* path, StatusesOf& all) {
  std::ifstream file(path);
  std::map<std::string, std::int32_t> number;  // number of every enumerator
  std::set<std::int32_t> listed;
  bool in_list = false, any_thread = false;
  for (std::string line; std::getline(file, line);) {
    std::string name_of_line, equals;
    std::int32_t number_of_line = 0;
    if (std::istringstream(line) >> name_of_line >> equals >> number_of_line && equals == "=")
      number[name_of_line] = number_of_line;
    if (line.find("Also returns:") != std::string::npos) in_list = true;
    any_thread = any_thread || line.find("* Threads: any") != std::string::npos;
    if (in_list) {
      std::istringstream words(line);
      for (std::string word; words >> word;) {
        while (!word.empty() && (word.back() == ',' || word.back() == '.')) word.pop_back();
        const auto found = number.find(word);
        if (word.rfind("ROLLCON_", 0) != 0) continue;
        require(found != number.end(), "the header lists the unknown status '" + word + "'");
        listed.insert(found->second);
      }
      if (line.find('.') != std::string::npos) in_list = false;
    }
    const std::size_t name = line.find("rollcon_status ROLLCON_CALL rollcon_");
    if (name == std::string::npos) {
      if (line.find("ROLLCON_API") == 0) any_thread = false;
      continue;
    }
    const std::size_t begin = line.find("rollcon_", name + 14);
    listed.insert({ROLLCON_OK, ROLLCON_ERR_ARGUMENT});
    std::string first = line.substr(line.find('(') + 1);
    if (first.empty()) std::getline(file, first);
    first = first.substr(0, first.find(','));
    if (first.find("rollcon_") != std::string::npos) listed.insert(ROLLCON_ERR_HANDLE);
    if (!any_thread) listed.insert(ROLLCON_ERR_BUSY);
    any_thread = false;
    all[line.substr(begin, line.find('(') - begin)] = listed;
    listed.clear();
  }
}

StatusesOf read_headers() {
  StatusesOf all;
  read_header(ROLLCON_INCLUDE "rollcon.h", all);
  require(all.size() > 60, "the header in '" ROLLCON_INCLUDE "' lists too few functions");
  read_header(ROLLCON_INCLUDE "rollcon_layers.h", all);
  return all;
}

}  // namespace

void require(bool good, const std::string& what) {
  if (good) return;
  std::fprintf(stderr, "broken promise: %s\n", what.c_str());
  std::abort();
}

std::int32_t checked(const char* function, const rollcon_context* context, std::int32_t status) {
  static const StatusesOf documented = read_headers();
  const auto found = documented.find(function);
  require(found != documented.end(), std::string(function) + " is not in the header");
  const std::string text = rollcon_last_error();
  // A context that has latched a failure answers with it whatever is called.
  if (context && status < 0 && rollcon_context_check(context) == status) return status;
  if (status < 0) {
    require(text.rfind(std::string(function) + ": ", 0) == 0,
            std::string(function) + ": status " + std::to_string(status) + ", text '" + text + "'");
  }
  require(found->second.count(status) == 1, std::string(function) + ": status " + std::to_string(status) + " (" +
                                                rollcon_status_string(status) + ") is not listed; text '" + text + "'");
  return status;
}

const std::vector<std::string>& known_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    char name[64];
    for (const std::int32_t kind : {ROLLCON_OF_BODY, ROLLCON_OF_CONTACT, ROLLCON_OF_WHEELRAIL, ROLLCON_OF_PATCH}) {
      for (int i = 0; i < rollcon_option_count(kind); ++i)
        if (rollcon_option_info(kind, i, sizeof name, name, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr) == 0)
          all.emplace_back(name);
      for (int i = 0; i < rollcon_stat_count(kind); ++i)
        if (rollcon_stat_info(kind, i, sizeof name, name, nullptr, nullptr, nullptr) == 0) all.emplace_back(name);
    }
    return all;
  }();
  return names;
}

bool all_finite(const std::vector<double>& values) {
  for (const double value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

}  // namespace fuzz
