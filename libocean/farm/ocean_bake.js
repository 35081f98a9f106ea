// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Written by `ocean farm`: the job type "Ocean bake" of Flamenco 3. It bakes a sea in parts, checks
// that all frames are whole, then renders them where a scene is given. Put it into the folder
// `scripts` beside the manager, and set the manager's variables `ocean` and, for scenes of POV-Ray,
// `povray` to the programs on the workers.

// Options of `ocean bake`, as its help has them: scripts/update-docs writes this list.
const BAKE_OPTIONS = [
  // generated: bake options
  { key: "region", type: "string", default: "", label: "Region",
    description: "Only this rectangle [m], of a land or of a sea with a bed or hulls; needs " +
      "--cell" },
  { key: "cell", type: "string", default: "", label: "Cell",
    description: "Distance of the samples of --region: neighbouring regions of one cell that " +
      "share an edge join without a seam" },
  { key: "overwrite", type: "bool", default: false, label: "Overwrite",
    description: "Replace frames of another sea, which is refused without it" },
  { key: "keep_going", type: "bool", default: false, label: "Keep going",
    description: "Continue with the other frames when one fails" },
  { key: "resolution", type: "string", default: "", label: "Resolution",
    description: "Samples along a side, a power of two; default: the sea's grid, four times that " +
      "with cascades" },
  { key: "backend", type: "string", default: "", label: "Backend",
    description: "cpu, radix2, dft, gl, thesis or auto; default cpu. auto: gl on a GPU, else cpu" },
  { key: "products", type: "string", default: "", label: "Products",
    description: "Comma list of products; default displacement,normal,foam" },
  { key: "type", type: "string", default: "", label: "Type",
    description: "float or half; default: float for displacement, velocity, flow and depth, and " +
      "for the height of a terrain; half for the rest" },
  { key: "axes", type: "string", default: "", label: "Axes",
    description: "Order of vectors: tnb (x, z, y), zup (x, y, z), yup (x, z, -y); default tnb" },
  { key: "layout", type: "string", default: "", label: "Layout",
    description: "separate (a file for each product) or layered (one file); default separate" },
  { key: "compression", type: "string", default: "", label: "Compression",
    description: "none, rle, zips, zip, piz or pxr24; default rle for slope, whitecap, foam, " +
      "cover and masks, for halves of normal, jacobian and derivatives, else none" },
  { key: "caustics_depth", type: "string", default: "", label: "Caustics depth",
    description: "Depth of the level plane that caustics fall on; default: the sea's depth, 10 " +
      "at most" },
  { key: "detail_samples", type: "string", default: "", label: "Detail samples",
    description: "Samples along a side of each slope tile: 256, 512 or 1024; default 512" },
  { key: "sun", type: "string", default: "", label: "Sun",
    description: "Direction of the sun for caustics, degrees above the horizon and " +
      "counter-clockwise from +x; default 90,0" },
  // end of generated
];

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
    ...BAKE_OPTIONS,
    { key: "options", type: "string", default: "", label: "Further options",
      description: "Words for `ocean bake`: options of meshes and volumes, --threads" },
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
  const options = [];
  for (const { key, type } of BAKE_OPTIONS) {
    const name = "--" + key.replaceAll("_", "-");
    if (settings[key]) options.push(type === "bool" ? name : `${name}=${settings[key]}`);
  }
  options.push(...shellSplit(settings.options));

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
