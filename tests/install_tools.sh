#!/bin/sh
# Installs what the tests need beyond Python's packages: compilers, also for other processors,
# sanitizers, clang-tidy, emulators, a browser.  Prints nothing if nothing is missing.  Otherwise
# installs Debian's packages if it is root, or `sudo -n` works; if not, prints the one command that
# installs them, and fails.
set -u
python=${PYTHON3:-python3}
missing=

# here COMMAND...: whether it runs, quietly, on an empty C program
here() { echo 'int main(void) { return 0; }' | "$@" >/dev/null 2>&1; }

# any COMMAND...: whether one of them is there
any() { for name; do command -v "$name" && return; done; return 1; }

# need PACKAGE... unless COMMAND...: adds the packages if the command fails
need() {
  packages=
  while [ "$1" != unless ]; do packages="$packages $1"; shift; done
  shift
  here "$@" && return
  for package in $packages; do
    case " $missing " in *" $package "*) ;; *) missing="${missing:+$missing }$package" ;; esac
  done
}

find_missing() {
  missing=
  need make unless command -v make
  need python3 python3-venv python3-dev unless command -v "$python"
  need python3-venv unless "$python" -c 'import ensurepip'
  need python3-dev unless "$python" -c \
    'import os, sysconfig as s; open(os.path.join(s.get_paths()["include"], "Python.h"))'
  need gcc libc6-dev unless gcc -x c - -o /dev/null
  need g++ unless g++ -x c++ - -o /dev/null
  need clang libclang-rt-dev unless clang -x c -fsanitize=address,undefined - -o /dev/null
  need clang unless clang++ -x c++ - -o /dev/null
  need clang-tidy unless command -v clang-tidy
  need binutils unless command -v objdump
  for processor in aarch64-linux-gnu:arm64 riscv64-linux-gnu:riscv64 \
      arm-linux-gnueabihf:armhf s390x-linux-gnu:s390x; do
    target=${processor%:*}
    need "gcc-$target" "libc6-dev-${processor#*:}-cross" unless \
      "$target-gcc" -static -x c - -o /dev/null
  done
  need gcc-arm-none-eabi libnewlib-arm-none-eabi unless \
    arm-none-eabi-gcc -include string.h -x c -fsyntax-only -
  need qemu-user unless command -v qemu-s390x
  need chromium unless any chromium google-chrome chromium-browser
  need chromium-driver unless command -v chromedriver
}

find_missing
[ -z "$missing" ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "make test: install what Debian calls $missing; there is no apt-get here that could" >&2
  exit 1
elif [ "$(id -u)" = 0 ]; then
  as_root=
elif sudo -n true 2>/dev/null; then
  as_root="sudo -n"
else
  echo "make test: packages are missing; this command installs them:" >&2
  echo "sudo apt-get install -y $missing"
  exit 1
fi

echo "make test: installing $missing"
$as_root apt-get update -qq
# Unquoted, as they are several words.
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $missing || exit 1
find_missing
[ -z "$missing" ] && exit 0
echo "make test: apt-get has installed it, and the commands of $missing still fail" >&2
exit 1
