#!/usr/bin/env bash
# Every shipped design builds, all of it but the files: nets converge, parts are sound, no two of them overlap (exit status 0).
set -u
. "$(dirname "$0")/scratch.sh"
root=$OLDPWD
export lamella root
build() {
  "$lamella" build "$root/templates/designs/$1" -o "$1.out" --only report --quiet >"$1.log" 2>&1
  echo $? >"$1.status"
}
export -f build
(cd "$root/templates/designs" && ls ./*.yaml) | sed 's|^\./||' | xargs -P "$(nproc)" -I{} bash -c 'build {}'
for file in *.status; do
  design=${file%.yaml.status} status=$(cat "$file")
  cp "${file%.status}.log" out
  grep -E '"reason"' "${file%.status}.out/report.json" 2>/dev/null | sort | uniq -c >err
  ok "$design builds" test "$status" = 0
done
echo "1..$number"
