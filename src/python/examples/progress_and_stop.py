"""A bar on the terminal, Ctrl-C, and a stop button that a timer presses.

    python3 progress_and_stop.py STACK [SECONDS]
"""

import sys
import threading

import tetloft


def bar(done, all):
    print(f"\r[{'#' * (40 * done // all):40}] {done} of {all}", end="", flush=True)


def main(path, seconds):
    stop = tetloft.Stop()
    timer = threading.Timer(seconds, stop.request)
    timer.daemon = True
    timer.start()
    try:
        solid = tetloft.reconstruct(tetloft.read_stack(path), progress=bar, stop=stop)
    except tetloft.Cancelled:
        print("\nthat takes too long")
        return 1
    except KeyboardInterrupt:
        print("\nstopped")
        return 130
    except tetloft.Error as error:
        print(f"\n{error}", f"(section {error.place.section}, contour {error.place.contour})")
        return error.code
    print(f"\n{solid}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 60))
