// rollcon-cntc: runs input files of CONTACT.
#include <cstdio>
#include <cstring>
#include <exception>

#include "files.hpp"
#include "log.hpp"
#include "registry.hpp"
#include "text.hpp"

int main(int count, char** arguments) {
  bool check_only = false;
  const char* file = nullptr;
  for (int k = 1; k < count; ++k) {
    if (!std::strcmp(arguments[k], "--check") || !std::strcmp(arguments[k], "3")) {
      check_only = true;
    } else if (std::strcmp(arguments[k], "2")) {
      file = arguments[k];
    }
  }
  if (!file) {
    std::fprintf(stderr,
                 "rollcon-cntc [--check] FILE.inp: solves the cases of an input file of CONTACT, modules 1 and 3, and "
                 "writes FILE.out beside it; --check only reads the file\n");
    return 2;
  }
  try {
    std::string path = file;
    if (!cntc::ends_with(path, ".inp")) path += ".inp";
    const std::string folder = cntc::folder_of(path), name = path.substr(folder.empty() ? 0 : folder.size() + 1);
    cntc::begin_session(false, folder, folder, name.substr(0, name.size() - 4), true);
    const int failed = cntc::run_inp(path, check_only);
    cntc::end_session();
    if (failed > 0) std::fprintf(stderr, "%d cases failed: the out-file says why\n", failed);
    return failed ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rollcon-cntc: %s\n", error.what());
    return 1;
  }
}
