#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What is told and guarded about the programs and libraries of the Debian packages:  tests/hardening.sh FOLDER COMMANDS
# FOLDER holds their contents, COMMANDS is the compile_commands.json of their build. They are position-independent, their
# tables of addresses are read-only, overflows of the stack and of known sizes end them, and the bill of materials names
# every library that they load.
set -euo pipefail
root=$1
commands=$2
status=0
complain() { echo "hardening: $*" >&2; status=1; }

count=0
declare -A sources
while read -r file; do
  header=$(readelf -h -l -d -W "$file" 2>/dev/null) || continue
  count=$((count + 1))
  name=${file#"$root"/}
  grep -q 'Type: *DYN' <<<"$header" || complain "$name is not position-independent"
  grep -q GNU_RELRO <<<"$header" || complain "$name has no read-only relocations"
  grep -qE 'BIND_NOW|FLAGS_1.*NOW' <<<"$header" || complain "$name binds its functions lazily"
  if grep -q 'GNU_STACK.*RWE' <<<"$header"; then complain "the stack of $name is executable"; fi
  for library in $(sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p' <<<"$header"); do
    package=$(dpkg -S "*/$library" 2>/dev/null | head -1 | cut -d: -f1) || true
    if [ -n "$package" ]; then sources[$(dpkg-query -W -f '${source:Package}' "$package")]=$library; fi
  done
done < <(find "$root" -type f -size +4k)
[ "$count" -ge 20 ] || complain "there are only $count programs and libraries in $root"

# Every source is compiled with the options: a library without arrays or large frames shows no trace of them.
unguarded=$(python3 -c 'import json, platform, sys
wanted = {"-D_FORTIFY_SOURCE=2", "-fstack-protector-strong", "-fstack-clash-protection"}
if platform.machine() == "x86_64": wanted.add("-fcf-protection")
compiled = json.load(open(sys.argv[1]))
# A joint source of several (EPURA_UNITY) includes each in a line of its own.
sources = sum(open(one["file"]).read().count("#include") if "/Unity/" in one["file"] else 1 for one in compiled)
assert sources > 300, sources
for one in compiled:
    words = set(one["command"].split())
    lacks = wanted - words | (set() if words & {"-O2", "-O3"} else {"-O2"})
    if lacks: print(one["file"], "lacks", *sorted(lacks))' "$commands")
[ -z "$unguarded" ] || complain "compiled without guards: $unguarded"
program=$root/usr/bin/epura
symbols=$(readelf --dyn-syms -W "$program")
grep -q __stack_chk_fail <<<"$symbols" || complain "the program does not guard its stack"
grep -qE '__[a-z]+_chk@' <<<"$symbols" || complain "the program does not check known sizes"
# Frames of more than a page are touched page by page.
[ "$(objdump -d --no-show-raw-insn "$program" | grep -cE 'orq +\$0x0,(0x[0-9a-f]+)?\(%rsp\)')" -ge 10 ] ||
  complain "the program does not touch the pages of its stack"

bill=$(find "$root" -name epura.spdx.json | head -1)
[ -n "$bill" ] || { complain "there is no bill of materials"; exit 1; }
known=$(python3 -c 'import json, sys
bill = json.load(open(sys.argv[1]))
assert bill["spdxVersion"] == "SPDX-2.3"
names = {package["SPDXID"]: package["name"] for package in bill["packages"]}
ends = {relation[end] for relation in bill["relationships"] for end in ("spdxElementId", "relatedSpdxElement")}
assert set(names) <= ends, set(names) - ends
print(*(name for name in names.values() if name != "epura"))' "$bill")
for package in $known; do unset "sources[$(dpkg-query -W -f '${source:Package}' "$package")]"; done
unset "sources[glibc]" "sources[gcc-12]"
for source in "${!sources[@]}"; do complain "the bill of materials lacks $source (${sources[$source]})"; done
exit $status
