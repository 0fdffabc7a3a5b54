#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints an OpenCue job for slices of one picture: a layer of frames, and a merge that waits for it.

    opencue.py COUNT OUTPUT dewbow-render-arguments… > ring.xml
    cuesubmit or any OpenCue client then launches ring.xml.

Frame number K is slice K of COUNT: OpenCue puts it in the place of #IFRAME#. Names must be the same
on all hosts, so give whole paths.
"""
import argparse
import shlex
from xml.sax.saxutils import escape

RENDER = """slice={stem}.slice-#IFRAME#-of-{count}.dewbow; [ -e "$slice" ] && exit 0; \
resume=; [ -e "$slice.dewbow" ] && resume=--resume; \
exec {dewbow} render {arguments} --slice #IFRAME#/{count} -o "$slice" --progress plain \
--threads ${{CUE_THREADS:-1}} $resume"""

JOB = """<?xml version="1.0"?>
<!DOCTYPE spec PUBLIC "SPI Cue Specification Language" "http://localhost:8080/spcue/dtd/cjsl-1.12.dtd">
<spec>
  <facility>local</facility>
  <show>{show}</show>
  <shot>{shot}</shot>
  <user>{user}</user>
  <job name="dewbow">
    <paused>false</paused>
    <maxretries>2</maxretries>
    <autoeat>false</autoeat>
    <layers>
      <layer name="render" type="Render">
        <cmd>{render}</cmd>
        <range>1-{count}</range>
        <chunk>1</chunk>
        <cores>{cores}</cores>
        <threadable>true</threadable>
        <memory>{memory}g</memory>
        <services><service>shell</service></services>
      </layer>
      <layer name="merge" type="Util">
        <cmd>{merge}</cmd>
        <range>1</range>
        <chunk>1</chunk>
        <services><service>shell</service></services>
      </layer>
    </layers>
  </job>
  <depends>
    <depend type="LAYER_ON_LAYER" anyframe="false">
      <depjob>dewbow</depjob>
      <deplayer>merge</deplayer>
      <onjob>dewbow</onjob>
      <onlayer>render</onlayer>
    </depend>
  </depends>
</spec>
"""


def shell(command: str) -> str:
    return "/bin/sh -c " + shlex.quote(command)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--show", default="show")
    parser.add_argument("--shot", default="shot")
    parser.add_argument("--user", default="user")
    parser.add_argument("--cores", default="16")
    parser.add_argument("--memory", default="8", help="GiB")
    parser.add_argument("--dewbow", default="dewbow")
    parser.add_argument("count", type=int)
    parser.add_argument("output")
    parser.add_argument("arguments", nargs=argparse.REMAINDER)
    a = parser.parse_args()
    stem = shlex.quote(a.output.rsplit(".", 1)[0])
    render = RENDER.format(stem=stem, count=a.count, dewbow=shlex.quote(a.dewbow),
                           arguments=shlex.join(a.arguments))
    merge = (f"exec {shlex.quote(a.dewbow)} merge {stem}.slice-*-of-{a.count}.dewbow"
             f" -o {shlex.quote(a.output)}")
    print(JOB.format(show=escape(a.show), shot=escape(a.shot), user=escape(a.user), count=a.count,
                     cores=a.cores, memory=a.memory, render=escape(shell(render)),
                     merge=escape(shell(merge))), end="")


if __name__ == "__main__":
    main()
