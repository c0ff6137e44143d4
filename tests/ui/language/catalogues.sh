#!/usr/bin/env bash
# Each text of the sources has an ID. The catalogues have exactly these texts, translated, with the same placeholders, and
# no term that another one replaces: catalogues.sh SOURCE
set -euo pipefail
cd "$1"
export LC_ALL=C.UTF-8
texts=$(mktemp)
trap 'rm -f "$texts"' EXIT
assets/translations/extract.sh --window >"$texts"
status=0
assets/translations/number.sh --check || status=1
if grep -rnE --include='*.cpp' --include='*.h' 'return \{ ?"[^"]*\{[0-9][:}]' core app; then
    echo 'expected return Sentence("…"), which xgettext finds, found a text in braces'
    status=1
fi
for po in assets/translations/*.po; do
    msgfmt --check-format -o /dev/null "$po" || status=1
    msgcmp --no-fuzzy-matching "$po" "$texts" || status=1                     # each text is translated
    msgcmp --no-fuzzy-matching --use-untranslated "$texts" "$po" || status=1 # and no other
    while IFS=$'\t' read -r term instead; do
        if grep -nP "^(msgstr.*|\".*)$term" "$po"; then
            echo "$po: expected \"$instead\", found \"$term\""
            status=1
        fi
    done <"${po%.po}.terms"
done
for po in assets/lessons/*/*.po; do msgfmt --check-format -o /dev/null "$po" || status=1; done
[ $status = 0 ] || echo "./dev translate updates the catalogues; translate what is empty there"
exit $status
