#!/usr/bin/env bash
# soak_test.sh SOAK SHADERS: a renderer that is wrong is found, with its scene and a command that shows it again.
set -euo pipefail
soak=$1
folder=$(mktemp -d)
tell() {
    [ $? = 0 ] || cat "$folder/said" "$folder/again.txt" || true
    rm -rf "$folder"
}
trap tell EXIT

cp -r "$2" "$folder/shaders"
# Every texel is turned into its negative, so that hardly a scene is drawn rightly.
sed -i 's/vec4 texelUNIT = \(texture.*\);/vec4 texelUNIT = 1.0 - \1;/' "$folder/shaders/fragment.glsl"
[ "$(grep -c 'vec4 texelUNIT = 1.0 - texture' "$folder/shaders/fragment.glsl")" -ge 4 ]

if "$soak" scenes --count 25 --keep "$folder/kept" --shaders "$folder/shaders" >"$folder/said"; then
    echo "shaders that are wrong were not found:"
    exit 1
fi
grep -q '^25 random scenes: not all well$' "$folder/said"
number=$(sed -n 's/^scene \([0-9]*\): differ: shader-fixed: .*/\1/p' "$folder/said" | head -n 1)
test -s "$folder/kept/scene-$number.json"
# The command that it prints finds it again; with the right shaders there is nothing to find.
command=$(grep -A 1 "^scene $number: differ" "$folder/said" | sed -n '2s/^ *//p')
if $command --keep "$folder/again" >"$folder/again.txt"; then
    echo "not found again by: $command"
    exit 1
fi
grep -q "^scene $number: differ: shader-fixed" "$folder/again.txt"
"$soak" scenes --first "$number" --count 1 --keep "$folder/again" >"$folder/again.txt"
