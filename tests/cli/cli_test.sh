#!/usr/bin/env bash
# Drives the real program: every command, every exit code, malformed files of every format.
# Usage: cli_test.sh PROGRAM WORK_FOLDER
set -u
program=$1
folder=$2
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" || exit 1
passed=0
failed=0

# expect CODE PATTERN ARGUMENTS...: exit code, and a pattern that the messages match.
expect() {
  local wanted=$1 pattern=$2
  shift 2
  local output code
  output=$("$program" "$@" 2>&1 </dev/null)
  code=$?
  if [ $code -eq "$wanted" ] && grep -qE -- "$pattern" <<<"$output"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $* gave $code (wanted $wanted), saying: $output (wanted: $pattern)"
  fi
}
absent() {
  if [ -e "$1" ]; then failed=$((failed + 1)); echo "FAILED: $1 was written"; else passed=$((passed + 1)); fi
}

cube() {  # NAME SHIFT: a cube of side 2
  local s=$2 x y z
  {
    for z in 0 2; do for y in 0 2; do for x in 0 2; do echo "v $((x + s)) $((y + s)) $((z + s))"; done; done; done
    printf 'f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n'
  } >"$1"
}
cube a.obj 0
cube b.obj 1

expect 0 'volume 15' union a.obj b.obj -o u.obj
expect 0 'volume 1,' intersect a.obj b.obj -o i.off
expect 0 'volume 7,' subtract a.obj b.obj -o s.ply
expect 0 '"volume":7.0' subtract a.obj b.obj -o s.stl --json
expect 0 'volume 8' union a.obj a.obj a.obj -o same.obj
expect 0 'legal' check u.obj
expect 0 'legal' check s.stl
expect 0 'genus 0' info i.off
expect 0 '"shells":1' info i.off --json
expect 0 'above.obj.*volume 4' split a.obj --plane 0,0,1,-1 -o above.obj below.obj
expect 0 'volume 4' info below.obj
expect 0 '8 vertices, 6 faces' convert a.obj -o a.ply
expect 0 'volume 8' info a.ply
expect 0 'trace' trace a.obj b.obj --op subtract -o t.json
expect 0 'sectile [0-9]' --version
expect 0 'Examples' --help
expect 0 'plane' split --help
for phase in reduction vertex_face vertex_vertex null_edges joining components gluing cleanup; do
  grep -q "\"phase\": \"$phase\"" t.json || { failed=$((failed + 1)); echo "FAILED: no $phase in the trace"; }
done
"$program" union - b.obj -o - <a.obj 2>/dev/null >piped.obj
expect 0 'volume 15' info piped.obj

expect 2 'required|command' union
expect 2 '' nonsense
expect 3 'extension' union a.obj b.obj -o out.xyz
expect 2 'zero' split a.obj --plane 0,0,0,1 -o p.obj q.obj
absent p.obj
expect 3 'No such file' union a.obj missing.obj -o x.obj
expect 3 'cannot write' union a.obj b.obj -o no/such/folder/x.obj
expect 3 'cannot write' split a.obj --plane 0,0,1,-1 -o half.obj no/such/folder/x.obj
absent half.obj

bad() {  # CODE PATTERN FILE: no output is left
  expect "$1" "$2" union "$3" b.obj -o x.obj
  absent x.obj
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >range.obj
bad 3 'range.obj:4: .*vertex 9' range.obj
printf 'v 0 0 nan\n' >nan.obj
bad 3 'nan.obj:1: .*finite' nan.obj
printf 'v 0 0 1e400\n' >huge.obj
bad 3 'huge.obj:1: .*range' huge.obj
printf 'v 0 0\nv 1' >short.obj
bad 3 'short.obj:1: .*missing' short.obj
sed '$d' a.obj >open.obj
bad 1 'open.obj: not a legal solid: .*open' open.obj
sed 's/f 2 4 8 6/f 6 8 4 2/' a.obj >flipped.obj
bad 1 'flipped.obj: not a legal solid: .*same way' flipped.obj
sed 's/^f \([0-9]*\) \([0-9]*\) \([0-9]*\) \([0-9]*\)/f \4 \3 \2 \1/' a.obj >inside_out.obj
bad 1 'inside out' inside_out.obj
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' >truncated.off
bad 3 'truncated.off:[0-9]+: .*ends' truncated.off
printf 'OFF\n4000000000 1 0\n0 0 0\n' >claims.off
bad 3 'claims.off:2: .*size' claims.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >range.off
bad 3 'range.off:6: .*vertex 7' range.off
: >empty.stl
bad 3 'empty' empty.stl
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n' >junk.stl
bad 3 'junk.stl:4: .*not a number' junk.stl
head -c 200 s.stl >cut.stl
bad 3 'cut.stl: byte 200' cut.stl
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n' >noz.ply
bad 3 'noz.ply:[0-9]+: .*"z"' noz.ply
head -c 150 a.ply >cut.ply
bad 3 'cut.ply:[0-9]+: ' cut.ply
printf 'l 1 2\n' >line.obj
bad 3 'line.obj:1: .*solids' line.obj
# Two cubes that cross in one file: the surface crosses itself.
{ cat a.obj; sed -n 's/^v/v/p' b.obj; awk '/^f/{print "f", $2+8, $3+8, $4+8, $5+8}' b.obj; } >crossing.obj
expect 1 'cross' check crossing.obj

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
