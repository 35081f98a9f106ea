// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The facade: keeps the chain parameters -> spectrum -> modes -> surface and redoes only what a
// changed parameter dirties. One thread at a time per object; several objects run in parallel.
#pragma once

#include <optional>
#include <string_view>

#include "ocean/parameter_table.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

struct OceanOptions {
    int threads = 0;  // 0 = the cores this process may use
    Backend backend = Backend::cpu;
};

class Ocean {
  public:
    /// Validates. Nothing is computed yet.
    explicit Ocean(Parameters parameters, OceanOptions options = {});

    const Parameters& parameters() const { return parameters_; }
    /// Throws and changes nothing if the value is refused. Rules between parameters are checked
    /// when the sea is next asked for anything.
    void set(std::string_view name, std::string_view value);
    /// All parameters at once, of which only those that dirty `first_stage` or later may differ.
    void change(Parameters parameters, Stage first_stage);

    const DirectionalSpectrum& spectrum();
    const Modes& modes();
    SeaState state();
    /// Throws Error out_of_memory before it allocates more than there is.
    Surface evaluate(double time, ChannelSet channels, int resolution = 0);

  private:
    void require_valid();

    Parameters parameters_;
    bool validated_ = false;
    OceanOptions options_;
    ThreadPool pool_;
    std::optional<DirectionalSpectrum> spectrum_;
    std::optional<Modes> modes_;
};

}  // namespace ocean
