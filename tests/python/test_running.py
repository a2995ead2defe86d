"""Long calls: progress, stop buttons, Ctrl-C, and threads."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import tetloft
from support import box, circles, rows


class Progress(unittest.TestCase):
    def test_is_told_of_steps(self):
        told = []
        tetloft.reconstruct(circles(6, 50), progress=lambda done, all: told.append((done, all)))
        self.assertEqual([done for done, _ in told], list(range(1, len(told) + 1)))
        self.assertEqual({all for _, all in told}, {len(told)})

    def test_that_raises_stops_the_call_and_comes_out_as_it_is(self):
        class Enough(Exception):
            pass

        told = []

        def progress(done, all):
            told.append((done, all))
            raise Enough(done)

        for call in (lambda **how: tetloft.reconstruct(circles(60, 50), **how),
                     lambda **how: tetloft.check(solid, stack, **how),
                     lambda **how: tetloft.links(circles(60, 50), **how)):
            stack = circles(3, 20)
            solid = tetloft.reconstruct(stack)
            for threads in (1, 4):
                told.clear()
                with self.assertRaises(Enough):
                    call(progress=progress, threads=threads)
                self.assertEqual(len(told), 1)

    def test_may_call_the_library(self):
        volumes = []
        tetloft.reconstruct(circles(3, 20), progress=lambda done, all: volumes.append(
            tetloft.reconstruct(box()).volume))
        self.assertEqual(set(volumes), {80})


class TheEnd(unittest.TestCase):
    def test_of_the_interpreter_still_takes_calls(self):
        made = subprocess.run([sys.executable, "-c", """
import tetloft
class Late:
    def __init__(self, stack): self.stack, self.call = stack, tetloft.reconstruct
    def __del__(self): print(self.call(self.stack).volume)
square = [(0, 0), (2, 0), (2, 2), (0, 2)]
late = Late(tetloft.Stack([(0, [square]), (3, [square])]))
"""], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
        self.assertEqual((made.returncode, made.stdout), (0, "12.0\n"))


class Stops(unittest.TestCase):
    def test_end_the_calls_they_were_given_to(self):
        stop, told = tetloft.Stop(), []

        def progress(done, all):
            told.append(all)
            stop.request()

        self.assertEqual((stop.requested, repr(stop)), (False, "<tetloft.Stop>"))
        with self.assertRaises(tetloft.Cancelled):
            tetloft.reconstruct(circles(60, 50), progress=progress, stop=stop)
        self.assertLess(len(told), told[0])
        self.assertEqual((stop.requested, repr(stop)), (True, "<tetloft.Stop, pressed>"))

    def test_stay_pressed(self):
        stop = tetloft.Stop()
        stop.request()
        lattice = [(k % 7, k * k % 11, 3 * k % 5) for k in range(3000)]
        for call in (lambda: tetloft.reconstruct(box(), stop=stop),
                     lambda: tetloft.check(tetloft.reconstruct(box()), box(), stop=stop),
                     lambda: tetloft.between(box(), stop=stop),
                     lambda: tetloft.links(box(), stop=stop),
                     lambda: tetloft.reconstruct(box()).render("none.png", stop=stop),
                     lambda: tetloft.delaunay([p[:2] for p in lattice], stop=stop),
                     lambda: tetloft.delaunay(lattice, stop=stop)):
            with self.assertRaises(tetloft.Cancelled):
                call()
        self.assertEqual(tetloft.reconstruct(box(), stop=tetloft.Stop()).volume, 80)


class CtrlC(unittest.TestCase):
    def interrupt(self, handler, expected):
        """Sends SIGINT from within a call, lets the main thread take it, counts what follows."""
        handled, told = threading.Event(), []

        def take(number, frame):
            handled.set()
            handler(number, frame)

        def progress(done, all):
            told.append(all)
            if done == 1:
                os.kill(os.getpid(), signal.SIGINT)
                self.assertTrue(handled.wait(60))
                time.sleep(0.1)  # the main thread is about to press the stop

        before = signal.signal(signal.SIGINT, take)
        try:
            with self.assertRaises(expected):
                tetloft.reconstruct(circles(200, 50), progress=progress, threads=1)
        finally:
            signal.signal(signal.SIGINT, before)
        self.assertLess(len(told), told[0])

    def test_is_a_keyboard_interrupt_that_stops_the_call(self):
        self.interrupt(signal.default_int_handler, KeyboardInterrupt)

    def test_may_be_any_exception_of_a_handler(self):
        def handler(number, frame):
            raise LookupError

        self.interrupt(handler, LookupError)

    def test_leaves_a_stop_of_the_caller_as_it_is(self):
        stop = tetloft.Stop()

        def progress(done, all):
            if done == 1:
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(0.1)

        with self.assertRaises(KeyboardInterrupt):
            tetloft.reconstruct(circles(200, 50), progress=progress, stop=stop)
        self.assertFalse(stop.requested)

    def test_ends_a_program(self):
        code = ("import sys, time; sys.path[:0] = sys.argv[1:]\n"
                "import support, tetloft\n"
                "def progress(done, all):\n"
                "    print(done, all, flush=True)\n"
                "    if done == 1:\n"
                "        sys.stdin.readline()  # the signal was sent\n"
                "        time.sleep(0.1)\n"
                "tetloft.reconstruct(support.circles(200, 50), progress=progress, threads=1)\n")
        here = os.path.dirname(os.path.abspath(__file__))
        with subprocess.Popen([sys.executable, "-c", code, here], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as program:
            first = program.stdout.readline().split()
            program.send_signal(signal.SIGINT)
            told, complaint = program.communicate("sent\n", timeout=300)
        self.assertEqual(program.returncode, -signal.SIGINT)
        self.assertIn("KeyboardInterrupt", complaint)
        self.assertNotIn("Cancelled", complaint)
        self.assertLess(len(told.splitlines()) + 1, int(first[1]))


class Threads(unittest.TestCase):
    def test_may_call_all_at_once(self):
        stack, made = circles(5, 60), {}
        expected = rows(tetloft.reconstruct(stack).tets)

        def work(number):
            steps = []
            solid = tetloft.reconstruct(stack, threads=1 + number % 2,
                                        progress=lambda done, all: steps.append(done))
            made[number] = (rows(solid.tets) == expected, bool(tetloft.check(solid, stack)),
                            len(steps) > 0)

        threads = [threading.Thread(target=work, args=(number,)) for number in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(made, {number: (True, True, True) for number in range(6)})

    def test_stop_each_other(self):
        stop, started, raised = tetloft.Stop(), threading.Event(), []

        def work():
            try:
                tetloft.reconstruct(circles(400, 200), stop=stop,
                                    progress=lambda done, all: started.set())
            except tetloft.Error as error:
                raised.append(type(error))

        thread = threading.Thread(target=work)
        thread.start()
        self.assertTrue(started.wait(60))
        stop.request()
        thread.join()
        self.assertEqual(raised, [tetloft.Cancelled])


if __name__ == "__main__":
    unittest.main()
