"""Coscrew's operations computed by other libraries, in coscrew's conventions and layouts.

Every function takes rows of inputs, (n, *shape), and returns rows of results.  A library that is
not installed is named in `missing`.
"""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import version
from types import ModuleType

import numpy as np

Function = Callable[..., np.ndarray]


@dataclass(frozen=True)
class Peer:
    """A library, its version, and its functions by the name of our operation."""

    name: str
    version: str
    functions: dict[str, Function]


def peers() -> tuple[tuple[Peer, ...], tuple[str, ...]]:
    """(installed libraries, names of those that are not installed)."""
    result, missing = [], []
    for name, distribution, module, table in _KNOWN:
        try:
            imported = importlib.import_module(module)
        except ImportError:
            missing.append(name)
        else:
            result.append(Peer(name, version(distribution), table(imported)))
    return tuple(result), tuple(missing)


def _by_row(function: Function) -> Function:
    """A function of one row, on all."""
    return lambda *inputs: np.array([function(*row) for row in zip(*inputs, strict=True)])


def _scalar_first(q: np.ndarray) -> np.ndarray:
    """Quaternions (x, y, z, w) as (w, x, y, z)."""
    return np.roll(q, 1, axis=-1)


def _scalar_last(q: np.ndarray) -> np.ndarray:
    return np.roll(q, -1, axis=-1)


def _swapped(s: np.ndarray) -> np.ndarray:
    """The halves of each row exchanged."""
    return np.roll(s, 3, axis=-1)


def _homogeneous(D: np.ndarray) -> np.ndarray:
    bottom = np.broadcast_to([[0.0, 0, 0, 1]], (*D.shape[:-2], 1, 4))
    return np.concatenate([D, bottom], axis=-2)


def _numpy(np_: ModuleType) -> dict[str, Function]:
    def norm(v: np.ndarray) -> np.ndarray:
        return np_.linalg.norm(v, axis=-1)

    def angle(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np_.arccos(np_.clip((a * b).sum(-1) / (norm(a) * norm(b)), -1, 1))

    return {"vec3_l2norm": norm, "vec3_normalized": lambda v: v / norm(v)[:, None],
            "angle_vv": angle}


def _scipy(scipy: ModuleType) -> dict[str, Function]:
    linalg = importlib.import_module("scipy.linalg")
    transform = importlib.import_module("scipy.spatial.transform")
    Rotation, Slerp = transform.Rotation, transform.Slerp

    def slerp(p: np.ndarray, q: np.ndarray, k: float) -> np.ndarray:
        ends = Rotation.from_quat([p, q])
        return Slerp([0, 1], ends)(k).as_quat()

    functions = {
        "vec3_l2norm": _by_row(linalg.norm),
        "vec3_normalized": _by_row(lambda v: v / linalg.norm(v)),
        "SO3_exp": lambda v: Rotation.from_rotvec(v).as_matrix(),
        "SO3_log": lambda R: Rotation.from_matrix(R).as_rotvec(),
        "quaternion_exp": lambda v: Rotation.from_rotvec(v).as_quat(),
        "quaternion_log": lambda q: Rotation.from_quat(q).as_rotvec(),
        "mat3x3_from_quaternion": lambda q: Rotation.from_quat(q).as_matrix(),
        "quaternion_from_mat3x3": lambda R: Rotation.from_matrix(R).as_quat(),
        "quaternion_interpolated": _by_row(slerp)}
    if hasattr(transform, "RigidTransform"):
        rigid = transform.RigidTransform
        functions["SE3_exp"] = lambda s: rigid.from_exp_coords(_swapped(s)).as_matrix()[:, :3]
        functions["SE3_log"] = lambda D: _swapped(
            rigid.from_matrix(_homogeneous(D)).as_exp_coords())
    return functions


def _pinocchio(pin: ModuleType) -> dict[str, Function]:
    """Pinocchio's Jacobians are right Jacobians; those of logarithms take the rotation or
    displacement."""

    def displaced(D: np.ndarray) -> object:
        return pin.SE3(np.ascontiguousarray(D[:, :3]), D[:, 3].copy())

    return {
        "SO3_exp": _by_row(pin.exp3), "SO3_log": _by_row(pin.log3),
        "SO3_rightJacobian": _by_row(pin.Jexp3), "SE3_rightJacobian": _by_row(
            lambda s: pin.Jexp6(pin.Motion(s))),
        "SO3_rightJacobianInverse": _by_row(lambda v: pin.Jlog3(pin.exp3(v))),
        "SE3_rightJacobianInverse": _by_row(lambda s: pin.Jlog6(pin.exp6(pin.Motion(s)))),
        "quaternion_exp": _by_row(lambda v: np.array(pin.exp3_quat(v))),
        "SE3_exp": _by_row(lambda s: pin.exp6(pin.Motion(s)).homogeneous[:3]),
        "SE3_log": _by_row(lambda D: pin.log6(displaced(D)).vector),
        "mat3x3_from_quaternion": _by_row(
            lambda q: pin.Quaternion(q).toRotationMatrix()),
        "quaternion_from_mat3x3": _by_row(lambda R: pin.Quaternion(R).coeffs()),
        "quaternion_interpolated": _by_row(lambda p, q, k: pin.Quaternion(p).slerp(
            float(k), pin.Quaternion(q)).coeffs())}


def _spatialmath(base: ModuleType) -> dict[str, Function]:
    return {
        "SO3_exp": _by_row(base.trexp),
        "SO3_log": _by_row(lambda R: base.trlog(R, check=False, twist=True)),
        "SE3_exp": _by_row(lambda s: base.trexp(s)[:3]),
        "SE3_log": _by_row(lambda T: base.trlog(_homogeneous(T), check=False, twist=True)),
        "mat3x3_from_quaternion": _by_row(lambda q: base.q2r(_scalar_first(q))),
        "quaternion_from_mat3x3": _by_row(lambda R: _scalar_last(base.r2q(R, check=False))),
        "quaternion_interpolated": _by_row(lambda p, q, k: _scalar_last(base.qslerp(
            _scalar_first(p), _scalar_first(q), k, shortest=True)))}


def _jaxlie(jaxlie: ModuleType) -> dict[str, Function]:
    jax = importlib.import_module("jax")
    jax.config.update("jax_platforms", "cpu")
    jax.config.update("jax_enable_x64", True)
    SO3, SE3 = jaxlie.SO3, jaxlie.SE3

    def rows(function: Function) -> Function:
        mapped = jax.jit(jax.vmap(function))
        return lambda *inputs: np.asarray(mapped(*inputs))

    def scalar_first(q: object) -> object:
        return jax.numpy.roll(q, 1)

    def scalar_last(q: object) -> object:
        return jax.numpy.roll(q, -1)

    return {
        "SO3_exp": rows(lambda v: SO3.exp(v).as_matrix()),
        "SO3_log": rows(lambda R: SO3.from_matrix(R).log()),
        "quaternion_exp": rows(lambda v: scalar_last(SO3.exp(v).wxyz)),
        "quaternion_log": rows(lambda q: SO3(scalar_first(q)).log()),
        "mat3x3_from_quaternion": rows(lambda q: SO3(scalar_first(q)).as_matrix()),
        "quaternion_from_mat3x3": rows(lambda R: scalar_last(SO3.from_matrix(R).wxyz)),
        "SO3_rightJacobianInverse": rows(lambda v: SO3.exp(v).jlog()),
        "SE3_rightJacobianInverse": rows(lambda s: SE3.exp(s).jlog()),
        "SE3_exp": rows(lambda s: SE3.exp(s).as_matrix()[:3]),
        "SE3_log": lambda D: rows(lambda T: SE3.from_matrix(T).log())(_homogeneous(D))}


_KNOWN: tuple[tuple[str, str, str, Callable[[ModuleType], dict[str, Function]]], ...] = (
    ("NumPy", "numpy", "numpy", _numpy),
    ("SciPy", "scipy", "scipy", _scipy),
    ("Pinocchio", "pin", "pinocchio", _pinocchio),
    ("jaxlie", "jaxlie", "jaxlie", _jaxlie),
    ("spatialmath", "spatialmath-python", "spatialmath.base", _spatialmath))
