// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Compiles a job type of Flamenco as its manager does, in strict mode and with the manager's
// globals, and prints the tasks as JSON. Adding a task or a command copies it, as there.
// usage: node flamenco_graph.js ocean_bake.js job.json
"use strict";
const fs = require("fs");
const vm = require("vm");

function framesOf(range) {
  const frames = new Set();
  for (const part of String(range).replaceAll("..", "-").split(",")) {
    const ends = part.split("-").map((end) => {
      if (!/^\s*\d+\s*$/.test(end)) throw new Error(`invalid range ${part}`);
      return Number(end);
    });
    for (let frame = ends[0]; frame <= ends.at(-1); frame++) frames.add(frame);
  }
  return [...frames].sort((a, b) => a - b);
}

function rangeOf(frames) {
  const runs = [];
  for (const frame of frames) {
    if (runs.length > 0 && runs.at(-1)[1] === frame - 1) runs.at(-1)[1] = frame;
    else runs.push([frame, frame]);
  }
  return runs.map(([first, last]) => (first === last ? `${first}` : `${first}-${last}`)).join(",");
}

function Task(name, type) {
  if (name.trim() === "" || type.trim() === "") throw new Error("a task has a name and a type");
  return {
    name, type, commands: [], dependencies: [],
    addCommand(command) { this.commands.push(structuredClone(command)); },
    addDependency(task) { this.dependencies.push(task.name); },
  };
}

const manager = {
  print() {},
  frameCount: (range) => framesOf(range).length,
  frameChunker(range, size) {
    const frames = framesOf(range);
    const chunks = [];
    for (let i = 0; i < frames.length; i += size) chunks.push(rangeOf(frames.slice(i, i + size)));
    return chunks;
  },
  shellSplit: (line) => line.split(/\s+/).filter((word) => word !== ""),
  author: { Task, Command: (name, parameters, steps = 0) => ({ name, parameters, steps }) },
};
vm.createContext(manager);
const script = fs.readFileSync(process.argv[2], "utf8");
vm.runInContext(`"use strict";\n${script}\nglobalThis.type = JOB_TYPE; globalThis.compile = compileJob;`,
  manager);

// As the manager's API has them: a field of another name is refused.
const FIELDS = ["key", "type", "subtype", "choices", "propargs", "description", "label", "default",
  "eval", "evalInfo", "visible", "required", "editable"];
const TYPES = { string: "string", int32: "number", float: "number", bool: "boolean" };
for (const setting of manager.type.settings) {
  const foreign = Object.keys(setting).filter((field) => !FIELDS.includes(field));
  const { key, type, default: value = null } = setting;
  if (foreign.length > 0 || !(type in TYPES) || (value !== null && typeof value !== TYPES[type])) {
    throw new Error(`setting ${key}: ${foreign} ${type} ${value}`);
  }
}
const submitted = JSON.parse(fs.readFileSync(process.argv[3], "utf8"));
const settings = Object.fromEntries(manager.type.settings.map(({ key, default: value }) => [key, value]));
for (const [key, value] of Object.entries(submitted.settings)) {
  if (!(key in settings)) throw new Error(`the job type has no setting ${key}`);
  settings[key] = value;
}
const tasks = [];
manager.compile({
  settings,
  addTask({ name, type, commands, dependencies }) {
    tasks.push(structuredClone({ name, type, commands, dependencies }));
  },
});
console.log(JSON.stringify({ type: submitted.type, settings: Object.keys(settings), tasks }));
