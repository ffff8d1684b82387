#!/usr/bin/env bash
# Prints the folder with the headers of Debian's OpenFOAM, which no binary package holds.
# What is not there yet is taken from Debian's source package, once, into
# ${XDG_CACHE_HOME:-~/.cache}/poreclog/openfoam-VERSION: about 45 MB over the network, 30 MB on
# the disk.  Neither apt's own lists nor its sources are touched, root is not needed.
set -eu

version=$(dpkg-query -W -f='${source:Version}' libopenfoam 2>/dev/null) || {
  echo "openfoam_headers.sh: the package libopenfoam is not installed" >&2
  exit 1
}
cache=${XDG_CACHE_HOME:-${HOME:?is not set, nor is XDG_CACHE_HOME}/.cache}/poreclog
headers=$cache/openfoam-$version
# It comes there by a rename, so it is whole.
if [ -d "$headers" ]; then
  echo "$headers"
  exit 0
fi

mkdir -p "$cache"
work=$(mktemp -d "$cache/openfoam.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/source"

# The Debian mirrors that this machine uses already; what apt fetches is verified by the
# checksums in their signed lists.
mirrors=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
            'Created-By: Packages' 'Origin: Debian' 'Component: main')
keys=/usr/share/keyrings/debian-archive-keyring.gpg
echo "${mirrors:-http://deb.debian.org/debian/ bookworm main}" |
  sed "s|^|deb-src [signed-by=$keys] |" >"$work/sources.list"
as_here=(
  -o "Dir::Etc::SourceList=$work/sources.list" -o Dir::Etc::SourceParts=/dev/null
  -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache"
  -o APT::Sandbox::User=root -o Acquire::Languages=none -o Acquire::http::Timeout=20
)
cd "$work/source"
if ! { apt-get -q "${as_here[@]}" -o APT::Update::Error-Mode=any update &&
       apt-get -q "${as_here[@]}" source --download-only --tar-only "openfoam=$version"
     } >"$work/log" 2>&1; then
  tail -n 5 "$work/log" >&2
  echo "openfoam_headers.sh: the source package openfoam $version cannot be fetched." \
       "Without a network: copy $headers from a machine that has it, or name a folder" \
       "with headers of OpenFOAM v1912 in PORECLOG_OPENFOAM_HEADERS" >&2
  exit 1
fi

# One flat folder of headers per library, as OpenFOAM's own build makes them (lnInclude).  The
# .C files are templates, which the headers include.
mkdir "$work/tree" "$work/headers"
tar xf "$work"/source/openfoam_*.orig.tar.* -C "$work/tree" --strip-components=1 --wildcards \
  '*/src/OpenFOAM/*' '*/src/OSspecific/POSIX/*' '*/src/finiteVolume/*' '*/src/meshTools/*' \
  '*/src/fileFormats/*' '*/src/surfMesh/*'
for library in OpenFOAM OSspecific/POSIX finiteVolume meshTools fileFormats surfMesh; do
  mkdir "$work/headers/${library%%/*}"
  find "$work/tree/src/$library" \
    \( -name lnInclude -o -name Make -o -name config -o -name noLink \) -prune -o \
    -type f \( -name '*.[CHh]' -o -name '*.[ch]xx' -o -name '*.[ch]pp' -o -name '*.type' \) \
    -exec cp -t "$work/headers/${library%%/*}" {} +
done
# Somebody else may have been faster: then theirs is as good.
mv -T "$work/headers" "$headers" 2>/dev/null || [ -d "$headers" ]
echo "$headers"
