#!/usr/bin/env python3
"""Tries mistakes that nobody has written down, by hand: puts each of a list into a folder, runs `glassbox learn test`, and
prints a table of what was said: named (rightly or wrongly), described, silent, does not compile, or passes. From the
project's root:

    tests/learn/try_mistakes.py [--glassbox build/bin/glassbox] [--list LIST.toml] [--only WORD] [--full]

A list is as tests/learn/mistakes_to_try.toml. What a change replaces must stand in the solution; else the mistake is left
out, and said to be. Exits with 1 if one is named wrongly or nothing is said of it."""
import argparse
import collections
import pathlib
import subprocess
import sys
import tempfile
import tomllib


def lesson_folder(root, number):
    return next((root / "lessons").glob(f"{number}-*"))


def in_one_line(text):
    return " ".join(text.split())


def changed_headers(core, headers, changes):
    """The solution's headers, by name, with each change made where its old text stands first; None if one does not."""
    texts = {name: (core / name).read_text() for name in headers}
    for header, old, new in changes:
        if old not in texts[header]:
            return None
        texts[header] = texts[header].replace(old, new, 1)
    return texts


def verdict(status, said, named, right):
    if status == 0:
        return "passes"
    if "does not compile" in said:
        return "does not compile"
    if named:
        return "rightly named" if set(named) <= set(right) else "WRONGLY NAMED"
    return "described" if "What the checks show:" in said else "SILENT"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--glassbox", default="build/bin/glassbox")
    parser.add_argument("--list", default="tests/learn/mistakes_to_try.toml")
    parser.add_argument("--only", default="", help="those whose name has this word")
    parser.add_argument("--full", action="store_true", help="print all that was said, too")
    asked = parser.parse_args()
    root = pathlib.Path.cwd()
    with open(asked.list, "rb") as file:
        tries = [one for one in tomllib.load(file)["try"] if asked.only in one["name"]]
    known = {}
    for path in (root / "lessons").glob("*/mistakes.toml"):
        for mistake in tomllib.loads(path.read_text())["mistake"]:
            known[in_one_line(mistake["looks_like"])] = mistake["name"]
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as mine:
        for one in tries:
            lesson = lesson_folder(root, one["lesson"])
            exercise = tomllib.loads((lesson / "exercise.toml").read_text())
            texts = changed_headers(root / exercise["core"], exercise["headers"], one["changes"])
            if texts is None:
                counts["left out"] += 1
                print(f"{'left out':17} {one['name']}: the solution has another text by now", flush=True)
                continue
            folder = pathlib.Path(mine) / lesson.name
            folder.mkdir(exist_ok=True)
            for name, text in texts.items():
                (folder / name).write_text(text)
            ran = subprocess.run([asked.glassbox, "learn", "test", str(one["lesson"]), "--folder", mine],
                                 capture_output=True, text=True)
            said = in_one_line(ran.stdout)
            named = [name for words, name in known.items() if words in said]
            kind = verdict(ran.returncode, said, named, one.get("named", []))
            counts[kind] += 1
            print(f"{kind:17} {one['name']}{': ' if named else ''}{', '.join(named)}", flush=True)
            if asked.full:
                print(ran.stdout)
    print(", ".join(f"{count} {kind}" for kind, count in counts.most_common()))
    return 1 if counts["WRONGLY NAMED"] or counts["SILENT"] else 0


if __name__ == "__main__":
    sys.exit(main())
