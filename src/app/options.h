// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "app/gallery/gallery_options.h"

namespace edaha {

// The command line as it was written, before it means anything.

// "--seed 7" is a short way to set variant.seed.
struct Setting {
    std::string option;
    std::string key;
    std::string value;
};

// Which tree: for draw and measure.
struct TreeOptions {
    std::string style;
    std::vector<Setting> settings;
    std::vector<std::string> assignments;  // of --set
    std::string palette;
    std::string size;
    bool background = false;
};

// How files are written: for draw and batch.
struct WriteOptions {
    std::string dpi;
    std::string width;
    bool expand = false;
    bool swatches = false;
};

// For batch alone.
struct BatchOptions {
    std::vector<std::string> sources;  // styles; with --merge, manifests
    std::string count;
    std::string seed_from;
    std::vector<std::string> sweeps;
    std::string name;
    std::string jobs;
    std::string shard;
    std::string sheet;  // its formats; "true" if none is named
    bool resume = false;
    bool merge = false;
    bool quiet = false;
};

// For flatten alone.
struct FlattenOptions {
    std::string model;
    std::string up;
};

struct Options {
    TreeOptions tree;
    WriteOptions write;
    GalleryOptions gallery;
    BatchOptions batch;
    FlattenOptions flatten;
    std::string frames;  // of draw
    std::string output;
    std::string format;
    std::string topic;               // of explain
    std::string shell;               // of completion
    std::vector<std::string> files;  // of check
    bool force = false;
    bool json = false;
    bool stats = false;
    bool names = false;
    bool markdown = false;
    bool schema = false;
};

// The command line can't be meant like that: exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace edaha
