"""What a command costs."""
import os
import subprocess
import sys
import time


class Cost:
    """The least seconds of several runs, and the most memory of any."""

    def __init__(self):
        self.seconds = float("inf")  # of all its threads
        self.wall = float("inf")
        self.peak = 0  # bytes

    def add(self, usage, wall):
        self.seconds = min(self.seconds, usage.ru_utime + usage.ru_stime)
        self.wall = min(self.wall, wall)
        self.peak = max(self.peak, usage.ru_maxrss * 1024)


def measured(words, repeat=1):
    """Of a command that succeeds. A child begins as a copy of this program: below its memory no
    peak is told."""
    cost = Cost()
    for _ in range(repeat):
        start = time.monotonic()
        child = subprocess.Popen(words, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status != 0:
            sys.exit(f"failed: {' '.join(words)}")
        cost.add(usage, time.monotonic() - start)
    return cost
