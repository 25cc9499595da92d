#pragma once
/// Stands in for what rollcon uses of POSIX and MinGW-w64 lacks; it is included before each source for Windows. Not
/// there: a locale of a thread (programs keep the C locale for numbers), folders brought to the disk, other permissions
/// of files than the owner's, limits of the process.

#define __USE_MINGW_ANSI_STDIO 1  // printf as C has it
#include <fcntl.h>
#include <io.h>
#include <locale.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

// Files are binary, and not handed to other programs.
#define O_CLOEXEC (O_BINARY | O_NOINHERIT)
#define O_NONBLOCK 0
inline int fsync(int file) {
  return _commit(file);
}
inline int fchmod(int, int) {
  return 0;
}

#ifndef SIGBUS
#define SIGTRAP 5
#define SIGBUS 10
#define SIGSYS 12
#endif
using sigset_t = _sigset_t;
inline int sigfillset(sigset_t* all) {
  *all = 0;
  return 0;
}
inline int sigdelset(sigset_t*, int) {
  return 0;
}

using locale_t = void*;
#define LC_ALL_MASK 0
inline locale_t newlocale(int, const char*, locale_t) {
  return nullptr;
}
inline locale_t uselocale(locale_t) {
  return nullptr;
}

#define _SC_PAGESIZE 0
inline long sysconf(int) {
  return 4096;
}
struct rlimit {
  unsigned long long rlim_cur;
};
enum { RLIMIT_AS, RLIMIT_DATA };
constexpr unsigned long long RLIM_INFINITY = ~0ULL;
inline int getrlimit(int, rlimit* limit) {
  limit->rlim_cur = RLIM_INFINITY;
  return 0;
}

struct Dl_info {
  const char* dli_fname;
};
extern "C" __declspec(dllimport) int __stdcall GetModuleHandleExA(unsigned long, const char*, void**);
extern "C" __declspec(dllimport) unsigned long __stdcall GetModuleFileNameA(void*, char*, unsigned long);
inline int dladdr(const void* place, Dl_info* info) {
  constexpr unsigned long by_address = 4, keep_count = 2, room = 4096;
  static char name[room];
  void* module = nullptr;
  if (!GetModuleHandleExA(by_address | keep_count, static_cast<const char*>(place), &module)) return 0;
  const unsigned long length = GetModuleFileNameA(module, name, room);
  info->dli_fname = name;
  return length > 0 && length < room;
}
