#!/bin/sh
# must_stop.sh program: it must fail, say so on standard error in the library's words, and print nothing.
if text=$("$1" 2>&1 >/dev/null); then
  echo "the program did not fail"
  exit 1
fi
case "$text" in
  *rollcon:*rollcon_body_set_elastic*) echo "stopped: $text" ;;
  *) echo "unexpected words: $text"; exit 1 ;;
esac
