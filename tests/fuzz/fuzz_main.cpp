// SPDX-License-Identifier: GPL-3.0-or-later
// The fuzzer: `fuzz TARGET [options of libFuzzer] FOLDER...`. Built with Clang alone; scripts/fuzz
// builds and runs it.
#include "fuzz/fuzz_target.h"

#include <sanitizer/allocator_interface.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

using bspline_curve::fuzz::findTarget;
using bspline_curve::fuzz::FuzzTarget;

const FuzzTarget* target = nullptr;

// A file may take so many times its size, and what any file takes: buffers, tables, messages.
constexpr std::size_t kMemoryPerByte = 20;
constexpr std::size_t kMemoryOfAnyFile = 1U << 20U;

std::atomic<std::size_t> usedMemory = 0;
std::atomic<std::size_t> peakMemory = 0;

void countAllocated(const volatile void* /*memory*/, std::size_t size) {
    const std::size_t used = usedMemory += size;
    peakMemory = std::max(peakMemory.load(), used);
}

void countFreed(const volatile void* memory) {
    usedMemory -= __sanitizer_get_allocated_size(memory);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** words) {
    target = *count > 1 ? findTarget((*words)[1]) : nullptr;
    if (target == nullptr) {
        std::fputs("fuzz: the first word is none of the targets:", stderr);
        for (const FuzzTarget& each : bspline_curve::fuzz::fuzzTargets()) {
            std::fprintf(stderr, " %s", each.name.data());
        }
        std::fputc('\n', stderr);
        std::exit(2);
    }
    // libFuzzer takes the words after it.
    (*words)[1] = (*words)[0];
    ++*words;
    --*count;
    __sanitizer_install_malloc_and_free_hooks(countAllocated, countFreed);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::size_t before = usedMemory;
    peakMemory = before;
    target->run({reinterpret_cast<const char*>(data), size});
    if (target->isReader) {
        bspline_curve::fuzz::require(
            peakMemory - before <= kMemoryPerByte * size + kMemoryOfAnyFile,
            "memory is in proportion to the file"
        );
    }
    return 0;
}
