#!/usr/bin/env bash
# run.sh            runs each fuzzer for a fixed number of inputs, the same ones each time, as CI does
# run.sh NAME ARG…  runs one until it finds something or is stopped; ARG… goes to libFuzzer (-max_total_time=600).
#                   With a file among them it only tries that: so one repeats what a fuzzer left in crashes/
#
# The programs are those of ./dev sanitize. Below build/fuzz: the first inputs in seeds/, what long runs add to them in
# found/, what ended a fuzzer in crashes/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=build/fuzz
bin=build/asan/bin

# addr2line is there wherever a compiler is; llvm-symbolizer need not be.
export ASAN_SYMBOLIZER_PATH=/usr/bin/addr2line UBSAN_OPTIONS=print_stacktrace=1

names() { find "$build/seeds" -mindepth 1 -maxdepth 1 -type d -printf '%f\n' | sort; }

# The command for one fuzzer, in `fuzzer`.
choose() {
    if [ ! -d "$build/seeds/$1" ]; then
        printf 'fuzz: there is no fuzzer "%s", there are: %s\n' "$1" "$(names | paste -sd ' ')" >&2
        exit 2
    fi
    local words=-dict=$build/seeds/words.dict
    case $1 in
        flip | obj | upload) fuzzer=("$bin/fuzz_$1") ;;
        param | scene | suite) fuzzer=("$bin/fuzz_$1" "$words") ;;
        codecs) fuzzer=("$bin/fuzz_codec") ;; # every input goes to every decoder
        *) fuzzer=("$bin/fuzz_codec" "--codec=$1") ;;
    esac
    mkdir -p $build/crashes
    # Files of 4 KiB reach every line; none of them may take that long, or that much memory in one piece.
    fuzzer+=(-max_len=4096 -timeout=30 -malloc_limit_mb=128 -rss_limit_mb=2048 "-artifact_prefix=$build/crashes/$1-")
}

short() {
    local name=$1 runs=20000 new=$build/short/$1
    if [ "$name" = param ]; then runs=2000; fi # each input is a list of edits
    choose "$name"
    rm -rf "$new"
    mkdir -p "$new"
    # The number of inputs ends it; the time is for machines that are very slow.
    if ! "${fuzzer[@]}" -seed=1 -runs=$runs -max_total_time=60 "$new" "$build/seeds/$name" >"$new.log" 2>&1; then
        printf 'fuzz: %s failed\n' "$name"
        grep -v '^#' "$new.log" | tail -n 80
        return 1
    fi
    printf 'fuzz: %s: %s\n' "$name" "$(grep '^Done ' "$new.log")"
}

if [ "${1:-}" = --short ]; then
    short "$2"
    exit
fi
rm -rf $build/seeds
$bin/make_corpus $build/seeds
if [ $# -eq 0 ]; then
    names | xargs -P "$(nproc)" -I NAME "$0" --short NAME
    exit
fi
choose "$1"
for argument in "${@:2}"; do
    if [ -f "$argument" ]; then exec "${fuzzer[@]}" "${@:2}"; fi
done
mkdir -p "$build/found/$1"
exec "${fuzzer[@]}" "${@:2}" "$build/found/$1" "$build/seeds/$1"
