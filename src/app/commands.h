// SPDX-License-Identifier: MIT
#pragma once
#include "app/console.h"
#include "app/options.h"

namespace edaha {

// One function a command: does it and returns the exit code. Errors: InputError, IoError,
// UsageError; nothing is then written.
int draw(const Options& options, Console& console);
int batch(const Options& options, Console& console);
int make_gallery(const Options& options, Console& console);
int flatten_file(const Options& options, Console& console);
int write_mesh(const Options& options, Console& console);
int measure(const Options& options, Console& console);
int list_styles(const Options& options, Console& console);
int list_leaves(const Options& options, Console& console);
int check_files(const Options& options, Console& console);
int explain(const Options& options, Console& console);
int print_completion(const Options& options, Console& console);
int print_manual(const Options& options, Console& console);

}  // namespace edaha
