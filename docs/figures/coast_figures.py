# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Measures surfaces of the sea over simple beds and draws coast_*.png: see scripts/coast-figures.

Everything is measured in the surface that hosts receive, by regions and queries; the laws beside it
are evaluated here, apart from the library. Bars are twice the standard error over independent
realisations (seeds of the sea).
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np

import libocean

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = Path(__file__).parent
GRAVITY = 9.81
CELL = 4.0
ROWS = 280
INK, LAW, MARK = "#16324a", "#8a8f94", "#c8452d"

SEA = """libocean = 1
[grid]
resolution = {resolution}
patch_size = {patch}
[water]
depth = {depth}
[random]
seed = {seed}
[[waves]]
spectrum = "jonswap"
wind_speed = {wind}
fetch = {fetch}
wind_direction = {direction}
spreading = "hasselmann"
swell = {swell}
"""
WIND_SEA = {
    "resolution": 256,
    "patch": 1024.0,
    "depth": 20.0,
    "seed": 1,
    "wind": 12.0,
    "fetch": 150000.0,
    "direction": 0.0,
    "swell": 0.0,
}


def sea_over(depth_at, length, cell=CELL, rows=ROWS, text=SEA, **settings):
    """Returns a sea over a bed of depth_at(x) [m], uniform along y, which begins at (0, 0)."""
    values = {**WIND_SEA, **settings}
    sea = libocean.parse(text.format(**values))
    x = np.arange(0.0, length + cell, cell)
    bed = np.maximum(-values["depth"], -depth_at(x))
    sea.set_bed(np.tile(bed, (rows, 1)), origin=(0.0, 0.0), cell=cell)
    return sea


def wavenumber(omega, depth):
    """Returns k [rad/m] of omega^2 = g k tanh(k d), by Newton's method."""
    deep = omega * omega / GRAVITY
    k = np.maximum(deep, omega / np.sqrt(GRAVITY * depth))
    for _ in range(30):
        t = np.tanh(k * depth)
        k = k - (GRAVITY * k * t - omega**2) / (GRAVITY * (t + k * depth * (1 - t * t)))
    return k


def group_speed(omega, depth):
    k = wavenumber(omega, depth)
    return omega / k * (0.5 + k * depth / np.sinh(2 * k * depth))


def standard_error(values):
    """Returns mean and twice its standard error over the first axis."""
    values = np.asarray(values)
    return values.mean(0), 2 * values.std(0, ddof=1) / np.sqrt(len(values))


def save(figure, name):
    figure.savefig(FOLDER / f"coast_{name}.png", dpi=96, metadata={"Software": None})
    plt.close(figure)


def tell(*words):
    print(*words, flush=True)


# ---- heights


def thornton_guza(depth_at, height, sea, length):
    """Returns x and Hrms of [Thornton and Guza 1983] for one frequency: gamma 0.42, B 1, their
    weight of eq. 21; waves of the open sea's spread, whose directions turn by Snell."""
    omega = 2 * np.pi / sea.state["peak_period"]["resolved"]
    spread = np.radians(sea.state["directional_spread"]["resolved"])
    x = np.arange(0.0, length, 0.5)
    depths = np.maximum(depth_at(x), 0.6)
    k = wavenumber(omega, depths)
    cosine = np.sqrt(1 - (np.sin(spread) * k[0] / k) ** 2)
    speed = group_speed(omega, depths) * cosine
    flux, heights = height**2 / 8 * speed[0], []
    for d, c in zip(depths, speed, strict=True):
        h = np.sqrt(8 * flux / c)
        heights.append(h)
        ratio = (h / (0.42 * d)) ** 2
        loss = 3 * np.sqrt(np.pi) / 16 * omega / (2 * np.pi) * h**3 * ratio / d
        flux = max(flux - 0.5 * loss * (1 - (1 + ratio) ** -2.5), 1e-9)
    return x, np.array(heights)


def plane(run, depth=20.0):
    return lambda x: depth - x / run


def barred(x):
    """A bar with 1.6 m of water over it, a trough of 2.3 m behind."""
    return (
        20.0
        - x / 60.0
        - 1.7 * np.exp(-(((x - 1000.0) / 35.0) ** 2))
        + 0.35 * np.exp(-(((x - 1070.0) / 30.0) ** 2))
    )


def heights():
    """Hrms across beaches against Thornton and Guza, and its ratio to the depth."""
    beds = {
        "1:100": (plane(100.0), 2000.0),
        "1:30": (plane(30.0), 600.0),
        "1:15": (plane(15.0), 300.0),
        "bar": (barred, 1190.0),
    }
    figure, axes = plt.subplots(1, 5, figsize=(13.5, 3.2), layout="constrained")
    ratios = {}
    for axis, (name, (depth_at, length)) in zip(axes, beds.items(), strict=False):
        found, offshore = [], []
        for seed in range(1, 7):
            sea = sea_over(depth_at, length + 100.0, seed=seed)
            step = min(8.0, length / 75)
            square = total = 0.0
            for k in range(30):
                map_ = sea.region(
                    40.0 + 6.7 * k, (0.0, 64.0), (int(length / step) + 1, 120), step, ["height"]
                )["height"]
                square = square + (map_**2).mean(0)
                total = total + map_.mean(0)
            variance = square / 30 - (total / 30) ** 2
            rms = np.sqrt(8 * variance)
            at = step * np.arange(len(rms))
            wet = (depth_at(at) > 0.8) & (at > 70.0)  # the sea fades in over 64 m
            found.append(rms[wet])
            offshore.append(np.sqrt((rms[(at > 70) & (at < 100)] ** 2).mean()))
        mean, bar = standard_error(found)
        x, law = thornton_guza(depth_at, np.sqrt((np.array(offshore) ** 2).mean()), sea, length)
        at = at[wet]
        shown = slice(None, None, max(1, len(at) // 30))
        axis.plot(x - length, law, color=LAW, lw=2, label="Thornton & Guza 1983")
        axis.errorbar(
            at[shown] - length, mean[shown], bar[shown], fmt="o", ms=3, color=MARK, label="surface"
        )
        axis.fill_between(x - length, -0.16 * depth_at(x), 0, color="#e8dcc0", lw=0)
        axis.set(
            title=name, xlabel="m from the end", xlim=(max(-length, -900), 20), ylim=(-0.6, 2.6)
        )
        there = np.interp(at, x, law)
        near = depth_at(at) >= 1.0
        worst = np.abs(mean[near] / there[near] - 1)
        tell(
            f"heights {name}: Hrms against Thornton-Guza worst {100 * worst.max():.1f} %"
            f" at {depth_at(at[near][worst.argmax()]):.1f} m, rms"
            f" {100 * np.sqrt((worst**2).mean()):.1f} %;"
            f" error of the mean {100 * (bar / mean).max() / 2:.1f} %"
        )
        for depth in (2.0, 1.5, 1.0):
            if name == "bar":
                break
            each = [np.interp(-depth, -depth_at(at), one) / depth for one in found]
            ratio, error = standard_error(each)
            ratios.setdefault(depth, []).append((1 / float(name[2:]), ratio, error))
            tell(f"  Hrms/d at {depth} m: {ratio:.3f} +- {error:.3f}")
    axes[0].set_ylabel("Hrms [m]")
    axes[0].legend(frameon=False, fontsize=8)
    axis = axes[4]
    axis.axhspan(0.29, 0.55, color="#dfe9ee", label="Sallenger & Holman 1985")
    for depth, row in ratios.items():
        slope, ratio, error = np.array(row).T
        axis.errorbar(slope, ratio, error, fmt="o-", ms=4, label=f"{depth:g} m")
    axis.set(title="Hrms / depth", xlabel="slope", ylim=(0.2, 0.7))
    axis.legend(frameon=False, fontsize=8)
    save(figure, "heights")


# ---- wave vectors, directions and groups


def mapped_waves(sea, x, rows, seconds):
    """Returns the surface at labels [t, y, x] of a sea that repeats in y and in time."""
    step = x[1] - x[0]
    return np.stack(
        [
            sea.region(float(t), (x[0], 64.0), (len(x), rows), step, ["height"])["height"]
            for t in range(seconds)
        ]
    )


def waves():
    """Wave vectors, directions and group speeds on a beach of 1:40 against linear theory."""
    seconds, rows, run, angle = 256, 256, 40.0, 20.0
    looped = SEA.replace("[[waves]]", f"[time]\nloop_period = {seconds}.0\n[[waves]]", 1)
    x = np.arange(580.0, 780.0, 4.0)
    depths = 20.0 - (x + 2.0) / run  # between a column and the next
    columns = [int(np.abs(depths - d).argmin()) for d in (5, 4, 3, 2.5, 2, 1.5)]
    errors, turns, groups = [], [], []
    for seed in range(1, 4):
        sea = sea_over(plane(run), 900.0, text=looped, seed=seed, direction=angle, swell=1.0)
        peak = 2 * np.pi / sea.state["peak_period"]["resolved"]
        surface = mapped_waves(sea, x, rows, seconds)
        # exp(i (k y - omega t)): the transform over time is the inverse one.
        spectrum = np.fft.fft(np.fft.ifft(surface, axis=0), axis=1)
        omega = 2 * np.pi * np.fft.fftfreq(seconds)[:, None]
        along = 2 * np.pi * np.fft.fftfreq(rows, 4.0)[None, :]
        carrier = (omega > 0.75 * peak) & (omega < 1.6 * peak)
        analytic = np.fft.fft(
            np.fft.ifft(np.where(carrier[..., None], spectrum, 0), axis=1), axis=0
        )
        envelope = np.abs(analytic) ** 2
        envelope = np.fft.fft2(envelope - envelope.mean((0, 1)), axes=(0, 1))
        error, turn, group = [], [], []
        for i in columns:
            d = depths[i]
            cross = np.conj(spectrum[..., i]) * spectrum[..., i + 1]
            energy = np.where(carrier, np.abs(spectrum[..., i]) ** 2, 0)
            true = wavenumber(np.broadcast_to(np.maximum(omega, 0.2), energy.shape), d)
            across = np.sqrt(np.maximum(true**2 - along**2, 1e-6))
            energy = np.where(np.abs(along) < 0.8 * true, energy, 0)
            got = np.angle(cross) / 4.0
            error.append(np.sqrt((energy * ((got - across) / true) ** 2).sum() / energy.sum()))
            # The mean direction, by the sums that define it.
            theta = np.arctan2((energy * along).sum(), (energy * got).sum())
            snell = np.arctan2((energy * along).sum(), (energy * across).sum())
            turn.append(np.degrees([theta, snell]))
            i0, i1 = i - 3, i + 4
            lag = np.fft.ifft2(np.conj(envelope[..., i0]) * envelope[..., i1]).real
            t, y = np.unravel_index(lag.argmax(), lag.shape)
            a, b, c = lag[t - 1, y], lag[t, y], lag[(t + 1) % seconds, y]
            time = t + 0.5 * (a - c) / (a - 2 * b + c)
            speed = group_speed(np.broadcast_to(np.maximum(omega, 0.2), energy.shape), d)
            forward = (energy * speed * across / true).sum() / energy.sum()
            group.append([(x[i1] - x[i0]) / time, forward])
        errors.append(error)
        turns.append(turn)
        groups.append(group)
    at = depths[columns]
    error, error_bar = standard_error(errors)
    law = np.array(turns)[..., 1].mean(0)
    turn, turn_bar = standard_error(np.array(turns)[..., 0] - np.array(turns)[..., 1] + law)
    group, group_bar = standard_error(np.array(groups)[..., 0] / np.array(groups)[..., 1])
    for n, d in enumerate(at):
        tell(
            f"waves {d:.2f} m: wave vector {error[n]:.3f}, direction {turn[n]:.2f} of {law[n]:.2f}"
            f" degrees, groups {group[n]:.3f} +- {group_bar[n]:.3f}"
        )
    figure, axes = plt.subplots(1, 3, figsize=(10.5, 3.2), layout="constrained")
    axes[0].errorbar(at, error, error_bar, fmt="o", ms=4, color=MARK)
    axes[0].set(title="error of wave vectors", ylim=(0, 0.15))
    axes[1].plot(at, law, color=LAW, lw=2, label="Snell")
    axes[1].errorbar(at, turn, turn_bar, fmt="o", ms=4, color=MARK, label="surface")
    axes[1].set(title="mean direction [degrees]")
    axes[1].legend(frameon=False, fontsize=8)
    axes[2].axhline(1, color=LAW, lw=2)
    axes[2].errorbar(at, group, group_bar, fmt="o", ms=4, color=MARK)
    axes[2].set(title="speed of groups / linear theory", ylim=(0.5, 1.5))
    for axis in axes:
        axis.set(xlabel="depth [m]", xlim=(5.5, 1.0))
    save(figure, "waves")


# ---- shape


def shape_laws(ursell):
    """Returns skewness and asymmetry of [Ruessink 2012] eq. 9 and 10."""
    b = 0.857 / (1 + np.exp((-0.471 - np.log10(ursell)) / 0.297))
    psi = np.pi / 2 * (np.tanh(0.815 / ursell**0.672) - 1)
    return b * np.cos(psi), b * np.sin(psi)


def shape_of(series):
    """Returns Hrms, skewness and asymmetry of series [t, place], each over time, pooled."""
    series = series - series.mean(0)
    spectrum = np.fft.fft(series, axis=0)
    half = len(series) // 2
    spectrum[half:] = 0
    hilbert = 2 * np.fft.ifft(spectrum, axis=0).imag
    variance = (series**2).mean()
    # The mean cube of the Hilbert transform: negative where fronts are steep.
    cubes = np.array([(series**3).mean(), (hilbert**3).mean()])
    return np.array([np.sqrt(8 * variance), *(cubes / variance**1.5)])


def shape():
    """Skewness and asymmetry of the surface at fixed places, against Ruessink et al."""
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    ursell = np.logspace(-2, 1.2, 100)
    for axis, law in zip(axes, shape_laws(ursell), strict=True):
        axis.plot(ursell, law, color=LAW, lw=2, label="Ruessink et al. 2012")
        axis.fill_between(ursell, law - 0.17, law + 0.17, color="#e9ebec", lw=0)
    depths = np.array([8.0, 5.0, 3.0, 2.0, 1.5])
    for run, mark in ((100.0, "s"), (40.0, "o"), (20.0, "^")):
        found = []
        for seed in range(1, 5):
            sea = sea_over(
                plane(run), 20 * run + 100, resolution=128, patch=512.0, rows=160, seed=seed
            )
            omega = 2 * np.pi / sea.state["peak_period"]["resolved"]
            x, y = np.meshgrid((20.0 - depths) * run, 70.0 + 64.0 * np.arange(8))
            points = np.stack([x, y], -1).reshape(-1, 2)
            series = np.stack(
                [sea.query(points, 0.5 * n, foam=False)[:, 2] for n in range(512)]
            ).reshape(512, 8, len(depths))
            found.append([shape_of(series[:, :, n]) for n in range(len(depths))])
        mean, bar = standard_error(found)
        k = wavenumber(omega, depths)
        number = 0.75 * mean[:, 0] / np.sqrt(2) * k / (k * depths) ** 3
        laws = shape_laws(number)
        for n, axis in enumerate(axes):
            axis.errorbar(number, mean[:, 1 + n], bar[:, 1 + n], fmt=mark, ms=4, label=f"1:{run:g}")
        for n, d in enumerate(depths):
            tell(
                f"shape 1:{run:g} at {d} m, Ur {number[n]:.2f}: skewness {mean[n, 1]:.2f} +-"
                f" {bar[n, 1]:.2f} ({laws[0][n]:.2f}), asymmetry {mean[n, 2]:.2f} +-"
                f" {bar[n, 2]:.2f} ({laws[1][n]:.2f})"
            )
    for axis, name in zip(axes, ("skewness", "asymmetry"), strict=True):
        axis.set(title=name, xlabel="Ursell number", xscale="log")
        axis.legend(frameon=False, fontsize=8)
    save(figure, "shape")


# ---- run-up


def run_up():
    """The height that 2 % of the run-ups exceed, against Stockdon et al., in 12 cases."""
    figure, axis = plt.subplots(figsize=(4.2, 3.8), layout="constrained")
    worst = 0.0
    for wind, fetch, patch, mark in (
        (9.0, 8e4, 270.0, "o"),
        (12.0, 1.5e5, 512.0, "s"),
        (16.0, 4e5, 1180.0, "^"),
    ):
        for run in (10.0, 15.0, 30.0, 60.0):
            both = []
            for seed in range(1, 4):
                cell = max(4.0, patch / 74)
                sea = sea_over(
                    plane(run, 14.0),
                    18.5 * run,
                    cell=cell,
                    rows=int(patch / cell) + 34,
                    depth=14.0,
                    wind=wind,
                    fetch=fetch,
                    patch=patch,
                    resolution=64,
                    seed=seed,
                )
                period = sea.state["peak_period"]["resolved"]
                height = sea.state["significant_wave_height"]["resolved"]
                scale = np.sqrt(height * GRAVITY * period**2 / (2 * np.pi))
                law = 1.1 * (0.35 * scale / run + 0.5 * scale * np.sqrt(0.563 / run**2 + 0.004))
                z = np.linspace(-0.6, min(2.2 * law, 4.4), 24)
                y = 70.0 + patch * np.arange(6) / 6
                x, rows = np.meshgrid(14.0 * run + z * run, y)
                points = np.stack([x, rows], -1).reshape(-1, 2)
                line = []
                for n in range(int((20 + 0.8 * run) * 8)):
                    level = sea.query(points, 0.125 * period * n, foam=False)[:, 2]
                    deep = level.reshape(6, -1) - z
                    dry = (deep <= 0).argmax(1)
                    i = np.arange(6)
                    over = deep[i, dry - 1] / (deep[i, dry - 1] - deep[i, dry])
                    line.append(np.where(dry > 0, z[dry - 1] + over * (z[1] - z[0]), z[0]))
                line = np.array(line)
                tops = []
                for one in (line - line.mean()).T:
                    up = np.flatnonzero((one[:-1] < 0) & (one[1:] >= 0))
                    tops += [one[a:b].max() for a, b in zip(up, up[1:], strict=False)]
                both.append((np.quantile(np.array(tops) + line.mean(), 0.98), law))
            both = np.array(both)
            ratio, bar = standard_error(both[:, 0] / both[:, 1])
            law = both[:, 1].mean()
            worst = max(worst, abs(ratio - 1))
            axis.errorbar(law, ratio * law, bar * law, fmt=mark, ms=4, color=MARK)
            tell(
                f"run_up {wind:g} m/s, 1:{run:g}: R2 {ratio * law:.2f} m, {ratio:.2f} +- {bar:.2f}"
            )
    tell(f"run_up worst {worst:.2f}")
    limit = np.array([0, 5.0])
    axis.plot(limit, limit, color=LAW)
    axis.fill_between(limit, 0.8 * limit, 1.2 * limit, color="#e9ebec", lw=0)
    axis.set(
        title="2 % run-up [m]",
        xlabel="Stockdon et al. 2006",
        ylabel="surface",
        xlim=limit,
        ylim=limit,
    )
    save(figure, "run_up")


# ---- foam


def foam():
    """The share of the water that foam of breaking waves covers, by the depth."""
    # A height and a period leave the wind unknown: no whitecaps.
    windless = SEA.replace("wind_speed = {wind}\nfetch = {fetch}", "{height}", 1)
    figure, axis = plt.subplots(figsize=(4.8, 3.4), layout="constrained")
    edges = np.array([0.25, 0.5, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 14])
    for run in (100.0, 40.0, 20.0):
        found, shares = [], []
        for seed in range(1, 4):
            sea = sea_over(
                plane(run, 14.0),
                14 * run + 100,
                text=windless,
                height="significant_wave_height = 2.9\npeak_period = 7.4",
                depth=14.0,
                resolution=128,
                patch=512.0,
                rows=160,
                seed=seed,
            )
            step = max(3.0, run / 10)
            x = np.arange(70.0, 14.0 * run - 0.2 * run, step)
            cover = np.mean(
                [
                    sea.region(t, (70.0, 70.0), (len(x), 32), step, ["cover"])["cover"].mean(0)
                    for t in (20.0, 32.0, 44.0)
                ],
                axis=0,
            )
            depth = 14.0 - x / run
            belts = zip(edges, edges[1:], strict=False)
            found.append([cover[(depth >= a) & (depth < b)].mean() for a, b in belts])
            shares.append(
                [cover[(depth >= a) & (depth < b)].mean() for a, b in ((0, 4), (4, 8), (8, 14))]
            )
        mean, bar = standard_error(found)
        axis.errorbar(
            (edges[1:] + edges[:-1]) / 2, 100 * mean, 100 * bar, fmt="o-", ms=3, label=f"1:{run:g}"
        )
        share, error = standard_error(shares)
        tell(
            f"foam 1:{run:g} where d < 4 m, 4 to 8 m, deeper:",
            (100 * share).round(2),
            "+-",
            (100 * error).round(2),
        )
    axis.set(title="cover of surf foam [%]", xlabel="depth [m]", xlim=(10, 0), ylim=(0, None))
    axis.legend(frameon=False, fontsize=8)
    save(figure, "foam")


FIGURES = {"heights": heights, "waves": waves, "shape": shape, "run_up": run_up, "foam": foam}

if __name__ == "__main__":
    for name in sys.argv[1:] or FIGURES:
        if name not in FIGURES:
            sys.exit(f"there is no figure '{name}'; known: {', '.join(FIGURES)}")
        FIGURES[name]()
