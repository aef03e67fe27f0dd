// SPDX-License-Identifier: Apache-2.0
#include "app/picture.hpp"

#include <memory>
#include <utility>

#include "app/commands.hpp"
#include "app/confinement.hpp"
#include "app/console.hpp"
#include "app/describe.hpp"
#include "app/draw_files.hpp"
#include "base/error.hpp"
#include "importer/read_model.hpp"
#include "pipeline/kept_models.hpp"
#include "pipeline/picture.hpp"

namespace epura {

namespace {

pipeline::PictureRequest request_of(const PictureOptions& options) {
  const std::string& file = options.draw.models.front();
  if (file == importer::standard_input)
    throw Error(ErrorKind::input, file, "standard input is one model, and a picture shows it twice",
                "write the model to a file");
  pipeline::PictureRequest request{options.draw.model, options.projection, options.from, options.vertices,
                                   options.keeps_plane};
  request.model.file = {file, file};
  return request;
}

}  // namespace

int draw_picture(PictureOptions options) {
  const pipeline::PictureRequest request = request_of(options);
  options.draw.run.kept_models = std::make_shared<pipeline::KeptModels>();
  const auto describe_picture = [&](const Progress& progress) {
    const pipeline::Picture picture = pipeline::make_picture(request, options.draw.run, progress);
    scene::SceneDescription scene = pipeline::scene_of(picture, request);
    complete(scene, options.draw);
    return scene;
  };
  ProgressBoard board;
  Console console(board, shows_progress(options.draw.progress), options.draw.run.time_limit);
  const pipeline::Messages messages = messages_to(console);
  const DrawnFiles drawn =
      draw_files(options.draw, describe_picture, messages, Progress(board, options.draw.run.time_limit));
  console.print("");  // erases the progress line
  tell_the_end(messages, options.draw, drawn);
  return exit_code_of(drawn);
}

int picture(const PictureOptions& options) {
  confine_if_asked(options.draw, {options.draw.models, options.draw.outputs});
  return draw_picture(options);
}

}  // namespace epura
