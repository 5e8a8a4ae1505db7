#include "visao/command_line.hpp"

#include "console/option_types.hpp"

namespace animado::visao {

std::string examples(const std::string& program) {
  return fmt::format(
      "  {0} runs/colisao                                 a film strip: runs/colisao/sheet.png\n"
      "  {0} runs/colisao --camera side --frames 3..6     these frames, seen along x\n"
      "  {0} runs/colisao --camera \"(4, 2, 9)\" --look-at \"(0, 1, 0)\" --output near.png\n"
      "  {0} runs/colisao --mp4                           a film at real speed: runs/colisao/film.mp4\n\n"
      "Draws what a run left in its results folder. The file's name is printed on stdout.\n"
      "Exit codes: 0 done, 2 the command line or the folder makes no sense, or ffmpeg is missing, 130 "
      "interrupted.\n",
      program);
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("directory", options.directory, "The results of a run")->required()->type_name(kFolderType);
  app.add_option("--camera", options.camera,
                 "From where: three-quarter (default), front, side, top, or a point \"(x, y, z)\" in metres");
  app.add_option("--look-at", options.look_at,
                 "The point \"(x, y, z)\" in the middle of the picture (default: the middle of the motion)");
  app.add_option("--size", options.size,
                 "WxH of the page or of the film, px; W alone: as high as it comes (default: 1280; a film: "
                 "1280x720)");
  app.add_option(
      "--frames", options.frames,
      "How many, evenly (12), which (3,5,8), or from one to another (10..20); default: 12, fewer of "
      "many bodies");
  app.add_option("--output", options.output,
                 "File to write (default: sheet.png, or film.mp4, beside the results)")
      ->type_name(kFileType);
  app.add_flag("--mp4", options.mp4, "A film instead: 30 pictures a second, at real speed; needs ffmpeg");
  app.add_flag("--quiet", options.quiet, "No progress, and no name on stdout; errors are still told");
}

}  // namespace animado::visao
