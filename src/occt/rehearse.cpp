// SPDX-License-Identifier: MIT
#include "occt/rehearse.h"

#include "base/error.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>

namespace tessera
{
namespace
{

constexpr std::size_t kMegabyte = std::size_t {1} << 20;

void limit(int resource, std::size_t value)
{
    rlimit limits {};
    if (getrlimit(static_cast<__rlimit_resource_t>(resource), &limits) == 0
        && (limits.rlim_max == RLIM_INFINITY || value < limits.rlim_max)) {
        limits.rlim_cur = value;
        setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
    }
}

[[noreturn]] void readAndExit(const std::function<void()>& read, std::size_t fileSize)
{
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, 5 + 10 * fileSize / kMegabyte);
#ifndef __SANITIZE_ADDRESS__ // which reserves far more than it uses
    limit(RLIMIT_AS, 2048 * kMegabyte + 200 * fileSize);
#endif
    for (const int fatal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        std::signal(fatal, SIG_DFL);
    }
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        read();
    }
    catch (...) {
        _exit(EXIT_SUCCESS); // the caller meets the same exception and knows what to make of it
    }
    _exit(EXIT_SUCCESS);
}

} // namespace

bool comesBack(const std::function<void()>& read, std::size_t fileSize)
{
    const pid_t copy = fork();
    if (copy == 0) {
        readAndExit(read, fileSize);
    }
    if (copy < 0) {
        throw Error(ErrorKind::TooLarge,
                    "There is not enough memory to read the file; close other programs.");
    }
    int status = 0;
    while (waitpid(copy, &status, 0) < 0) {
        if (errno != EINTR) {
            return false;
        }
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

} // namespace tessera
