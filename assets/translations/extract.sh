#!/usr/bin/env bash
# Writes gettext's template of the texts that users read to standard output, from the sources.
#   extract.sh           all texts, also those of texshot, which are English
#   extract.sh --window  only what the window shows, which is translated
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Calls that take a text, with the number of the argument; another text is marked with N_ (core/base/translatable.h).
# xgettext looks at one argument of a call, so that a second one needs a second run.
calls=(N_ Sentence plural:1,2 joined fail:2 malformed refuse say:3 note section submit:2 tell:2
    tr label unit caption dimText helpTip wrappedText word wordHtml item:2 button squareButton:3 number:4 perCorner
    menuItem menuOf shortcutItem:3 beginModal row:3)
more_calls=(row:4 button:3)

english=()
if [ "${1:-}" = --window ]; then
    english=(-path core/conform -o -path core/glsl -o -path core/golden -o -path core/report -o -path core/suite -o
        -path 'core/compare/*' -not -name 'difference*' -o -path 'core/lesson/*check*' -o
        -path app/command_line -o -path app/offscreen -o
        -path 'app/screenshot/*' -not -name 'lesson_*' -not -name 'step_programs*' -not -name reports)
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
find core app ${english[@]:+\( "${english[@]}" \) -prune -o} \( -name '*.cpp' -o -name '*.h' -o -name '*.inl' \) -print |
    LC_ALL=C sort >"$folder/sources"
for name in calls more_calls; do
    declare -n list=$name
    xgettext --language=C++ --from-code=UTF-8 --add-location=file --add-comments=Translators: --no-wrap \
        --package-name=Texplorer -k "${list[@]/#/-k}" -f "$folder/sources" -o "$folder/$name.pot"
done
# Of "Close##id" the ID of Dear ImGui is not shown; the placeholders of a Sentence are Python's, not printf's.
msgcat --use-first --no-wrap "$folder"/{calls,more_calls}.pot |
    sed -E -e 's/^(msgid ".*[^#"])##+.*"$/\1"/' -e '/^"POT-Creation-Date/d' |
    awk -v RS= -v ORS='\n\n' '{
        sub(/\n#, c-format/, ""); sub(/, c-format/, "")
        if (/\nmsgid[^\n]*\{[0-9]/ || /\n"[^\n]*\{[0-9]/) sub(/\nmsgid/, "\n#, python-brace-format\nmsgid")
        print
    }' | msguniq --use-first --no-wrap
