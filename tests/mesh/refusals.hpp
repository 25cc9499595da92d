#pragma once
/// Expects of checks of meshes that a mesh is refused with these words, or accepted.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "support/error.hpp"

namespace rollcon {

/// Expects check() to throw an Error of this status whose text contains the words.
template <class Check>
void expect_error_text(Check&& check, const std::string& words, Status status = Status::err_mesh) {
  try {
    check();
    ADD_FAILURE() << "accepted; expected: " << words;
  } catch (const Error& error) {
    std::printf("%s\n", error.what());
    EXPECT_EQ(error.status(), status);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos)
        << "said: " << error.what() << "\nexpected: " << words;
  }
}

template <class Check>
void expect_no_error(Check&& check, const std::string& what) {
  try {
    check();
  } catch (const Error& error) {
    ADD_FAILURE() << what << ": " << error.what();
  }
}

}  // namespace rollcon
