#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the jobs of `bspline_curve batch JOBS.csv` on a Dask cluster, one task per job, and writes the same results file.

    run_on_dask.py JOBS.csv --scheduler tcp://host:8786     # a cluster that is there
    run_on_dask.py JOBS.csv --workers 4                     # so many processes on this machine

Every machine must see the same files, and the program, under the same paths.
"""

import argparse
import csv
import io
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from dask.distributed import Client, LocalCluster, as_completed

HEADER = (
    "job mesh picks output status seconds usable length max_distance vertices peak_memory_bytes message command".split()
)


def jobs_of(program, jobs, *options):
    """{command: number} of the jobs of a file, as the program checks and lists them."""
    listed = subprocess.run([program, "batch", jobs, "--dry-run", *options], capture_output=True, text=True)
    if listed.returncode != 0:
        sys.exit(listed.stderr.strip())
    return {command: int(number) for command, number in re.findall(r"^(.*)  # job (\d+)$", listed.stdout, re.M)}


def run_job(program, jobs, number):
    """The line of one job's results; runs on a worker."""
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.csv"
        ended = subprocess.run(
            [program, "batch", jobs, "--only", str(number), "--jobs", "1", "--results", str(results)],
            capture_output=True,
            text=True,
        )
        lines = results.read_text().splitlines() if results.exists() else []
        if len(lines) != 2:
            raise RuntimeError(f"job {number} left no result: {ended.stderr.strip() or ended.returncode}")
        return lines[1]


def line_of(row):
    text = io.StringIO()
    csv.DictWriter(text, HEADER, lineterminator="\n").writerow(row)
    return text.getvalue()


def kept_lines(results, every, left):
    """The lines of an earlier run that stay: of jobs that are not to be run again, with their present numbers."""
    with open(results, newline="") as stream:
        rows = {row["command"]: row for row in csv.DictReader(stream) if None not in row.values()}
    return [line_of(rows[command] | {"job": number}) for command, number in every.items() if command not in left]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("jobs", type=Path, help="CSV of jobs, as for bspline_curve batch")
    parser.add_argument("--program", default="bspline_curve", help="the program, as the workers find it")
    parser.add_argument("--results", type=Path, help="CSV to write; default: JOBS with the extension .results.csv")
    parser.add_argument("--resume", action="store_true", help="do not run again what the results say is done")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--scheduler", help="address of the cluster")
    where.add_argument("--workers", type=int, default=os.cpu_count(), help="processes on this machine, without a cluster")
    arguments = parser.parse_args()
    arguments.results = arguments.results or arguments.jobs.with_suffix(".results.csv")
    if os.sep in arguments.program:
        arguments.program = os.path.abspath(arguments.program)
    return arguments


def plan(arguments):
    """The numbers of the jobs to run, and the lines of results that stay."""
    jobs, results = str(arguments.jobs.resolve()), arguments.results
    every = jobs_of(arguments.program, jobs)
    if not results.exists():
        return list(every.values()), []
    if not arguments.resume:
        sys.exit(f"{results}: is there already; --resume goes on with it, --results names another")
    left = jobs_of(arguments.program, jobs, "--resume", "--results", str(results.resolve()))
    return list(left.values()), kept_lines(results, every, left)


def main():
    arguments = parse_arguments()
    numbers, kept = plan(arguments)
    cluster = arguments.scheduler or LocalCluster(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None)
    failed = []
    with Client(cluster) as client:
        beginning = arguments.results.with_name(arguments.results.name + ".new")
        beginning.write_text(",".join(HEADER) + "\n" + "".join(kept))
        beginning.replace(arguments.results)
        jobs = str(arguments.jobs.resolve())
        tasks = {client.submit(run_job, arguments.program, jobs, number, pure=False): number for number in numbers}
        with open(arguments.results, "a") as results:
            for task in as_completed(tasks):
                if task.status != "finished":
                    print(f"job {tasks[task]}: {task.exception()}", file=sys.stderr)
                    failed.append(tasks[task])
                    continue
                line = task.result()
                results.write(line + "\n")
                results.flush()
                os.fsync(results.fileno())
                (row,) = csv.DictReader([line], HEADER)
                if row["status"] != "done":
                    failed.append(tasks[task])
                print(f"{len(numbers)} jobs: job {row['job']} {row['status']} {row['message']}".rstrip())
    if failed:
        sys.exit(f"{len(failed)} of {len(numbers)} jobs failed: {sorted(failed)}; {arguments.results} says why")


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("interrupted; --resume goes on")
