// tetloft render: pictures of a model.
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include <tetloft/tetloft.hpp>

#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/signals.hpp"
#include "cli/stack_input.hpp"
#include "core/spelling.hpp"
#include "core/text.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"
#include "io/stage.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

// What is drawn for each extension of the output.
struct Picture {
  std::string_view extension;
  Result<std::string> (*render)(const Model&, const SectionStack*, const RenderOptions&);
};
constexpr std::array kPictures{Picture{".png", render_png}, Picture{".svg", render_svg},
                               Picture{".html", render_html}};

std::vector<std::string_view> picture_extensions() {
  std::vector<std::string_view> extensions;
  for (const Picture& picture : kPictures) extensions.push_back(picture.extension);
  return extensions;
}

std::vector<std::string> colourings() {
  std::vector<std::string> names;
  for (int k = 0; k < kColourings; ++k) names.emplace_back(name_of(static_cast<ColourBy>(k)));
  return names;
}

Usage render_usage() {
  Usage usage{
      "render",
      "A picture of a model, or a page to turn, cut, measure and take it apart, and to compare it "
      "with others.",
      {input_word("MODEL", Contents::model)},
      {{"--output", "OUT", "the picture: " + list_of(picture_extensions()) + "; required", "-o"},
       {"--contours", input_word("IN", Contents::stack),
        "draw the contours of this stack (default: the model's own)"},
       format_option("--format", "the contours", Contents::stack),
       {"--roi", "NAME", "of their file the structure of this name or number"},
       {"--label", "NAME", "of their file the label of this value or name"},
       model_format_option(),
       {"--no-contours", "", "draw no contours"},
       {"--colour",
        "WHAT",
        "component (default), slab, kind, dihedral or evidence",
        {},
        colourings()},
       {"--view", "A,E", "azimuth and elevation of the eye in degrees (default -60,25)"},
       {"--cut", "AXIS=VALUE", "cut open by the plane x, y or z = VALUE"},
       {"--explode", "GAPS", "move the slabs apart by this many mean heights"},
       {"--stretch", "FACTOR", "draw z this many times as large"},
       {"--edges", "", "draw the edges of tets"},
       {"--size", "WxH", "pixels of .png and .svg (default 1200x900)"},
       {"--white", "", "white background instead of none"},
       {"--title", "TEXT", "of the page (default: the models' names)"},
       kJsonOption,
       kQuietOption,
       kHelpOption},
      "An .html file needs nothing else: open it in a browser with WebGL 2. There the options "
      "are what is shown first, and all can be changed. It takes several models, each where its "
      "file has it: over each other, or side by side. Heights and cuts are in the coordinates of "
      "the (first) model's stack."};
  usage.repeats = true;
  return usage;
}

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

std::vector<std::string> model_paths(const Arguments& arguments) {
  std::vector<std::string> paths;
  for (std::size_t k = 0; k < arguments.operand_count(); ++k) {
    paths.push_back(arguments.operand(k));
  }
  return paths;
}

std::string title_of(const std::vector<std::string>& paths) {
  std::string title;
  for (const std::string& path : paths) title += (title.empty() ? "" : ", ") + stem_of(path);
  return title;
}

// "first SEPARATOR second", two numbers.
std::optional<std::array<double, 2>> two_numbers(const std::string& text, char separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  const io::ParsedNumber first = io::parse_number(std::string_view(text).substr(0, at));
  const io::ParsedNumber second = io::parse_number(std::string_view(text).substr(at + 1));
  if (!first.ok() || !second.ok()) return std::nullopt;
  return std::array{first.value, second.value};
}

Error wrong_value(const std::string& option, const std::string& value, const char* expected) {
  return usage_error("option " + option + ": " + io::in_quotes(value) + " is not " + expected);
}

Result<RenderOptions> render_options(const Arguments& arguments) {
  RenderOptions options;
  const auto colour = arguments.choice("--colour");
  if (!colour) return colour.error();
  options.colour = static_cast<ColourBy>(colour->value_or(0));
  if (const auto view = arguments.text("--view")) {
    const auto angles = two_numbers(*view, ',');
    if (!angles) return wrong_value("--view", *view, "two numbers A,E");
    options.azimuth = (*angles)[0];
    options.elevation = (*angles)[1];
  }
  if (const auto cut = arguments.text("--cut")) {
    const bool formed = cut->size() > 2 && (*cut)[0] >= 'x' && (*cut)[0] <= 'z' && (*cut)[1] == '=';
    const io::ParsedNumber position =
        formed ? io::parse_number(std::string_view(*cut).substr(2)) : io::ParsedNumber{};
    if (!position.ok()) return wrong_value("--cut", *cut, "x=, y= or z= and a number");
    options.cut = PictureCut{(*cut)[0] - 'x', position.value};
  }
  if (const auto size = arguments.text("--size")) {
    const auto sides = two_numbers(*size, 'x');
    const auto whole = [](double side) {
      return side >= 1 && side <= kLargestPictureSide && side == static_cast<int>(side);
    };
    if (!sides || !whole((*sides)[0]) || !whole((*sides)[1])) {
      return wrong_value("--size", *size, "WxH, each from 1 to 8192");
    }
    options.width = static_cast<int>((*sides)[0]);
    options.height = static_cast<int>((*sides)[1]);
  }
  for (const auto& [name, target] :
       {std::pair{"--explode", &options.explode}, std::pair{"--stretch", &options.stretch}}) {
    const auto value = arguments.number(name);
    if (!value) return value.error();
    if (*value) *target = **value;
  }
  options.edges = arguments.has("--edges");
  options.contours = !arguments.has("--no-contours");
  options.white = arguments.has("--white");
  options.title = arguments.text("--title").value_or(title_of(model_paths(arguments)));
  return options;
}

struct RenderRequest {
  std::vector<std::string> models;
  std::string output;
  std::optional<std::string> stack;  ///< whose contours are drawn
  std::string model_format;
  ReadOptions reading;  ///< of the stack
  RenderOptions options;
};

// Refused where the command line alone tells that nothing will come of it.
Result<RenderRequest> render_request(const Arguments& arguments) {
  const auto output = arguments.text("--output");
  if (!output) return usage_error("missing option --output (-o) OUT");
  RenderRequest request{model_paths(arguments), *output, arguments.text("--contours"), {}, {}, {}};
  auto options = render_options(arguments);
  if (!options) return options.error();
  request.options = *std::move(options);
  std::vector<std::string> taken = request.models;
  if (request.stack) taken.push_back(*request.stack);
  Result<void> checked = check_output("--output (-o)", *output, picture_extensions(), taken);
  if (!checked) return checked.error();
  if (request.models.size() > 1 && io::extension_of(*output) != ".html") {
    return usage_error("option --output (-o): several models are shown by a page, .html, alone");
  }
  auto stack_format = chosen_format(arguments, "--format", Contents::stack);
  if (!stack_format) return stack_format.error();
  auto model_format = chosen_model_format(arguments);
  if (!model_format) return model_format.error();
  request.model_format = *std::move(model_format);
  request.reading.format = *std::move(stack_format);
  request.reading.structure =
      arguments.text("--roi").value_or(arguments.text("--label").value_or(""));
  return request;
}

// Of one model the picture, of several the page.
Result<std::string> picture_of(const RenderRequest& request, const std::vector<Model>& models,
                               const SectionStack* contours) {
  if (models.size() > 1) {
    std::vector<NamedModel> named;
    for (std::size_t k = 0; k < models.size(); ++k) {
      named.push_back({&models[k], stem_of(request.models[k])});
    }
    return render_html(named, contours, request.options);
  }
  const std::string extension = io::extension_of(request.output);
  const auto of = std::find_if(kPictures.begin(), kPictures.end(),
                               [&](const Picture& p) { return p.extension == extension; });
  Result<std::string> picture = of->render(models.front(), contours, request.options);
  if (picture || picture.error().code != ErrorCode::invalid_input) return picture;
  Error error = picture.error();
  error.where.file = request.models.front();
  return error;
}

// Each lies as in its file, in one picture. All are compared with the first that tells `what`.
void warn_of_difference(const RenderRequest& request, const std::vector<Model>& models,
                        const char* what, std::string Description::*told, Console& console) {
  const auto tells = [&](const Model& model) { return !(model.about.*told).empty(); };
  const auto first = std::find_if(models.begin(), models.end(), tells);
  for (auto other = first; other != models.end(); ++other) {
    if (!tells(*other) || other->about.*told == first->about.*told) continue;
    const auto described = [&](auto model) {
      return io::in_quotes(model->about.*told) + " of " +
             io::in_quotes(request.models[static_cast<std::size_t>(model - models.begin())]);
    };
    console.warn({std::string("the models differ in ") + what + ": " + described(first) + ", " +
                      described(other) + "; they are shown as they lie in their files",
                  {}});
  }
}

Result<int> run_render(const Arguments& arguments, Console& console) {
  auto request = render_request(arguments);
  if (!request) return request.error();
  std::optional<SectionStack> stack;
  if (request->stack) {
    Result<ReadStack> read = read_stack(*request->stack, request->reading);
    if (!read) return read.error();
    for (const Warning& warning : read->warnings) console.warn(warning);
    stack = std::move(read->stack);
  }
  std::vector<Model> models;
  for (const std::string& path : request->models) {
    auto model = read_model_input(path, request->model_format, console);
    if (!model) return model.error();
    if (stack) put_into_frame(*model, *stack, console);
    models.push_back(*std::move(model));
  }
  warn_of_difference(*request, models, "unit", &Description::unit, console);
  warn_of_difference(*request, models, "orientation", &Description::orientation, console);
  const Result<std::string> picture = [&] {
    Progress progress(!console.quiet());
    request->options.execution.progress = progress.callback();
    return picture_of(*request, models, stack ? &*stack : nullptr);
  }();
  if (!picture) return picture.error();
  StagedFiles files;
  Result<void> staged =
      take_staged(io::stage_file(request->output, *picture, temporary_watcher()), files, console);
  if (!staged) return staged.error();
  std::string told;
  if (console.json()) {
    JsonWriter json;
    json.begin_object();
    json.member("written", request->output);
    json.member("bytes", picture->size());
    write_warnings(json, console.warnings());
    json.end_object();
    told = json.text();
  } else if (!console.quiet()) {
    told = "written: " + printable(request->output) + '\n';
  }
  const Result<void> done = deliver_with(files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace

Command render_command() { return {render_usage(), run_render}; }

}  // namespace tetloft::cli
