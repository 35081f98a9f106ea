// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A bake as a job for the engine of a render farm: bake in parts, check, render. The files of a job
// are texts; whoever requested them writes them into one folder, from which relative paths start.
//
//     const FarmJob job{.sea_text = write_sea(sea), ...};
//     for (const FarmFile& file : farm_files(find_farm_engine("slurm"), job)) save(file);
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

struct FarmJob {
    std::string sea_text;                      // of a sea file that needs no other file
    std::function<double(int frame)> time_of;  // of the sea [s]
    std::string output;                        // -o of `ocean bake`
    std::vector<int> frames;                   // farm_files() sorts them
    std::vector<std::string> options;          // further words of `ocean bake`
    std::string render = {};                   // a scene, .pov or .blend; "" = no step that renders
    int frames_per_task = 0;                   // 0 = all
    int threads = 0;                           // cores of a task; 0 = those that it gets
    int minutes = 0;                 // after which the engine ends a task; 0 = its own limit
    std::uint64_t memory_bytes = 0;  // of a task; 0 = unknown

    /// Returns the number of tasks that bake; their frames differ by at most one.
    int tasks() const;
};

struct FarmFile {
    std::string name;
    std::string text;
};

/// An engine: a row of the table, and one file of farm/.
struct FarmEngine {
    std::string_view name;     // "slurm"
    std::string_view summary;  // "SLURM: scripts for sbatch"
    std::string_view submit;   // the command that sends a job, in its folder
    int max_tasks;
    std::vector<FarmFile> (*files)(const FarmJob& job);
};

std::span<const FarmEngine> farm_engines();
/// Throws Error invalid_value with the engines that exist.
const FarmEngine& find_farm_engine(std::string_view name);

/// Returns all files of a job, sea.toml first. Throws Error invalid_value for a job that the engine
/// cannot run.
std::vector<FarmFile> farm_files(const FarmEngine& engine, FarmJob job);

/// Returns the names that files of a job can have, of all engines.
std::vector<std::string> farm_file_names();

/// Returns true for a text that farm_files() made: a file of a job may be replaced by another one.
bool is_farm_file(std::string_view text);

}  // namespace ocean
