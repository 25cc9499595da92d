#pragma once
#include <string>

namespace cntc {

/// Writes to <outdir><expnam>.out, and to the screen if wanted, one line at a time from any thread.
void log_open(const std::string& path, bool screen);
void log_close();
void log_write(const std::string& text);

/// Writes a line "  ** name ( ire.icp): text" to the log.
void log_line(const char* name, int ire, int icp, const char* format, ...) __attribute__((format(printf, 4, 5)));

/// Returns text that is formatted as by printf.
std::string print(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace cntc
