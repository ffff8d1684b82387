"""Method of fundamental solutions for axisymmetric bodies: rings of Stokeslets.

A ring carries the force (f_rho cos m phi, f_phi sin m phi, f_z cos m phi); for m = 0 all
three are constant.  The velocity on the surfaces is met by least squares.  Nothing here
knows bispherical coordinates, reflections or lubrication.  Viscosity 1.  Needs numpy, scipy.
"""
import numpy as np
from scipy.linalg import lstsq


def oseen(x, y):
    """Velocity at x [n, 3] by unit forces at y [k, 3]: [n, k, 3, 3]."""
    d = x[:, None, :] - y[None, :, :]
    r = np.linalg.norm(d, axis=-1)[..., None, None]
    return (np.eye(3) / r + d[..., :, None] * d[..., None, :] / r**3) / (8 * np.pi)


def blake(x, y):
    """The same above a no-slip plane z = 0: Blake (1971), Proc. Camb. Phil. Soc. 70, 303."""
    big = x[:, None, :] - (y * np.array([1, 1, -1]))[None, :, :]
    h = y[None, :, 2, None, None]
    r = np.linalg.norm(big, axis=-1)[..., None, None]
    delta, e3 = np.eye(3), np.array([[0], [0], [1]])
    ri, rk, rz = big[..., :, None], big[..., None, :], big[..., 2, None, None]
    # d/dR_k of h R_i/R^3 and of delta_i3/R + R_i R_3/R^3
    dipole = h * (delta / r**3 - 3 * ri * rk / r**5)
    stresslet = (-e3 * rk + delta * rz + ri * e3.T) / r**3 - 3 * ri * rz * rk / r**5
    image = -oseen(x, y * np.array([1, 1, -1]))
    return oseen(x, y) + image + h * np.array([1, 1, -1]) * (dipole - stresslet) / (4 * np.pi)


class Sphere:
    def __init__(self, radius, height, focus):
        """`focus`: distance from the centre to where the images pile up."""
        self.radius, self.height = radius, height
        self.inner = 0.5 * (radius + focus)

    def rings(self, count, radius):
        theta = np.pi * (np.arange(count) + 0.5) / count
        return np.stack([radius * np.sin(theta), self.height + radius * np.cos(theta)], 1)


class Rings:
    """All sources of one azimuthal mode, and the points where the velocity is prescribed."""

    def __init__(self, spheres, mode, kernel, count, azimuths=160):
        self.mode, self.kernel = mode, kernel
        self.sources = np.concatenate([s.rings(count, s.inner) for s in spheres])
        self.owner = np.repeat(np.arange(len(spheres)), count)
        self.phi = 2 * np.pi * (np.arange(azimuths) + 0.5) / azimuths
        self.surface = np.concatenate([s.rings(2 * count, s.radius) for s in spheres])
        self.on = np.repeat(np.arange(len(spheres)), 2 * count)
        self.check = np.concatenate([s.rings(2 * count + 13, s.radius) for s in spheres])
        self.check_on = np.repeat(np.arange(len(spheres)), 2 * count + 13)

    def basis(self, phi):
        """Columns: the force of a ring at phi for unit (f_rho, f_phi, f_z)."""
        c, s = np.cos(phi), np.sin(phi)
        cm, sm = (c, s) if self.mode else (1.0, 1.0)
        return np.array([[c * cm, -s * sm, 0], [s * cm, c * sm, 0], [0, 0, cm]])

    def positions(self, phi):
        rho, z = self.sources.T
        return np.stack([rho * np.cos(phi), rho * np.sin(phi), z], 1)

    def matrix(self, points):
        rho, z = points.T
        zero = 0 * rho
        plane = np.stack([rho, zero, z], 1)                 # u_rho, u_z (and u_phi, m = 0)
        side = np.stack([zero, rho, z], 1) if self.mode else plane
        e_phi = np.array([-1, 0, 0]) if self.mode else np.array([0, 1, 0])
        rows = np.zeros((len(points), 3, len(self.sources), 3))
        for phi in self.phi:
            y, b = self.positions(phi), self.basis(phi)
            front = self.kernel(plane, y) @ b
            rows[:, 0] += front[:, :, 0]
            rows[:, 2] += front[:, :, 2]
            rows[:, 1] += np.einsum("i,nkij->nkj", e_phi, self.kernel(side, y) @ b)
        return rows.reshape(3 * len(points), -1)

    def solve(self, motions):
        """motions: functions (rho, z, owner) -> (u_rho, u_phi, u_z) amplitudes."""
        wanted = lambda points, on: np.stack(
            [np.stack(np.broadcast_arrays(*m(*points.T, on)), 1).ravel() for m in motions], 1)
        rhs = wanted(self.surface, self.on).astype(float)
        self.found = lstsq(self.matrix(self.surface), rhs, cond=1e-15)[0]
        error = self.matrix(self.check) @ self.found - wanted(self.check, self.check_on)
        return np.max(np.abs(error))

    def force_and_torque(self, motion, owner, centre):
        """Of one sphere on the liquid, torque about (0, 0, centre)."""
        mine = self.owner == owner
        f = self.found[:, motion].reshape(-1, 3)[mine]
        force, torque = np.zeros(3), np.zeros(3)
        for phi in self.phi:
            each = f @ self.basis(phi).T
            arm = self.positions(phi)[mine] - np.array([0, 0, centre])
            force += each.sum(0)
            torque += np.cross(arm, each).sum(0)
        return force, torque
