/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Preloaded into a program that draws with GLX: writes when it showed a frame, in seconds, one a line, into the file that
 * SWAP_TIMES names. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef void (*swap_function)(void *display, unsigned long drawable);

void glXSwapBuffers(void *display, unsigned long drawable) {
    static swap_function swap;
    static FILE *times;
    if (swap == NULL) {
        swap = (swap_function)dlsym(RTLD_NEXT, "glXSwapBuffers");
        times = fopen(getenv("SWAP_TIMES"), "w");
        if (swap == NULL || times == NULL) {
            abort();
        }
    }
    swap(display, drawable);
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    fprintf(times, "%ld.%09ld\n", (long)now.tv_sec, now.tv_nsec);
    fflush(times);
}
