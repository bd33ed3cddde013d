#!/usr/bin/env bash
# Fails with file:line where a text file of the project says that work was left for later.
#   check_words.sh ROOT
cd "$1" || exit 2
! grep -rnwIE 'TO''DO|FIX''ME|X''XX' . --exclude-dir=.git --exclude-dir='build*' --exclude-dir=out --exclude-dir=.cache
