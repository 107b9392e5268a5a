#!/usr/bin/env bash
# Another compiler than the one that everything is built with: clang takes, without a warning, the files in which compilers
# differ (complex numbers, vector instructions, attributes, unions, variable arguments) and those of the program. All files:
# make config=clang.
set -u
. "$(dirname "$0")/scratch.sh"
command -v clang >/dev/null || { echo "ok 1 - clang # SKIP not installed" && echo "1..1" && exit; }

flags="-std=c11 -D_GNU_SOURCE -fPIC -ffp-contract=off -Wall -Wextra -Werror -Wshadow -Igen -Igen/include -I. -isystem /usr/include/suitesparse"
status=0
: >out; : >err
takes() { (cd "$project" && clang $flags -fsyntax-only "$@") >out 2>err; }
# C11's CMPLX, for one, is not in the headers as clang sees them.
differ=$(cd "$project" && grep -lE 'complex|__builtin|_Thread_local|va_list' -r gen formats --include='*.c' | grep -v '^gen/bench/\|front_' | sort)
ok "there are files in which compilers differ" [ "$(wc -w <<<"$differ")" -gt 8 ]
ok "clang takes them without a warning" takes $differ
ok "and those of the program" takes $(cd "$project" && echo gen/cli/*.c)
ok "and the plain kernel" takes gen/solve/factor/front_kernels.c gen/solve/factor/front_plain.c
case $(clang -dumpmachine) in
x86_64*)
  ok "and that of AVX" takes -mavx -mfma gen/solve/factor/front_avx2.c
  ok "and that of AVX-512" takes -mavx512f -mfma gen/solve/factor/front_avx512.c
  ;;
esac
echo "1..$number"
