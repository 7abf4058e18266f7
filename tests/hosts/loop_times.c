/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Preloaded into a program with a window: writes how long its main thread stayed away from its event loop, one stay a line,
 * into the file that LOOP_TIMES names: when it ended, seconds by the clock, seconds of computing, frames shown in it. Stays of
 * less than 20 ms are left out. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static double left, computed;
static int frames;

static double seconds(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Whether it is the event loop that waits, by the library that calls. */
static int is_loop(void *caller) {
    Dl_info from;
    return gettid() == getpid() && dladdr(caller, &from) != 0 &&
           (strstr(from.dli_fname, "libglib") != NULL || strstr(from.dli_fname, "libQt5Core") != NULL);
}

static void come(void) {
    static FILE *times;
    const double now = seconds(CLOCK_MONOTONIC);
    if (times == NULL) {
        times = fopen(getenv("LOOP_TIMES"), "w");
        if (times == NULL) {
            abort();
        }
    } else if (now - left > 0.02) {
        fprintf(times, "%.6f %.6f %.6f %d\n", now, now - left, seconds(CLOCK_THREAD_CPUTIME_ID) - computed, frames);
        fflush(times);
    }
}

static void go(void) {
    frames = 0;
    left = seconds(CLOCK_MONOTONIC);
    computed = seconds(CLOCK_THREAD_CPUTIME_ID);
}

int poll(struct pollfd *descriptors, nfds_t count, int timeout) {
    static int (*next)(struct pollfd *, nfds_t, int);
    if (next == NULL) {
        next = (int (*)(struct pollfd *, nfds_t, int))dlsym(RTLD_NEXT, "poll");
    }
    const int ours = is_loop(__builtin_return_address(0));
    if (ours) {
        come();
    }
    const int answer = next(descriptors, count, timeout);
    if (ours) {
        go();
    }
    return answer;
}

int ppoll(struct pollfd *descriptors, nfds_t count, const struct timespec *timeout, const sigset_t *mask) {
    static int (*next)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *);
    if (next == NULL) {
        next = (int (*)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *))dlsym(RTLD_NEXT, "ppoll");
    }
    const int ours = is_loop(__builtin_return_address(0));
    if (ours) {
        come();
    }
    const int answer = next(descriptors, count, timeout, mask);
    if (ours) {
        go();
    }
    return answer;
}

void glXSwapBuffers(void *display, unsigned long drawable) {
    static void (*next)(void *, unsigned long);
    if (next == NULL) {
        next = (void (*)(void *, unsigned long))dlsym(RTLD_NEXT, "glXSwapBuffers");
    }
    next(display, drawable);
    ++frames;
}
