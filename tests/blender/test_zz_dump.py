import json, lzma, bpy
from pathlib import Path
import dataclasses
from libocean_addon import parameter_values, sea_text, baked
def test_dump(tmp_path):
    path = tmp_path / "old.blend"
    path.write_bytes(lzma.decompress(Path("/var/tmp/w/table/tests/data/blender/version_1.blend.xz").read_bytes()))
    bpy.ops.wm.open_mainfile(filepath=str(path))
    bpy.context.scene.frame_set(50)
    s = bpy.data.objects["Ocean"].libocean
    v = parameter_values.values_of(s)
    Path("/tmp/tw/values.json").write_text(json.dumps({"values": dataclasses.asdict(v), "time": s.custom_time if s.use_custom_time else None, "res": s.render_resolution, "recipe": baked.recipe(s, v), "text": sea_text.write(parameter_values.TABLE, v)}))
