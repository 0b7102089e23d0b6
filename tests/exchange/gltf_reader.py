"""Reads binary glTF 2.0 with animated nodes and skins, by the rules of the specification (Khronos) alone."""

import json
import struct

import numpy as np

TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
SIZES = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def rotation_matrix(q):
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def slerp(a, b, s):
    """The shortest turn (appendix C of the specification)."""
    cosine = np.dot(a, b)
    b = b if cosine >= 0 else -b
    angle = np.arccos(min(abs(cosine), 1))
    if angle < 1e-6:
        return a + s * (b - a)
    return (np.sin((1 - s) * angle) * a + np.sin(s * angle) * b) / np.sin(angle)


class Gltf:
    """A file; all indices and sizes of it are checked as they are used."""

    def __init__(self, path):
        data = path.read_bytes()
        magic, version, length = struct.unpack("<4sII", data[:12])
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack("<I4s", data[12:20])
        assert kind == b"JSON" and size % 4 == 0
        self.json = json.loads(data[20 : 20 + size])
        binary, kind = struct.unpack("<I4s", data[20 + size : 28 + size])
        assert kind == b"BIN\0" and binary % 4 == 0 and 28 + size + binary == length
        self.binary = data[28 + size :]
        assert self.json["buffers"][0]["byteLength"] <= len(self.binary)
        self.nodes = self.json["nodes"]
        self.parents = {child: index for index, node in enumerate(self.nodes) for child in node.get("children", [])}
        self.animation = self.json["animations"][0]
        self.channels = {(c["target"]["node"], c["target"]["path"]): self.animation["samplers"][c["sampler"]]
                         for c in self.animation["channels"]}
        self.cache = {}

    def values(self, index):
        """An accessor, a row for each element."""
        if index not in self.cache:
            accessor = self.json["accessors"][index]
            view, kind = self.json["bufferViews"][accessor["bufferView"]], np.dtype(TYPES[accessor["componentType"]])
            count, size = accessor["count"], SIZES[accessor["type"]]
            assert view["byteOffset"] % kind.itemsize == 0 and count * size * kind.itemsize <= view["byteLength"]
            values = np.frombuffer(self.binary, kind, count * size, view["byteOffset"]).reshape(count, size)
            for name, limit in [("min", values.min(axis=0)), ("max", values.max(axis=0))]:
                assert name not in accessor or np.allclose(accessor[name], limit)
            self.cache[index] = values
        return self.cache[index]

    def node(self, name):
        return next(i for i, node in enumerate(self.nodes) if node.get("name") == name)

    def times(self):
        inputs = {sampler["input"] for sampler in self.animation["samplers"]}
        assert len(inputs) == 1 and all(s.get("interpolation", "LINEAR") == "LINEAR" for s in self.animation["samplers"])
        return self.values(inputs.pop())[:, 0]

    def animated(self, node, path, time, default):
        """The value of a node's property at a time."""
        sampler = self.channels.get((node, path))
        if sampler is None:
            return np.array(self.nodes[node].get(path, default), float)
        times, values = self.values(sampler["input"])[:, 0], self.values(sampler["output"]).astype(float)
        assert len(times) == len(values)
        after = int(np.clip(np.searchsorted(times, time), 1, len(times) - 1))
        s = np.clip((time - times[after - 1]) / (times[after] - times[after - 1]), 0, 1)
        a, b = values[after - 1], values[after]
        return slerp(a, b, s) if path == "rotation" else a + s * (b - a)

    def matrix(self, node, time):
        """From the node's axes to the world's, at a time."""
        local = np.eye(4)
        assert "matrix" not in self.nodes[node], "what is animated has no matrix"
        local[:3, :3] = rotation_matrix(self.animated(node, "rotation", time, [0, 0, 0, 1]))
        local[:3, 3] = self.animated(node, "translation", time, [0, 0, 0])
        return self.matrix(self.parents[node], time) @ local if node in self.parents else local

    def skinned(self, name, time):
        """Points of each primitive of a skinned mesh at a time, with the joint of each point."""
        node = self.nodes[self.node(name)]
        skin = self.json["skins"][node["skin"]]
        inverse = self.values(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1).astype(float)
        assert len(inverse) == len(skin["joints"])
        joints = np.array([self.matrix(j, time) for j in skin["joints"]]) @ inverse
        for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
            attributes = primitive["attributes"]
            points = self.values(attributes["POSITION"]).astype(float)
            indices = self.values(attributes["JOINTS_0"])
            weights = self.values(attributes["WEIGHTS_0"]) / 255
            assert np.all(weights.sum(axis=1) == 1) and indices.max() < len(joints)
            assert self.values(primitive["indices"]).max() < len(points)
            mixed = np.einsum("pj,pjab->pab", weights, joints[indices])
            placed = np.einsum("pab,pb->pa", mixed, np.column_stack([points, np.ones(len(points))]))
            yield placed[:, :3], [skin["joints"][j] for j in indices[:, 0]]
