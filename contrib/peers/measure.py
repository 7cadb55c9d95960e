# SPDX-License-Identifier: LGPL-2.1-or-later
"""Running a program and what it costs."""
import os
import subprocess
import sys
import time

# one thread for the peers: on these sizes more make them slower; where Debian keeps FreeFEM's plugins
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1", FF_LOADPATH="/usr/lib/freefem++")
LIMIT = 600  # seconds


class Failure(Exception):
    pass


def run(command, folder, log="log.txt", own_threads=False):
    """Seconds, processor seconds and peak memory in MB of one run; what it prints goes to the log."""
    path = os.path.join(folder, log)
    environment = os.environ if own_threads else ENVIRONMENT
    with open(path, "w") as output:
        start = time.perf_counter()
        try:
            # GNU time tells the memory: what wait4 knows of it includes that of this program, which forks
            process = subprocess.Popen(["/usr/bin/time", "-q", "-f", "%M", "-o", "memory.txt", "timeout", str(LIMIT),
                                        *command], cwd=folder, stdout=output, stderr=subprocess.STDOUT, env=environment)
        except OSError as error:
            raise Failure("%s does not start: %s" % (command[0], error)) from error
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        reason = "took more than %d s" % LIMIT if process.returncode == 124 else "ended with %d" % process.returncode
        raise Failure("%s %s; its messages are in %s" % (" ".join(command), reason, path))
    with open(os.path.join(folder, "memory.txt")) as file:
        memory = float(file.read()) / 1024
    return {"seconds": seconds, "cpu_seconds": usage.ru_utime + usage.ru_stime, "memory_mb": memory}


def least(command, folder, own_threads=False, repetitions=3):
    """The least of some repetitions, of one where it takes 5 s or more."""
    best = run(command, folder, own_threads=own_threads)
    for _ in range(repetitions - 1 if best["seconds"] < 5 else 0):
        other = run(command, folder, own_threads=own_threads)
        best = {key: min(best[key], other[key]) for key in best}
    return best


def say(text):
    print(text, flush=True, file=sys.stderr)
