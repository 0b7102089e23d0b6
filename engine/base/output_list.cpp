#include "engine/base/output_list.h"

#include <fmt/format.h>
#include <unistd.h>

namespace netpocket {
namespace {

void require_suffix(const std::string& option, const std::string& path, FileKind kind) {
  if (!names_another_format(kind, path)) return;
  throw OutputRefused(fmt::format("{}: \"{}\" names another format; {} is written, which ends with {}", option, path,
                                  description(kind), suffix(kind)));
}

}  // namespace

OutputList::OutputList() {
  for (const auto& [stream, name] : {std::pair(STDOUT_FILENO, "standard output"), {STDERR_FILENO, "standard error"}}) {
    struct stat status = {};
    if (fstat(stream, &status) == 0 && S_ISREG(status.st_mode)) inputs_.push_back({name, status});
  }
}

void OutputList::add_input(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) == 0) inputs_.push_back({fmt::format("\"{}\", which is read", path), status});
}

void OutputList::add(const std::string& option, const std::string& path, FileKind kind, ReadOnlyFiles read_only) {
  require_suffix(option, path, kind);
  struct stat status = {};
  // This check comes before that of the kind, because its message is more helpful.
  if (stat(path.c_str(), &status) == 0) require_no_input(option, {path, path, "", status});
  add_continued(option, path, kind, read_only);
}

void OutputList::add_continued(const std::string& option, const std::string& path, FileKind kind,
                               ReadOnlyFiles read_only) {
  const Destination destination = [&] {
    try {
      return find_destination(path, kind, read_only);
    } catch (const OutputRefused& refusal) {
      throw OutputRefused(fmt::format("{}: {}", option, refusal.what()));
    }
  }();
  require_no_output(option, destination);
  outputs_.push_back({option, place_of(destination)});
}

void OutputList::require_no_input(const std::string& option, const Destination& destination) const {
  for (const Input& input : inputs_) {
    if (!is_same_file(input.status, *destination.existing)) continue;
    throw OutputRefused(fmt::format("{}: \"{}\" is the same file as {}", option, destination.name, input.name));
  }
}

void OutputList::require_no_output(const std::string& option, const Destination& destination) const {
  const Place place = place_of(destination);
  for (const Output& output : outputs_) {
    if (output.place != place) continue;
    throw OutputRefused(fmt::format("{}: \"{}\" is the file that {} names; give each its own", option, destination.name,
                                    output.option));
  }
  for (const Folder& folder : folders_) {
    struct stat status = {};
    const bool inside = stat(folder.path.c_str(), &status) == 0 && status.st_dev == place.device &&
                        status.st_ino == place.folder && folder.is_ours(place.name);
    if (!inside) continue;
    throw OutputRefused(fmt::format("{}: \"{}\" is one of the files that {} writes; give it another name", option,
                                    destination.name, folder.option));
  }
}

void OutputList::add_folder(const std::string& option, const std::string& path,
                            std::function<bool(const std::string&)> is_ours) {
  folders_.push_back({option, path, std::move(is_ours)});
}

}  // namespace netpocket
