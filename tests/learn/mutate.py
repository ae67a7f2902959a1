#!/usr/bin/env python3
"""Tests the tests that learners run, by hand: makes each small change of mutants.py in each function that a lesson asks
for, and runs the lesson's tests. Each change must fail one, or not compile, or stand in mutants.toml with the reason
why it may pass. From the project's root, with a build in build/; all lessons take some minutes:

    tests/learn/mutate.py [LESSON…] [--function WORD] [--full] [--score]

--full prints how each change went, --score writes the table of docs/testing.md.

A lesson's tests are compiled by the compiler and the flags that learners get, with all changes in one program: the
starter's functions, each with a `switch` between its changed bodies, of which the environment's MUTANT chooses one.
Those that the compiler objects to are taken out until it has no objection. Then the program runs once for each change,
in all scalars, until a check fails."""
import argparse
import collections
import math
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import tomllib

from mutants import mutants

COMPILER = os.environ.get("CXX", "c++")
# As in src/learn/build and src/learn/check.
FLAGS = ["-std=c++20", "-ffp-contract=off", "-O0", "-g0", "-D_GLIBCXX_ASSERTIONS", "-Werror=return-type"]
MEMORY = 1 << 30

# Takes the place of lessons/not_written.hpp, which each starter includes.
CHOICE = """#pragma once
#include <cstdlib>
inline const int the_mutant = std::atoi(std::getenv("MUTANT"));
"""


class Lesson:
    def __init__(self, number, asked, folder):
        self.number, self.asked, self.folder = number, asked, folder
        self.seconds = 60  # of computing: what takes longer is endless
        exercise = next(pathlib.Path("lessons").glob(f"{number}-*")) / "exercise.toml"
        self.exercise = tomllib.loads(exercise.read_text())
        self.functions = [one for one in self.exercise["function"] if asked.function in one["name"]]
        self.tried = [(function, mutant) for function in self.functions for mutant in mutants(function["line"])]
        subprocess.run([asked.glassbox, "learn", "reset", str(number), "--folder", folder], check=True,
                       stdout=subprocess.DEVNULL)
        self.headers = next(folder.glob(f"{number}-*"))
        self.starters = {name: (self.headers / name).read_text() for name in self.exercise["headers"]}

    def write(self, refused):
        """Writes the headers, with all changes but those refused."""
        (self.headers / "not_written.hpp").write_text(CHOICE)
        for name, text in self.starters.items():
            for function in self.exercise["function"]:
                result = function["returns"]
                cases = [f'#line {k} "mutant"\ncase {k}: return [&]() -> {result} {{ {mutant.body} }}();'
                         for k, (whose, mutant) in enumerate(self.tried, 1) if whose is function and k not in refused]
                choice = ["switch (the_mutant) {", *cases, f'#line 1 "{name}"', "}"] if cases else []
                stub = f'return not_written<{result}>("{function["name"]}");'
                text = text.replace(stub, "\n".join([*choice, function["line"]]))
            (self.headers / name).write_text(text)

    def compile(self):
        """Makes the program. Returns the numbers of the changes that do not compile."""
        stages = sorted(pathlib.Path("src/core").glob(f"[1-{self.number}]-*"))
        includes = [self.headers, "lessons", *stages, "tests/stages", "tests", self.asked.doctest]
        command = [COMPILER, *FLAGS, *(f"-I{one}" for one in includes), "-include",
                   "src/learn/check/runner/prelude.hpp", "-c", self.exercise["tests"][0], "-o", self.folder / "tests.o"]
        refused = set()
        while True:
            self.write(refused)
            ran = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})
            if ran.returncode == 0:
                break
            objected = blamed(ran.stderr)
            if not objected:
                sys.exit(f"lesson {self.number} does not compile:\n{ran.stderr}")
            refused |= objected
        objects = [self.folder / "tests.o", *support(self.folder.parent, self.asked)]
        subprocess.run([COMPILER, *objects, "-o", self.folder / "program"], check=True)
        return refused

    def passes(self, k):
        """Whether all tests pass with change k; 0 is none."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (self.seconds, self.seconds))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        ran = subprocess.run([self.folder / "program", "--abort-after=1"], preexec_fn=limit, env={"MUTANT": str(k)},
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return ran.returncode == 0


def blamed(errors):
    """The changes that a compiler's errors are about: where one is, or else the innermost place that needed what is."""
    found, needed = set(), None
    for line in errors.splitlines():
        if place := re.match(r"mutant:(\d+):.*error:", line):
            found.add(int(place[1]))
        elif "error:" in line and needed:
            found.add(needed)
        if "error:" in line or "In instantiation of" in line or "In substitution of" in line:
            needed = None
        elif (place := re.match(r"mutant:(\d+):.*required (from|by)", line)) and not needed:
            needed = int(place[1])
    return found


def support(folder, asked):
    """What each test is linked with, compiled once."""
    objects = []
    for source in pathlib.Path("tests/support").glob("*.cpp"):
        objects.append(folder / f"{source.stem}.o")
        if not objects[-1].exists():
            command = [COMPILER, *FLAGS, "-Itests", f"-I{asked.doctest}", "-c", source, "-o", objects[-1]]
            subprocess.run(command, check=True)
    return objects


def listed():
    """What may pass: (lesson, function, was, becomes), and of which kind it is."""
    kinds = tomllib.loads((pathlib.Path(__file__).parent / "mutants.toml").read_text())
    return {(one["lesson"], one["function"], one["was"], becomes): kind
            for kind, all_of_it in kinds.items() for one in all_of_it for becomes in one["becomes"]}


def try_lesson(lesson, may_pass):
    """Tries all changes. Returns how many there were of each kind, and how many faults."""
    refused = lesson.compile()
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    if not lesson.passes(0):
        sys.exit(f"lesson {lesson.number}: the solution does not pass")
    lesson.seconds = 2 + 3 * math.ceil(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    counts = collections.Counter()
    passed = set()
    for function in lesson.functions:
        before = counts.copy()
        for k, (whose, mutant) in enumerate(lesson.tried, 1):
            if whose is not function:
                continue
            key = lesson.number, function["name"], mutant.was, mutant.becomes
            verdict = "does not compile" if k in refused else "fails"
            if verdict == "fails" and lesson.passes(k):
                verdict = may_pass.get(key, "PASSES")
                passed.add(key)
            counts[verdict] += 1
            if verdict == "PASSES" or lesson.asked.full:
                print(f"{verdict}:\nlesson = {key[0]}\nfunction = '{key[1]}'\nwas = '{key[2]}'\nbecomes = ['{key[3]}']",
                      flush=True)
        said = ", ".join(f"{count} {verdict}" for verdict, count in (counts - before).items())
        print(f"lesson {lesson.number}, {function['name']}: {said}", flush=True)
    tried = {one["name"] for one in lesson.functions}
    old = [key for key in may_pass if key[0] == lesson.number and key[1] in tried and key not in passed]
    for key in old:
        print(f"mutants.toml: error: lesson {key[0]}, {key[1]}: '{key[2]}' to '{key[3]}' fails by now, or is no change")
    return counts, counts["PASSES"] + len(old)


def table(scores):
    kinds = ["does not compile", "fails", "equal", "within_rounding", "as_good", "PASSES"]
    rows = ["| lesson | changes | do not compile | fail a test | equal | within rounding | as good | pass |",
            "|---|---|---|---|---|---|---|---|"]
    total = sum(scores.values(), collections.Counter())
    for name, counts in [*scores.items(), ("all", total)]:
        rows.append(f"| {name} | {counts.total()} | " + " | ".join(str(counts[kind]) for kind in kinds) + " |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("lessons", nargs="*", type=int, default=range(1, 8))
    parser.add_argument("--function", default="", help="those whose name has this word")
    parser.add_argument("--full", action="store_true", help="print each change")
    parser.add_argument("--score", action="store_true", help="write the table into docs/testing.md")
    parser.add_argument("--glassbox", default="build/bin/glassbox")
    parser.add_argument("--doctest", default="/usr/include/doctest", help="the folder of doctest.h")
    asked = parser.parse_args()
    if asked.score and (len(asked.lessons) < 7 or asked.function):
        parser.error("--score needs all lessons and functions")
    scores, faults = {}, 0
    with tempfile.TemporaryDirectory() as mine:
        for number in asked.lessons:
            folder = pathlib.Path(mine) / str(number)
            folder.mkdir()
            lesson = Lesson(number, asked, folder)
            scores[lesson.headers.name], more = try_lesson(lesson, listed())
            faults += more
    print(table(scores))
    if asked.score:
        page = pathlib.Path("docs/testing.md")
        marks = r"(<!-- mutation scores: begin.*?-->\n).*(<!-- mutation scores: end -->)"
        text = re.sub(marks, lambda mark: f"{mark[1]}\n{table(scores)}\n\n{mark[2]}", page.read_text(), flags=re.DOTALL)
        page.write_text(text)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
