// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Written by `ocean farm`: the job type "Ocean bake" of Flamenco 3. It bakes a sea in parts, checks
// that all frames are whole, then renders them where a scene is given. Put it into the folder
// `scripts` beside the manager, and set the manager's variables `ocean` and, for scenes of POV-Ray,
// `povray` to the programs on the workers.

const JOB_TYPE = {
  label: "Ocean bake",
  description: "Bake a sea of libocean, check its files, render a scene",
  settings: [
    { key: "sea", type: "string", subtype: "file_path", required: true,
      description: "The sea file" },
    { key: "output", type: "string", subtype: "file_path", required: true,
      description: "Path of the frames with the frame number as ####, such as out/sea.####.exr" },
    { key: "frames", type: "string", required: true,
      eval: "f'{C.scene.frame_start}-{C.scene.frame_end}'",
      evalInfo: { showLinkButton: true, description: "Scene frame range" },
      description: "Frames, such as 1-250 or 1-50,60" },
    { key: "chunk_size", type: "int32", default: 20, propargs: { min: 1 }, visible: "submission",
      description: "Frames of a task that bakes" },
    { key: "options", type: "string", default: "",
      description: "Further options of `ocean bake`, such as --products displacement,foam" },
    { key: "render", type: "string", subtype: "file_path", default: "",
      description: "A scene to render afterwards, .blend or .pov; empty: none" },
    { key: "render_options", type: "string", default: "", visible: "submission",
      description: "Further options of povray, such as +W1920 +H1080" },
    { key: "folder", type: "string", subtype: "dir_path", default: "", visible: "submission",
      description: "The folder that relative paths start from, as the workers see it" },
  ],
};

function compileJob(job) {
  const settings = job.settings;
  const isAbsolute = (path) => /^(?:[\/\\{]|[A-Za-z]:)/.test(path);
  const inFolder = (path) =>
    settings.folder === "" || isAbsolute(path) ? path : settings.folder + "/" + path;
  const folderOf = (path) => path.replace(/[^\/\\]*$/, "") || "./";
  const sea = inFolder(settings.sea);
  const output = inFolder(settings.output);
  const options = shellSplit(settings.options);

  // Commands and dependencies come before addTask, which copies.
  const add = (name, type, command, dependencies) => {
    const task = author.Task(name, type);
    task.addCommand(command);
    for (const dependency of dependencies) task.addDependency(dependency);
    job.addTask(task);
    return task;
  };
  const run = (exe, args) => author.Command("exec", { exe: exe, args: args });

  const count = frameCount(settings.frames);
  const parts = Math.ceil(count / settings.chunk_size);
  const bakes = [];
  for (let part = 1; part <= parts; part++) {
    const args = ["bake", sea, "-o", output, "--skip-existing", ...options,
      "--frames", settings.frames, "--shard", `${part}/${parts}`];
    bakes.push(add(`bake-${part}of${parts}`, "misc", run("{ocean}", args), []));
  }
  const check = add("check", "misc", run("{ocean}",
    ["check", output, "--frames", settings.frames, "--against", sea, "--merge"]), bakes);

  if (settings.render === "") return;
  const scene = inFolder(settings.render);
  const isBlend = settings.render.toLowerCase().endsWith(".blend");
  for (const frames of frameChunker(settings.frames, isBlend ? settings.chunk_size : 1)) {
    const command = isBlend
      ? author.Command("blender-render", {
        exe: "{blender}", exeArgs: "{blenderArgs}", argsBefore: [], blendfile: scene,
        args: ["--render-frame", frames.replaceAll("-", "..")],
      }, frameCount(frames))
      : run("{povray}", ["+I" + scene, "+L" + folderOf(scene), "+L" + folderOf(output),
        "+O" + folderOf(scene), "-D", ...shellSplit(settings.render_options),
        "+SF" + frames, "+EF" + frames]);
    add(`render-${frames}`, isBlend ? "blender" : "misc", command, [check]);
  }
}
