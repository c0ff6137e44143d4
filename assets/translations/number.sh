#!/usr/bin/env bash
# Gives every text of the sources that has none an ID, the next number, in messages.ids: number.sh [--check]
#   --check  only says what has none, and fails
# A line is an ID and a text as gettext writes it; the forms of a plural share an ID. IDs stay: a text that is worded anew
# keeps its line, and a line whose text has gone is not used again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
./extract.sh | LC_ALL=C.UTF-8 awk -v check="${1:-}" '
    function fail(words) { print "assets/translations/messages.ids:" FNR ": " words; failed = 1 }
    function add() {
        if (key != "" && !(key in known)) {
            if (check) { print "has no ID: \"" key "\""; failed = 1 }
            else printf "%d \"%s\"\n", form ? last : ++last, key >> "messages.ids"
            known[key]
        }
        key = ""
    }
    FILENAME == "messages.ids" {
        key = substr($0, index($0, " ") + 2, length($0) - index($0, " ") - 2)
        if ($1 != last && $1 != last + 1) fail("expected the ID " last + 1 ", found " $1)
        if (key in known) fail("expected each text once, found \"" key "\" again")
        known[key]; last = $1; key = ""
        next
    }
    /^msgid/ { add(); form = /^msgid_plural/; part = 1 }
    /^msgstr/ { part = 0 }
    part && match($0, /".*"$/) { key = key substr($0, RSTART + 1, RLENGTH - 2) }
    END { add(); if (failed) { print "expected the IDs of all texts, see docs/develop/translate.md"; exit 1 } }
' messages.ids -
