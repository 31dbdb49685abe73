// Answers the clocks with the processor time of all threads of the process, so that a busy machine takes none of a
// library's budget: LD_PRELOAD (beeson2015.sh).
#define _GNU_SOURCE
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

int clock_gettime(clockid_t clock, struct timespec *time) {
  const int is_of_wall = clock != CLOCK_PROCESS_CPUTIME_ID && clock != CLOCK_THREAD_CPUTIME_ID;
  return (int)syscall(SYS_clock_gettime, is_of_wall ? CLOCK_PROCESS_CPUTIME_ID : clock, time);
}

int gettimeofday(struct timeval *restrict time, void *restrict zone) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  *time = (struct timeval){now.tv_sec, now.tv_nsec / 1000};
  return 0;
}
