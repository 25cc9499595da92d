#!/bin/sh
# Tests by must_stop.sh PROGRAM that the program fails, says so on standard error in the library's words, and prints
# nothing.
if text=$("$1" 2>&1 >/dev/null); then
  echo "the program did not fail"
  exit 1
fi
case "$text" in
  *rollcon:*rollcon_body_set_elastic*) echo "stopped: $text" ;;
  *) echo "unexpected words: $text"; exit 1 ;;
esac
