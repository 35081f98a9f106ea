# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The commands that docs/farm.md has for Flamenco, before a manager that compiles the job by Node
and runs its tasks here, as a worker would."""

import http.server
import json
import threading

import jobs


class Manager(http.server.BaseHTTPRequestHandler):
    def do_POST(self):  # noqa: N802
        assert self.path == "/api/v3/jobs"
        self.server.job = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(200)
        self.end_headers()


def test_the_commands_of_the_page_bake_check_and_render_by_blender(tmp_path):
    commands, job = jobs.of_page(tmp_path, "flamenco")
    with http.server.HTTPServer(("127.0.0.1", 0), Manager) as manager:
        threading.Thread(target=manager.serve_forever, daemon=True).start()
        here = f"127.0.0.1:{manager.server_port}"
        jobs.run("bash", "-euc", commands.replace("MANAGER:8080", here), folder=tmp_path)
        manager.shutdown()
        submitted = manager.job
    assert submitted["settings"]["folder"] == str(job)
    (tmp_path / "submitted.json").write_text(json.dumps(submitted))
    for task in jobs.flamenco_graph(job / "ocean_bake.js", tmp_path / "submitted.json")["tasks"]:
        (command,) = task["commands"]
        how = command["parameters"]
        words = {
            "exec": lambda how: [how["exe"].strip("{}"), *how["args"]],
            "blender-render": lambda how: ["blender", "-b", how["blendfile"], *how["args"]],
        }[command["name"]](how)
        jobs.run(*words, folder=tmp_path)
    assert (job / "out/sea.manifest.json").exists()
    assert len(list((job / "out").glob("*.exr"))) == len(list(job.glob("scene*.png"))) == 4
