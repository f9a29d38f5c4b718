#!/usr/bin/env python3
"""Runs the tests of a built folder, several GoogleTest cases in each process.

Usage: run-tests.py [-j JOBS] <build folder> [ctest option that selects tests...]

ctest starts a process for each case, and most of the time of a short case goes into loading VTK's
libraries. This script asks ctest for its tests, puts up to CHUNK cases of one program into one
process, and runs the other tests with ctest. Cases of one process must not disturb each other.

A case that fails prints its output. When a process dies, the case that it was in has failed and the
cases after it run in a new process. The whole output is in Testing/Temporary/tests.log below the
build folder. The last line is "<n> passed, <n> failed"; the exit code is 0 only if none failed.
"""

import argparse
import json
import os
import queue
import re
import subprocess
import sys
import threading
import time

CHUNK = 16
TIMEOUT = 1500  # seconds of one process, as ctest's default
FILTER = "--gtest_filter="
RESULT = re.compile(r"\[ +(RUN|OK|FAILED|SKIPPED) +\] (\S+?)(?:,| \(|$)")


class Program:
    """The selected cases of one GoogleTest program."""

    def __init__(self, path, folder, environment):
        self.path = path
        self.folder = folder
        self.environment = environment
        self.cases = []

    def run(self, cases):
        """Runs cases in one process; returns its output."""
        command = [self.path, FILTER + ":".join(cases), "--gtest_color=no"]
        try:
            done = subprocess.run(
                command,
                cwd=self.folder,
                env=self.environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                timeout=TIMEOUT,
                check=False,
            )
            output, end = done.stdout, f"The program ended with exit code {done.returncode}.\n"
        except subprocess.TimeoutExpired as late:
            output, end = late.stdout or b"", f"The program was stopped after {TIMEOUT} s.\n"
        return output.decode(errors="replace"), end


class Report:
    """Counts and prints results; called from several threads."""

    def __init__(self, total, log):
        self.total = total
        self.log = log
        self.lock = threading.Lock()
        self.passed = 0
        self.failures = []

    def add(self, label, passed, failures, output, seconds):
        """failures: pairs of a name and its output."""
        with self.lock:
            self.log.write(output)
            self.log.flush()
            self.passed += passed
            self.failures += [name for name, _ in failures]
            done = self.passed + len(self.failures)
            print(f"{done:5}/{self.total}  {seconds:6.1f} s  {label}: {passed} passed", flush=True)
            for name, text in failures:
                print(f"FAILED {name}\n{text}", flush=True)


def results_of(output, cases):
    """Results by case, the output of each case, and the case that was running at the end."""
    results, texts, running = {}, {}, None
    known = set(cases)
    for line in output.splitlines(keepends=True):
        match = RESULT.search(line) # what a case prints may lack a newline
        if match and match[2] in known:
            if match[1] == "RUN":
                running = match[2]
                texts[running] = ""
            elif match[2] == running:
                results[running] = match[1]
                texts[running] += line
                running = None
                continue
        if running:
            texts[running] += line
    return results, texts, running


def run_chunk(label, program, cases, report):
    """Runs cases until each has a result."""
    while cases:
        start = time.monotonic()
        output, end = program.run(cases)
        results, texts, running = results_of(output, cases)
        if running:
            results[running] = "FAILED"
            texts[running] += end
        elif not results:
            results = {case: "FAILED" for case in cases}
            texts = {cases[0]: output + end}
        failures = [
            (f"{label}.{case}", texts.get(case, "")) for case, r in results.items() if r == "FAILED"
        ]
        passed = len(results) - len(failures)
        report.add(label, passed, failures, output, time.monotonic() - start)
        cases = [case for case in cases if case not in results]


def run_others(build, names, report):
    """Runs tests that are no GoogleTest cases, with ctest."""
    pattern = "^(" + "|".join(re.escape(name) for name in names) + ")$"
    start = time.monotonic()
    done = subprocess.run(
        ["ctest", "--test-dir", build, "--output-on-failure", "-R", pattern],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    output = done.stdout.decode(errors="replace")
    failed = re.findall(r"^\s*\d+/\d+ Test +#\d+: (\S+) \.+\**(?!.*(?:Passed|Skipped) )", output, re.M)
    failures = [(name, "") for name in failed]
    if done.returncode != 0:
        failures = failures or [("ctest", "")]
        failures[0] = (failures[0][0], output)
    report.add("ctest", len(names) - len(failures), failures, output, time.monotonic() - start)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count())
    parser.add_argument("build")
    arguments, selection = parser.parse_known_args()

    listing = subprocess.run(
        ["ctest", "--test-dir", arguments.build, "--show-only=json-v1", *selection],
        stdout=subprocess.PIPE,
        check=True,
    )
    programs, others = {}, []
    for test in json.loads(listing.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        if properties.get("DISABLED"):
            continue
        command = test.get("command", [])
        filters = [word[len(FILTER) :] for word in command if word.startswith(FILTER)]
        if len(filters) != 1 or not os.path.exists(command[0]):
            others.append(test["name"])
            continue
        if command[0] not in programs:
            environment = dict(os.environ)
            environment.update(pair.split("=", 1) for pair in properties.get("ENVIRONMENT", []))
            programs[command[0]] = Program(
                command[0], properties.get("WORKING_DIRECTORY", arguments.build), environment
            )
        programs[command[0]].cases.append((test["name"], filters[0]))
    total = len(others) + sum(len(program.cases) for program in programs.values())
    if total == 0:
        sys.exit("run-tests: no test matches")

    jobs = queue.SimpleQueue()
    with open(os.path.join(arguments.build, "Testing/Temporary/tests.log"), "w") as log:
        report = Report(total, log)
        if others:
            jobs.put(lambda: run_others(arguments.build, others, report))
        # Long programs first, so that no core idles at the end.
        for program in sorted(programs.values(), key=lambda p: -len(p.cases)):
            label = program.cases[0][0].split(".")[0]
            cases = [case for _, case in program.cases]
            for first in range(0, len(cases), CHUNK):
                chunk = cases[first : first + CHUNK]
                jobs.put(lambda l=label, p=program, c=chunk: run_chunk(l, p, c, report))

        def work():
            while True:
                try:
                    job = jobs.get_nowait()
                except queue.Empty:
                    return
                job()

        workers = [threading.Thread(target=work) for _ in range(max(1, arguments.jobs))]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()

    for name in report.failures:
        print(f"FAILED {name}")
    print(f"{report.passed} passed, {len(report.failures)} failed")
    sys.exit(1 if report.failures else 0)


if __name__ == "__main__":
    main()
