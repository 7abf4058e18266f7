# SPDX-License-Identifier: GPL-3.0-or-later
# Toolchain: WebAssembly for browsers and node, by Debian's clang-22 and its wasi-libc. scripts/web uses it, and makes
# BSPLINE_CURVE_WASM_RUNTIME, which has
#   include/   headers that go before the compiler's: libc++ with std::filesystem::path, nlohmann-json
#   lib/       what Debian's libc++ leaves out: exceptions, std::filesystem::path
# Exceptions are those of WebAssembly in their first encoding, which every browser of the last years runs, as does node 20.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-22)
set(CMAKE_CXX_COMPILER clang++-22)
set(CMAKE_AR llvm-ar-22)
set(CMAKE_RANLIB llvm-ranlib-22)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES BSPLINE_CURVE_WASM_RUNTIME)

set(CMAKE_CXX_FLAGS_INIT
  "-isystem ${BSPLINE_CURVE_WASM_RUNTIME}/include -fwasm-exceptions -msimd128 -Wno-deprecated")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-L${BSPLINE_CURVE_WASM_RUNTIME}/lib")
# One thread; no sharing of memory.
set(BSPLINE_CURVE_THREADS OFF CACHE BOOL "There are no threads in one worker")

# Libraries of headers alone serve every processor.
set(Eigen3_DIR /usr/share/eigen3/cmake)
set(nlohmann_json_DIR ${CMAKE_CURRENT_LIST_DIR}/../web/runtime/nlohmann_json)
