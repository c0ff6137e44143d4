#!/usr/bin/env bash
# Only eight_lanes.cpp's own functions may be compiled for AVX2: what it takes from elsewhere is shared with all
# of the program, which also runs on processors without it. Usage: vector_code_test.sh eight_lanes.cpp.o
set -euo pipefail
[ "$(uname -m)" = x86_64 ] || exit 0
# Of all instructions that a compiler writes, those of AVX alone begin with a v.
avx=$(objdump --disassemble --demangle --no-show-raw-insn "$1" |
    awk '/^[0-9a-f]+ <.*>:$/ { name = $0 } $2 ~ /^v/ { print name }' | sort -u)
if ! grep -q '::eight::' <<<"$avx"; then
    echo "no function of $1 is compiled for AVX2"
    exit 1
fi
if others=$(grep -v '::eight::' <<<"$avx"); then
    echo "compiled for AVX2, and shared with the whole program:"
    echo "$others"
    exit 1
fi
