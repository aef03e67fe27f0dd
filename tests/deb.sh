#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian packages: built, looked at by lintian, built again elsewhere with the same bytes, installed into a Debian 12
# with nothing else in it, used there, and removed without a trace. Takes twice the time of a build and some minutes, and
# needs root, mmdebstrap and lintian.  tests/deb.sh [SYSTEM.tar]
# A file that mmdebstrap made before (--variant=minbase --include=ca-certificates) saves most of these minutes.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."
for tool in mmdebstrap lintian dpkg-deb; do
  command -v $tool >/dev/null || { echo "deb: skipped, for there is no $tool (apt-get install mmdebstrap lintian)" >&2; exit 0; }
done
[ "$(id -u)" -eq 0 ] || { echo "deb: skipped, for only root makes a fresh system" >&2; exit 0; }

build=build/deb
cmake --preset deb >/dev/null
cmake --build --preset deb
rm -f $build/*.deb
(cd $build && cpack >cpack.log 2>&1) || { cat $build/cpack.log >&2; exit 1; }
# Of the tags that would be errors in Debian, none; there is no bug of Debian to close.
lintian --fail-on error --suppress-tags initial-upload-closes-no-bugs $build/*.deb

scratch=$(mktemp -d)
for package in $build/*.deb; do dpkg-deb -x "$package" "$scratch/contents"; done
tests/hardening.sh "$scratch/contents" $build/compile_commands.json
tests/traces.sh "$scratch/contents"
system=$scratch/system
end() {
  for part in proc dev; do if mountpoint -q "$system/$part"; then umount "$system/$part"; fi; done
  rm -rf "$scratch"
}
trap end EXIT

if [ $# -gt 0 ]; then
  mkdir "$system"
  tar -C "$system" -xf "$1"
else
  # With the sources and settings of apt on this machine, there as here.
  settings=()
  for file in /etc/apt/apt.conf.d/*; do settings+=(--aptopt="$file"); done
  mmdebstrap --quiet --variant=minbase --include=ca-certificates "${settings[@]}" bookworm "$system" \
    /etc/apt/sources.list.d/debian.sources
fi
mount --bind /proc "$system/proc"
mount --bind /dev "$system/dev"
cp $build/*.deb samples/models/bracket.obj "$system/tmp"

# Built again in another folder, without the history, and later: the same bytes.
elsewhere=$scratch/elsewhere
mkdir "$elsewhere"
git ls-files -z | xargs -0 cp --parents -t "$elsewhere"
(export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}"
 cd "$elsewhere" && cmake --preset deb && cmake --build --preset deb && cd $build && cpack) >"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; exit 1; }
for package in $build/*.deb; do
  cmp "$package" "$elsewhere/$build/${package##*/}" || { echo "deb: the bytes depend on the folder or the time" >&2; exit 1; }
done

inside() {
  chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}
fail() { echo "deb: $*" >&2; exit 1; }
traces() { inside find / -xdev -path /proc -prune -o -path /dev -prune -o -path /tmp -prune -o -iname '*epura*' -print; }

inside apt-get -q update >"$scratch/log"
inside sh -c 'apt-get -q install --yes --no-install-recommends /tmp/epura_*.deb' >"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; fail "cannot be installed"; }
inside epura draw /tmp/bracket.obj --views front,top,isometric --dimensions overall --title Bracket -o /tmp/bracket.pdf \
  -o /tmp/bracket.svg
[ "$(head -c 5 "$system/tmp/bracket.pdf")" = %PDF- ] || fail "the PDF is none"
inside epura draw /tmp/bracket.obj --projection cabinet:angle=30 -o /tmp/cabinet.svg
[ "$(inside epura plugins | grep -c '^  ')" -ge 22 ] || fail "projections are missing"
inside bash -c 'source /usr/share/bash-completion/completions/epura; COMP_LINE="epura draw --projection cab" COMP_POINT=27
  COMP_WORDS=(epura draw --projection cab) COMP_CWORD=3; _epura epura; [ "${COMPREPLY[*]}" = cabinet ]' || fail "no completion"
zcat "$system/usr/share/man/man1/epura.1.gz" | grep cabinet >/dev/null || fail "the manual page does not know the projections"

inside epura study stability --cases P1 2>"$scratch/log" && fail "there is no study, and that is no failure"
grep 'install the package epura-study' "$scratch/log" >/dev/null || fail "epura does not tell that the study is missing"
inside sh -c 'apt-get -q install --yes --no-install-recommends /tmp/epura-study_*.deb' >"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; fail "the study cannot be installed"; }
inside epura study stability --cases P1 | grep '^P1 ' >/dev/null || fail "the study is not found"
[ -s "$system/usr/share/man/man1/epura-study.1.gz" ] || fail "the study has no manual page"

cat >"$system/tmp/triangle.gltf" <<'END'
{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36,
 "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAzczMPQAAAAAAAAAAAAAAAM3MzD0AAAAA"}]}
END
inside epura draw /tmp/triangle.gltf -o /tmp/triangle.svg 2>"$scratch/log" && fail "there is no importer, and that is no failure"
grep 'install the package epura-gltf' "$scratch/log" >/dev/null || fail "epura does not tell that the importer is missing"
inside sh -c 'apt-get -q install --yes --no-install-recommends /tmp/epura-opencascade_*.deb /tmp/epura-gltf_*.deb /tmp/epura-3mf_*.deb /tmp/epura-om_*.deb' >"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; fail "the importers cannot be installed"; }
inside epura draw /tmp/triangle.gltf -o /tmp/triangle.svg || fail "glTF is not drawn"
[ "$(inside epura importers | grep -cE '^  (step|iges|brep|gltf|3mf|om) ')" -eq 6 ] || fail "importers are missing"

inside sh -c 'apt-get -q install --yes --no-install-recommends /tmp/libepura*.deb' >"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; fail "the library cannot be installed"; }
inside ldconfig -p | grep "libepura.so" >/dev/null || fail "the library is not found"

inside sh -c 'apt-get -q install --yes --no-install-recommends /tmp/python3-epura_*.deb' >"$scratch/log" 2>&1 ||
  { cat "$scratch/log" >&2; fail "the module for Python cannot be installed"; }
inside python3 -c 'import epura, importlib.metadata as known
drawing = epura.draw("/tmp/bracket.obj", views=["front", "top", "isometric"], title="Bracket")
drawing.save("/tmp/module.svg")
assert epura.compare("/tmp/module.svg", drawing)
assert len(epura.draw("/tmp/triangle.gltf").views[0].segments) == 3
assert known.version("epura") == epura.__version__
assert [point.value for point in known.entry_points(group="pytest11") if point.name == "epura"] == ["pytest_epura"]
' || fail "the module for Python does not work"

inside apt-get -q purge --yes python3-epura epura epura-study epura-opencascade epura-gltf epura-3mf epura-om libepura-dev >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; fail "stays"; }
left=$(traces)
[ -z "$left" ] || fail "leaves behind: $left"
echo "deb: $(cd $build && echo *.deb): installed, used and removed"
