#include "bundle.hpp"

#include <filesystem>
#include <system_error>

#include "command_template.hpp"
#include "text_file.hpp"

namespace flatdt::campaign {
namespace {

/// The script works from any folder; the command runs where the campaign ran, as its words may be relative to
/// that.
std::string script(const Contact& contact, Claim claim, const std::string& origin) {
  std::string text = "#!/bin/sh\n# " + origin + "\n" +
                     "here=$(cd \"$(dirname \"$0\")\" && pwd)\nfolder=$(mktemp -d)\noutput=$folder/output\n" +
                     "trap 'rm -rf \"$folder\"' EXIT\ncd " +
                     shell_line({std::filesystem::current_path().string()}) + " || exit 3\n";
  if (contact.persistent) {
    text += "{ cat \"$here/instance\"; echo end; } | " + shell_line(contact.command) + " >\"$folder/all\"";
  } else {
    text += shell_line(contact.command, "\"$here/instance\"", "\"$output\"");
    if (!has_place(contact.command, "instance")) text += " <\"$here/instance\"";
    if (!has_place(contact.command, "output")) text += " >\"$output\"";
  }
  text += "\nstatus=$?\necho \"exit status $status\"\n[ $status -eq 0 ] || exit $status\n";
  if (contact.persistent) text += "sed '/^end\\r*$/,$d' \"$folder/all\" >\"$output\"\n";
  if (claim == Claim::triangulation)
    text += "\"${FLATDT_CHECK:-flatdt-check}\" \"$here/instance\" \"$output\"\n";
  else
    text += "cat \"$output\"\n";
  return text;
}

/// Draws the output, or nothing: pictures are a help, never a condition.
void draw(const std::string& folder, int dimension, const std::string& flatdt) {
  Limits limits;
  limits.cpu_seconds = 20;
  limits.address_bytes = 0;  // builds with sanitizers reserve much
  const std::string picture = folder + (dimension == 2 ? "/picture.svg" : "/picture.html");
  std::vector<std::string> command{flatdt, "draw", folder + "/instance", folder + "/output", "-o", picture};
  if (std::filesystem::exists(folder + "/verdict.json"))
    command.insert(command.end(), {"--verdict", folder + "/verdict.json"});
  try {
    const End end = run_child(command, "", "", "", limits);
    if (end.ending != Ending::exited || end.code != 0) std::filesystem::remove(picture);
  } catch (const std::system_error&) {
    std::filesystem::remove(picture);
  }
}

}  // namespace

void write_bundle(const std::string& folder, const Failure& failure, const Contact& contact, Claim claim,
                  const std::string& flatdt) {
  std::filesystem::create_directories(folder);
  write_text(folder + "/instance", failure.shrunk);
  write_text(folder + "/original.instance", failure.original);
  if (!failure.answer.text.empty()) write_text(folder + "/output", failure.answer.text);
  if (!failure.judgement.verdict.empty()) write_text(folder + "/verdict.json", failure.judgement.verdict);
  write_text(folder + "/reason.txt", failure.judgement.signature + "\n" + failure.judgement.reason + "\n");
  const std::string path = folder + "/reproduce";
  write_text(path, script(contact, claim, failure.origin));
  std::filesystem::permissions(path, std::filesystem::perms(0755));
  if (!flatdt.empty() && claim == Claim::triangulation && !failure.answer.text.empty())
    draw(folder, failure.dimension, flatdt);
}

}  // namespace flatdt::campaign
