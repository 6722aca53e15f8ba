"""Writes a sweep as Zarr from its Parquet files, and opens it as a Dataset of xarray.

In Zarr the members are one dimension; xarray sees the grids as dimensions of their own:

    sweep = opened("folder")
    sweep["q.elbow.final"].sel({"payload.mass": 5}).mean("sample")"""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow

from coscrew_codegen.simulation.plan import Plan
from coscrew_codegen.simulation.sweep import SweepError
from coscrew_codegen.simulation.sweep.files.about import SPECIFICATION, read_description
from coscrew_codegen.simulation.sweep.files.folder import MEMBERS, ZARR, Folder, part_of, whole
from coscrew_codegen.simulation.sweep.files.part import read, reading
from coscrew_codegen.simulation.sweep.files.quarantine import make_way, remove
from coscrew_codegen.simulation.sweep.member_summary import FAILED, MEMBER

if TYPE_CHECKING:
    import xarray
    import zarr

_ROWS = 65536  # most members in a chunk of an array, about
_WORDS = {f"{FAILED}.cause": FAILED, f"{FAILED}.joint": f"{FAILED}.joint"}
"""Names, and columns of text that only the Parquet files have."""


def write(folder: Folder, about: Mapping[str, str], plan: Plan) -> None:
    """Write the arrays of all chunks, which must be finished.  Raises OSError, and leaves none."""
    import zarr

    from coscrew_codegen.simulation.sweep.files.checked_store import listed, sums

    made, target = folder.path / f".{ZARR}.part", folder.path / ZARR
    remove(made)
    try:
        group = zarr.open_group(made, mode="w", attributes={"coscrew": dict(about)})
        arrays: dict[str, zarr.Array[Any]] = {}
        for first, table in _tables(folder):
            arrays = arrays or _made(group, folder, table.schema, plan)
            for name, array in arrays.items():
                if name != "t":
                    array[first:first + len(table)] = _numbers(table, name)
        group.attrs["columns"] = [name for name in arrays if name != "t"]
        make_way(folder.path, target, is_folder=True)
        make_way(folder.path, sums(target))
        remove(target)
        whole(sums(target), listed(made, ZARR))
        made.rename(target)
    finally:
        remove(made)


def _tables(folder: Folder) -> Iterator[tuple[int, pyarrow.Table]]:
    """(first member, table) of several chunks at a time."""
    its = folder.specification
    several = _several(folder)
    for number in range(0, its.chunks, several):
        files = [folder.of(n) for n in range(number, min(number + several, its.chunks))]
        yield number * its.chunk, pyarrow.concat_tables(map(read, files))


def _several(folder: Folder) -> int:
    """Chunks of the sweep in a chunk of the arrays."""
    its = folder.specification
    return 1 if its.conditions.series else max(1, _ROWS // its.chunk)


def _made(group: "zarr.Group", folder: Folder, schema: pyarrow.Schema, plan: Plan
          ) -> dict[str, "zarr.Array[Any]"]:
    """Empty arrays for the columns of numbers."""
    count, rows = folder.specification.varied.members, _several(folder) * folder.specification.chunk
    rows, arrays = min(rows, count), {}
    for field in schema:
        if field.name in _WORDS:
            continue
        kind, inner = _kind(field.type)
        unit = (field.metadata or {}).get(b"unit", b"").decode()
        arrays[field.name] = group.create_array(
            field.name, shape=(count, *inner), chunks=(rows, *inner), dtype=kind,
            dimension_names=(MEMBER, *("t" for _ in inner)),
            attributes={"units": unit} if unit else {})
    if folder.specification.conditions.series:
        arrays["t"] = group.create_array("t", data=plan.samples, dimension_names=("t",),
                                         attributes={"units": "s"})
    return arrays


def _kind(type_: pyarrow.DataType) -> tuple[str, tuple[int, ...]]:
    """The type and inner shape of a column's array; a column of text becomes a flag that is true
    where there is text."""
    if pyarrow.types.is_fixed_size_list(type_):
        return _kind(type_.value_type)[0], (type_.list_size,)
    return ("bool" if pyarrow.types.is_string(type_) else str(type_.to_pandas_dtype()().dtype)), ()


def _numbers(table: pyarrow.Table, name: str) -> np.ndarray:
    column = table[name].combine_chunks()
    if pyarrow.types.is_string(column.type):
        return np.asarray(column.is_valid().to_numpy(zero_copy_only=False))
    if pyarrow.types.is_fixed_size_list(column.type):
        return np.asarray(column.flatten().to_numpy()).reshape(len(table), -1)
    return np.asarray(column.to_numpy(zero_copy_only=False))


def opened(folder: Path | str) -> "xarray.Dataset":
    """Opens the sweep in this folder; data are read on use.  Its dimensions are `sample`, if ranges
    were sampled, the grids, and t, if series were kept.  Coordinates are the varied quantities.
    Where a member failed, `failed.cause` and `failed.joint` are not "".

    Raises SweepError if the folder has no finished sweep; DamagedError, here or on use, for a file
    that differs from its written content; BlockedError for one that cannot be read."""
    path = Path(folder)
    with reading(path):
        return _opened(path)


def _opened(path: Path) -> "xarray.Dataset":
    import xarray
    from zarr.storage import LocalStore

    from coscrew_codegen.simulation.sweep.files.checked_store import CheckedStore

    if not (path / ZARR).is_dir():
        raise SweepError(f"{path}: holds no finished sweep: there is no {ZARR}")
    about: Any = read_description(path)[SPECIFICATION]
    its = about["varied"]
    flat = xarray.open_zarr(CheckedStore(LocalStore(path / ZARR, read_only=True)), chunks={},
                            consolidated=False)
    grids = {x["of"]["name"]: (x["of"]["name"], x["values"], flat[x["of"]["name"]].attrs)
             for x in its["grids"]}
    ranged = [x["of"]["name"] for x in its["ranges"]]
    shape = {"sample": its["samples"], **{name: len(x) for name, (_, x, _) in grids.items()}}
    names = [name for name in flat.attrs["columns"] if name not in grids]
    words = _WORDS if (path / MEMBERS).is_dir() else {}
    result = xarray.Dataset(
        {**{name: _folded(flat[name].variable, shape) for name in names},
         **{name: _folded(_texts(path, column, about["chunk"], flat.sizes[MEMBER]), shape)
            for name, column in words.items()}},
        {**grids, **({"t": flat["t"]} if "t" in flat else {})}, flat.attrs)
    result = result.assign_coords({name: result[name].isel(dict.fromkeys(grids, 0), drop=True)
                                   for name in ranged})
    return result if ranged else result.isel(sample=0)


def _texts(folder: Path, column: str, chunk: int, members: int) -> "xarray.Variable":
    """A column of the parts, which have so many members each, read on use; "" where it has no text.
    """
    import dask.array
    import xarray
    from dask.delayed import delayed

    def texts(path: Path) -> np.ndarray:
        result = read(path, [column])[column]
        return np.asarray(result.fill_null("").to_numpy(zero_copy_only=False), object)

    parts = [dask.array.from_delayed(delayed(texts)(part_of(folder, n)),
                                     (min(chunk, members - n * chunk),), object)
             for n in range(-(-members // chunk))]
    return xarray.Variable((MEMBER,), dask.array.concatenate(parts))


def _folded(x: "xarray.Variable", shape: Mapping[str, int]) -> "xarray.Variable":
    """The members of an array as samples and points of the grids."""
    import xarray

    inner = x.dims[1:]
    data = x.data.reshape((*shape.values(), *x.shape[1:]))
    return xarray.Variable((*shape, *inner), data, x.attrs)
