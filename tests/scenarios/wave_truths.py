"""True water to judge wave models by: potential flow with the full conditions at the surface, and exact shallow water.

Potential flow by the high-order spectral method (D. G. Dommermuth & D. K. P. Yue 1987, J. Fluid Mech. 184, 267; B. J. West
et al. 1987, J. Geophys. Res. 92, 11803): every power of the steepness up to `order`, all dispersion, periodic sides. It
holds until waves break. `python3 wave_truths.py` holds it to Stokes' waves and to Tadjbakhsh & Keller's.
"""
import math

import numpy

GRAVITY = 9.81


class PotentialFlow:
    """elevation and potential are at the surface, arrays of (rows, columns); one row where nothing changes along y."""

    def __init__(self, size_m, depth_m, elevation, potential, order=5):
        rows, columns = elevation.shape
        kx = 2 * math.pi / size_m[0] * numpy.fft.fftfreq(columns, 1 / columns)[None, :]
        ky = 2 * math.pi / size_m[1] * numpy.fft.fftfreq(rows, 1 / rows)[:, None]
        self.k = numpy.hypot(kx, ky)
        self.ikx, self.iky = 1j * kx, 1j * ky
        self.k_tanh = self.k * numpy.tanh(self.k * depth_m)
        # What products of several waves would fold back is left out.
        share = 2 / 3
        keep = abs(kx) <= share * abs(kx).max()
        if rows > 1:
            keep = keep & (abs(ky) <= share * abs(ky).max())
        self.keep = keep
        self.order = order
        self.elevation, self.potential = self.smooth(elevation), self.smooth(potential)

    def smooth(self, field):
        return numpy.fft.ifft2(numpy.fft.fft2(field) * self.keep).real

    def gradient(self, field):
        modes = numpy.fft.fft2(field)
        return numpy.fft.ifft2(self.ikx * modes).real, numpy.fft.ifft2(self.iky * modes).real

    def vertical_velocity(self, elevation, potential):
        """w at the surface, from the potential there."""
        powers = [numpy.ones_like(elevation)]
        for n in range(1, self.order + 1):
            powers.append(self.smooth(powers[-1] * elevation) / n)
        derivatives = []  # of the part of each order, at the level z = 0: all that is needed
        w = numpy.zeros_like(elevation)
        for m in range(self.order):
            part = potential if m == 0 else -sum(powers[n] * derivatives[m - n][n] for n in range(1, m + 1))
            modes = numpy.fft.fft2(part) * self.keep
            column = []
            for n in range(self.order - m + 1):
                factor = self.k ** n if n % 2 == 0 else self.k ** (n - 1) * self.k_tanh
                column.append(numpy.fft.ifft2(modes * factor).real)
            derivatives.append(column)
            w = w + sum(powers[n] * column[n + 1] for n in range(self.order - m))
        return w

    def rates(self, elevation, potential):
        ex, ey = self.gradient(elevation)
        px, py = self.gradient(potential)
        w = self.vertical_velocity(elevation, potential)
        steep = 1 + ex * ex + ey * ey
        return (self.smooth(steep * w - ex * px - ey * py),
                self.smooth(-GRAVITY * elevation - 0.5 * (px * px + py * py) + 0.5 * steep * w * w))

    def advance(self, duration_s):
        fastest = math.sqrt(GRAVITY * (self.k_tanh * self.keep).max())
        steps = max(1, math.ceil(duration_s * fastest / 0.5))
        dt = duration_s / steps
        e, p = self.elevation, self.potential
        for _ in range(steps):
            a = self.rates(e, p)
            b = self.rates(e + 0.5 * dt * a[0], p + 0.5 * dt * a[1])
            c = self.rates(e + 0.5 * dt * b[0], p + 0.5 * dt * b[1])
            d = self.rates(e + dt * c[0], p + dt * c[1])
            e = e + dt / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
            p = p + dt / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
            if not numpy.isfinite(e).all():
                raise ArithmeticError("the wave breaks")
        self.elevation, self.potential = e, p


def omega(k, depth_m):
    return math.sqrt(GRAVITY * k * math.tanh(k * depth_m))


def travelling(size_m, depth_m, waves, columns, order=5):
    """Sines that run along x, (amplitude, wave number, phase): each with the potential of its linear wave at the surface."""
    x = (numpy.arange(columns) + 0.5) * size_m / columns
    elevation = sum(a * numpy.cos(k * x + phase) for a, k, phase in waves)
    potential = 0
    for a, k, phase in waves:
        # cosh k (z + h) / sinh k h, without overflow
        grown = (numpy.exp(k * elevation) + numpy.exp(-k * (elevation + 2 * depth_m))) / (1 - math.exp(-2 * k * depth_m))
        potential = potential + a * omega(k, depth_m) / k * grown * numpy.sin(k * x + phase)
    return PotentialFlow((size_m, 1), depth_m, elevation[None, :], potential[None, :], order)


def still(size_m, depth_m, elevation, order=5):
    return PotentialFlow(size_m, depth_m, elevation, numpy.zeros_like(elevation), order)


def sampled(flow, size_m, x, y):
    """The elevation at places that form a lattice, by its own series."""
    modes = numpy.fft.fft2(flow.elevation)
    rows, columns = flow.elevation.shape
    dx, dy = size_m[0] / columns, size_m[1] / rows
    at_x = numpy.exp(numpy.outer(flow.ikx[0], x - 0.5 * dx)) / columns
    at_y = numpy.exp(numpy.outer(flow.iky[:, 0], y - 0.5 * dy)) / rows
    return (at_y.T @ modes @ at_x).real


def solitary(size_m, depth_m, height_m, crest_m, columns):
    """A solitary wave between walls, as shallow water has it: its image runs the other way in the mirrored channel."""
    x = (numpy.arange(2 * columns) + 0.5) * size_m / columns
    kappa, c = math.sqrt(0.75 * height_m / depth_m**3), math.sqrt(GRAVITY * (depth_m + height_m))
    elevation = height_m * (numpy.cosh(kappa * (x - crest_m)) ** -2 +
                            numpy.cosh(numpy.minimum(kappa * abs(2 * size_m - crest_m - x), 300)) ** -2)
    speed = c * elevation / (depth_m + elevation) * numpy.sign(size_m - x)
    # The potential of that speed; its sum round the channel is zero.
    modes = numpy.fft.fft(speed)
    k = 2 * math.pi / (2 * size_m) * numpy.fft.fftfreq(2 * columns, 1 / (2 * columns))
    potential = numpy.fft.ifft(numpy.where(k == 0, 0, modes / numpy.where(k == 0, 1, 1j * k))).real
    return PotentialFlow((2 * size_m, 1), depth_m, elevation[None, :], potential[None, :])


def ritter(x, t, depth_m):
    """Depth of a dam break over dry ground, the dam at x = 0."""
    c = math.sqrt(GRAVITY * depth_m)
    fan = numpy.clip(2 / 3 * c - x / (3 * t), 0, c) ** 2 / GRAVITY
    return numpy.where(x < -c * t, depth_m, numpy.where(x > 2 * c * t, 0, fan))


def stoker(x, t, left_m, right_m):
    """Depth of a dam break over water, the dam at x = 0: a fan, a level between, a bore."""
    low, high = right_m, left_m
    for _ in range(200):
        h = 0.5 * (low + high)
        fan_speed = 2 * (math.sqrt(GRAVITY * left_m) - math.sqrt(GRAVITY * h))
        bore_speed = (h - right_m) * math.sqrt(0.5 * GRAVITY * (1 / h + 1 / right_m))
        low, high = (h, high) if fan_speed > bore_speed else (low, h)
    u, bore = fan_speed, fan_speed * h / (h - right_m)
    c = math.sqrt(GRAVITY * left_m)
    fan = numpy.clip(2 / 3 * c - x / (3 * t), 0, c) ** 2 / GRAVITY
    tail = u - math.sqrt(GRAVITY * h)
    return numpy.where(x < -c * t, left_m, numpy.where(x < tail * t, fan, numpy.where(x < bore * t, h, right_m)))


def thacker(x, y, t, a, h0, eta):
    """Elevation above the bowl's still water, where it is wet, and the bowl's ground."""
    w = math.sqrt(2 * GRAVITY * h0) / a
    ground = h0 * ((x * x + y * y) / (a * a) - 1)
    level = eta * h0 / (a * a) * (2 * x * math.cos(w * t) + 2 * y * math.sin(w * t) - eta)
    return numpy.maximum(level, ground), ground


def main():
    """The frequency of steep waves, from their phase after ten periods, against the books."""
    cases = []
    for kh, ka in ((20.0, 0.1), (1.0, 0.05)):
        t2 = math.tanh(kh) ** 2
        cases.append(("travelling", kh, ka, ka * ka * (9 - 10 * t2 + 9 * t2 * t2) / (16 * t2 * t2)))
    for kh, ka in ((20.0, 0.1), (0.8, 0.05)):
        t = math.tanh(kh)
        cases.append(("standing", kh, ka, ka * ka * (9 / t**4 - 12 / t**2 - 3 - 2 * t * t) / 64))
    worst = 0
    for kind, kh, ka, expected in cases:
        k, depth, length = 1.0, kh, 2 * math.pi
        x = (numpy.arange(64) + 0.5) * length / 64
        flow = (travelling(length, depth, [(ka, k, 0)], 64) if kind == "travelling"
                else still((length, 1), depth, ka * numpy.cos(x)[None, :]))
        period, periods, phases = 2 * math.pi / omega(k, depth), 10, []
        for quarter in range(4 * periods + 1):
            mode = numpy.fft.fft(flow.elevation[0])[1] * numpy.exp(-1j * k * x[0])
            rate = numpy.fft.fft(flow.rates(flow.elevation, flow.potential)[0][0])[1] * numpy.exp(-1j * k * x[0])
            phases.append(-numpy.angle(mode) if kind == "travelling"
                          else math.atan2(-rate.real / omega(k, depth), mode.real))
            if quarter < 4 * periods:
                flow.advance(period / 4)
        turned = numpy.unwrap(phases)
        measured = (turned[-1] - turned[0]) / (2 * math.pi * periods) - 1
        worst = max(worst, abs(measured / expected - 1))
        print(f"{kind:10} kh {kh:4g} ka {ka:4g}: frequency {measured:+.3e} of Airy's, third order {expected:+.3e}")
    return int(worst > 0.15)


if __name__ == "__main__":
    raise SystemExit(main())
