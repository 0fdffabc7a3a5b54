#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Simulates `mpirun -n N dewbow render`: when does rank 0 become the limit?

The model, event by event: each rank loads the scene, asks for two leases, renders one with all its
threads, sends the sums of its tiles, and asks again. Rank 0 deals as render/farm/dealer.cpp does (the
same constants) and serves one letter at a time. Tiles take lognormal times. Left out: leases that
are dealt again, the picture's encoding, and contention in the network.

docs/scaling.md says where the default costs were measured.
"""
import argparse
import heapq
import math
import random

ROUNDS, TILES_PER_THREAD, MOST_PASSES = 4, 4, 256  # dealer.cpp


class Dealer:
    def __init__(self, passes, tiles, threads):
        self.passes, self.tiles, self.threads = passes, tiles, threads
        self.first = self.end = self.next_tile = 0

    def units_a_thread(self):
        left = (self.passes - self.first) * self.tiles - self.next_tile
        return max(left // (ROUNDS * self.threads), 1)

    def deal(self, rank_threads):
        """(tiles, passes) of the next lease, or None."""
        if self.next_tile == self.tiles or self.first == self.end:
            if self.end >= self.passes:
                return None
            self.first, self.next_tile = self.end, 0
            doubled = min(max(self.first, 1), MOST_PASSES)
            self.end = min(self.first + min(doubled, self.units_a_thread()), self.passes)
        depth = self.end - self.first
        wanted = min(max(self.units_a_thread() // depth, 1), TILES_PER_THREAD) * rank_threads
        tiles = min(wanted, self.tiles - self.next_tile)
        self.next_tile += tiles
        return tiles, depth


def simulate(a, ranks, rng):
    """Returns (wall s, busy s of rank 0, tiles sent)."""
    tiles = math.ceil(a.width / 16) * math.ceil(a.height / 16)
    passes = math.ceil(a.spp / 4)
    dealer = Dealer(passes, tiles, ranks * a.threads)
    tile_bytes = 256 * (128 + 8 * a.bins)
    spread = math.sqrt(math.log(1 + a.variation**2))
    letters = []  # (time of arrival, rank, tiles of the result)
    for rank in range(ranks):
        loaded = a.load * (1 + 0.1 * rng.random())
        heapq.heappush(letters, (loaded, rank, 0))
        heapq.heappush(letters, (loaded, rank, 0))
    free_at = [0.0] * ranks
    server = busy = last = 0.0
    sent = 0
    while letters:
        arrival, rank, result_tiles = heapq.heappop(letters)
        service = a.letter + result_tiles * max(a.tile, tile_bytes / a.bandwidth)
        server = max(server, arrival) + service
        busy += service
        sent += result_tiles
        last = server
        lease = dealer.deal(a.threads)
        if lease is None:
            continue
        n, depth = lease
        # The thread that is last ends the lease: the largest of `threads` sums.
        rounds = math.ceil(n / a.threads)
        mean = depth * a.unit * rounds
        sigma = spread / math.sqrt(depth * rounds)
        slowest = math.sqrt(2 * math.log(max(min(a.threads, n), 2)))
        start = max(server + a.latency, free_at[rank], a.load)
        free_at[rank] = start + mean * math.exp(sigma * slowest - sigma**2 / 2)
        heapq.heappush(letters, (free_at[rank] + a.latency, rank, n))
    return last, busy, sent


def main():
    p = argparse.ArgumentParser(description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--ranks", type=int, nargs="+", default=[1, 64, 1024, 16384])
    p.add_argument("--threads", type=int, default=16, help="of a rank")
    p.add_argument("--width", type=int, default=3840)
    p.add_argument("--height", type=int, default=2160)
    p.add_argument("--spp", type=int, default=4096)
    p.add_argument("--bins", type=int, default=0)
    p.add_argument("--unit", type=float, default=3.9e-3, help="CPU s of a unit")
    p.add_argument("--variation", type=float, default=1.0,
                   help="standard deviation over mean of a unit's time")
    p.add_argument("--tile", type=float, default=0.064e-3, help="CPU s of rank 0 for a tile's sums")
    p.add_argument("--letter", type=float, default=20e-6, help="s of rank 0 for a letter")
    p.add_argument("--bandwidth", type=float, default=1.25e9, help="bytes/s into rank 0")
    p.add_argument("--latency", type=float, default=50e-6, help="s")
    p.add_argument("--load", type=float, default=1.0, help="s from start to the first letter")
    a = p.parse_args()
    units = math.ceil(a.width / 16) * math.ceil(a.height / 16) * math.ceil(a.spp / 4)
    print(f"{units} units, {units * a.unit:.0f} CPU s, {256 * (128 + 8 * a.bins)} bytes a tile")
    print(" ranks  wall s  ideal s  efficiency  rank 0 busy  GB received")
    for ranks in a.ranks:
        wall, busy, sent = simulate(a, ranks, random.Random(1))
        ideal = units * a.unit / (ranks * a.threads)
        print(f"{ranks:6} {wall:7.1f} {ideal:8.2f} {ideal / wall:10.1%} {busy / wall:11.1%}"
              f" {sent * 256 * (128 + 8 * a.bins) / 1e9:11.1f}")


if __name__ == "__main__":
    main()
