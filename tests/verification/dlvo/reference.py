"""Energies and forces of MODEL (S2)-(S8) by integrals of first principles, not by formulas.

van der Waals, Born: the sums of r^-6 and r^-12 over both bodies, by quadrature.
Double layer, constant potential: the linear Poisson-Boltzmann equation between two plates,
    pressure from the potential and the field at an arbitrary plane, Derjaguin's integral.
Superposition: pressure of the two undisturbed layers, Derjaguin's integral.
Retarded: the r^-6 sum times Gregory's factor; for two spheres that is Derjaguin's integral
    of his flat-plate energy, for sphere and plate his closed form (no integral is behind it).
Forces: numerical derivative of the energy in 40 digits.  Needs mpmath.

    python3 reference.py > reference.csv
"""
from mpmath import mp, mpf, quad, exp, sinh, cosh, pi, inf, diff, sqrt, log

mp.dps = 40
KB, NA, E0, EPS0 = (mpf(x) for x in (
    "1.380649e-23", "6.02214076e23", "1.602176634e-19", "8.8541878128e-12"))
EPS_R = mpf("78.55")
SIGMA = mpf("0.5e-9")
LAMBDA = mpf("100e-9")


def debye(ionic, kelvin):
    return sqrt(EPS_R * EPS0 * KB * kelvin / (2 * NA * E0**2 * ionic))


def split(h, end):
    """Break points that follow an integrand which decays on the scale of h."""
    points, x = [h], h
    while x * 4 < end:
        x *= 4
        points.append(x)
    return points + [end]


def pairwise_plate(a, h, power):
    """Sum over a sphere of the sum over a half space of r^-power, times 1/pi^2."""
    half_space = {6: pi / 6, 12: pi / 45}[power]       # times z^-(power - 3)
    disc = lambda z: pi * (z - h) * (2 * a + h - z)     # section of the sphere at z
    f = lambda z: disc(z) * half_space / z**(power - 3)
    return quad(f, split(h, h + 2 * a)) / pi**2


def point_sphere(x, b, power):
    """Sum over a sphere of radius b of r^-power, seen from x + b."""
    if power == 6:
        return 4 * pi * b**3 / 3 / (x * (x + 2 * b))**3
    c = x + b  # shells of radius r about the point: pi r (b^2 - (c - r)^2) / c
    part = lambda r: (c**2 - b**2) / (10 * r**10) - 2 * c / (9 * r**9) + 1 / (8 * r**8)
    return pi / c * (part(c + b) - part(c - b))


def pairwise_spheres(a, b, h, power):
    c = a + b + h
    f = lambda x: pi * (x + b) / c * (a**2 - (c - x - b)**2) * point_sphere(x, b, power)
    return quad(f, split(h, h + 2 * a)) / pi**2


def derjaguin(pressure, radius, h, decay):
    """2 pi R times the flat-plate energy, itself the integral of the pressure."""
    f = lambda x: (x - h) * pressure(x)
    return 2 * pi * radius * quad(f, split(h, h + decay) + [h + 8 * decay, h + 120 * decay])


def constant_potential(radius, psi1, psi2, ionic, kelvin, h):
    k = 1 / debye(ionic, kelvin)

    def pressure(gap):
        x = mpf("0.37") * gap
        phi = (psi1 * sinh(k * (gap - x)) + psi2 * sinh(k * x)) / sinh(k * gap)
        field = k * (psi2 * cosh(k * x) - psi1 * cosh(k * (gap - x))) / sinh(k * gap)
        return EPS_R * EPS0 / 2 * (k**2 * phi**2 - field**2)
    return derjaguin(pressure, radius, h, 1 / k)


def superposition(radius, psi1, psi2, ionic, kelvin, h):
    k = 1 / debye(ionic, kelvin)

    def pressure(gap):
        x = gap / 3
        one, two = psi1 * exp(-k * x), psi2 * exp(-k * (gap - x))
        field = k * (two - one)
        return EPS_R * EPS0 / 2 * (k**2 * (one + two)**2 - field**2)
    return derjaguin(pressure, radius, h, 1 / k)


def retardation(h):
    """Gregory's flat plates, Derjaguin's integral, over the same without retardation."""
    plate = lambda x: 1 / (x**2 * (1 + mpf("5.32") * x / LAMBDA))
    return h * quad(plate, split(h, h * 4**40) + [inf])


def row(form, a, b, psi1, psi2, ionic, kelvin, energy, h):
    e, f = energy(h), -diff(energy, h, h=h / mpf(10)**12)
    fields = [a, b, psi1, psi2, ionic, kelvin, h]
    print(form, *(mp.nstr(x, 8) for x in fields), mp.nstr(e, 16), mp.nstr(f, 16), sep=",")


print("form,a_m,b_m,psi1_V,psi2_V,ionic_mol_m3,temperature_K,gap_m,energy,force")
# van der Waals and Born per unit Hamaker constant: energy/A [-], force/A [1/m].
for a, b in ((mpf("6.65e-6"), mpf("48.3e-6")), (mpf("10e-9"), mpf("10e-9")),
             (mpf("1e-3"), mpf("1e-6"))):
    for h in (mpf("0.3e-9"), mpf("13e-9"), mpf("2e-6")):
        row("hamaker_plate", a, inf, 0, 0, 0, 0, lambda x: -pairwise_plate(a, x, 6), h)
        row("hamaker_spheres", a, b, 0, 0, 0, 0, lambda x: -pairwise_spheres(a, b, x, 6), h)
        row("retarded_plate", a, inf, 0, 0, 0, 0,
            lambda x: -pairwise_plate(a, x, 6) / (1 + 14 * x / LAMBDA), h)
        row("retarded_spheres", a, b, 0, 0, 0, 0,
            lambda x: -pairwise_spheres(a, b, x, 6) * retardation(x), h)
    for h in (mpf("0.2e-9"), mpf("0.5e-9"), mpf("3e-9")):
        row("born_plate", a, inf, 0, 0, 0, 0,
            lambda x: SIGMA**6 * pairwise_plate(a, x, 12), h)
for a in (mpf("6.65e-6"),):
    for h in (mpf("0.2e-9"), mpf("0.5e-9")):
        row("born_spheres", a, a, 0, 0, 0, 0,
            lambda x: SIGMA**6 * pairwise_spheres(a, a, x, 12), h)
for psi1, psi2 in ((mpf("-27.9e-3"), mpf("-15.7e-3")), (mpf("40e-3"), mpf("-25e-3")),
                   (mpf("-20e-3"), mpf(0)), (mpf("30e-3"), mpf("30e-3"))):
    for ionic, kelvin in ((mpf(300), mpf(298)), (mpf("0.1"), mpf(275)), (mpf(5000), mpf(370))):
        for kh in (mpf("0.05"), mpf("0.7"), mpf(6)):
            h = mp.mpf(mp.nstr(kh * debye(ionic, kelvin), 8))
            a = mpf("6.65e-6")
            for form, f in (("constant_potential", constant_potential),
                            ("superposition", superposition)):
                row(form, a, inf, psi1, psi2, ionic, kelvin,
                    lambda x: f(a, psi1, psi2, ionic, kelvin, x), h)
