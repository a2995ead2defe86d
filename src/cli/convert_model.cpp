// See convert_model.hpp.
#include "cli/convert_model.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/file_formats.hpp"
#include "cli/outputs.hpp"
#include "cli/stack_input.hpp"
#include "cli/structures.hpp"
#include "core/text.hpp"
#include "io/files.hpp"
#include "io/formats.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

std::vector<std::string_view> target_extensions() {
  std::vector<std::string_view> all = output_extensions(Contents::model);
  for (const std::string_view extension : output_extensions(Contents::surface)) {
    if (std::find(all.begin(), all.end(), extension) == all.end()) all.push_back(extension);
  }
  return all;
}

bool among(std::string_view extension, const std::vector<std::string_view>& extensions) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

struct ModelConversion {
  std::string input;
  std::string output;
  std::string model_format;
  std::string to;
  bool solid = true;  ///< or its boundary
  bool per_component = false;
  Encoding encoding = Encoding::binary;
};

// That of the output tells the format, unless --to does. Files beside the output have its name,
// with extensions of their own: it must have one, too.
std::vector<std::string_view> extensions_for(const ModelConversion& conversion) {
  if (conversion.to.empty()) return target_extensions();
  const auto format =
      io::choose_writer(io::format_table(), Contents::model, conversion.output, conversion.to);
  if (!format || (*format)->companions.front().write == nullptr) return {};
  std::vector<std::string_view> extensions((*format)->extensions.begin(),
                                           (*format)->extensions.end());
  std::erase(extensions, "");
  return extensions;
}

Result<void> check_no_stack_options(const Arguments& arguments) {
  for (const Option& option : preparation_options()) {
    if (!arguments.has(option.name)) continue;
    return usage_error("option " + option.name + " is of stacks, and a model is converted");
  }
  if (!arguments.has("--labels-out")) return {};
  return usage_error("option --labels-out is of stacks, and a model is converted");
}

Result<ModelConversion> conversion_of(const Arguments& arguments, const std::string& output) {
  if (Result<void> apt = check_no_stack_options(arguments); !apt) return apt.error();
  ModelConversion conversion;
  conversion.input = arguments.operand(0);
  conversion.output = output;
  const auto model_format = chosen_model_format(arguments);
  if (!model_format) return model_format.error();
  conversion.model_format = *model_format;
  const auto to = arguments.choice("--to");
  if (!to) return to.error();
  if (*to) conversion.to = std::string(model_targets()[**to]);
  const Result<Encoding> encoding = encoding_of(arguments);
  if (!encoding) return encoding.error();
  conversion.encoding = *encoding;
  conversion.per_component = arguments.has("--per-component");
  conversion.solid = writes_solid(output, conversion.to);
  if (output == "-") return usage_error("the output needs a name; /dev/stdout is standard output");
  Result<void> checked =
      check_output("--output (-o)", output, extensions_for(conversion), {conversion.input});
  if (!checked) return checked.error();
  return conversion;
}

std::vector<std::string> names_of_components(const Model& model) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < model.component_count; ++c) {
    names.push_back(component_name(model, ComponentId(c)));
  }
  return names;
}

// Of the whole, or of each component.
std::vector<std::string> outputs_for(const ModelConversion& conversion, const Model& model) {
  if (!conversion.per_component) return {conversion.output};
  std::vector<Structure> components;
  for (const std::string& name : names_of_components(model)) {
    components.push_back({{}, name, std::to_string(components.size() + 1), 0});
  }
  return outputs_of(conversion.output, components);
}

// Names that are known only now: none is the input.
Result<void> check_parts(const ModelConversion& conversion, const std::vector<std::string>& paths) {
  if (!conversion.per_component) return {};
  for (const std::string& path : paths) {
    Result<void> apart = check_output("--per-component", path, {}, {conversion.input});
    if (!apart) return apart;
  }
  return {};
}

Result<void> stage_part(const ModelConversion& conversion, const Model& part,
                        const std::string& path, StagedFiles& files, Console& console) {
  ModelOutputs outputs;
  (conversion.solid ? outputs.solid : outputs.surface) = path;
  outputs.encoding = conversion.encoding;
  outputs.format = conversion.to;
  auto staged = stage_model(part, outputs, console);
  if (!staged) return staged.error();
  std::move(staged->begin(), staged->end(), std::back_inserter(files));
  return {};
}

Result<StagedFiles> stage_parts(const ModelConversion& conversion, const Model& model,
                                const std::vector<std::string>& paths, Console& console) {
  StagedFiles files;
  if (!conversion.per_component) {
    Result<void> staged = stage_part(conversion, model, paths.front(), files, console);
    if (!staged) return staged.error();
    return files;
  }
  for (std::size_t c = 0; c < paths.size(); ++c) {
    const Model part = component_of(model, ComponentId(c));
    if (part.tets.empty()) {
      console.warn({io::in_quotes(part.about.name) + " has no tets, and no file", {}});
      continue;
    }
    Result<void> staged = stage_part(conversion, part, paths[c], files, console);
    if (!staged) return staged.error();
  }
  return files;
}

std::string to_json(const Model& model, const std::vector<std::string>& paths,
                    const Console& console) {
  JsonWriter json;
  json.begin_object();
  json.member("vertices", model.points.size());
  json.member("tets", model.tets.size());
  json.member("name", model.about.name);
  json.member("unit", model.about.unit);
  json.member("components", names_of_components(model));
  json.member("written", paths);
  write_warnings(json, console.warnings());
  json.end_object();
  return json.text();
}

std::string to_text(const Model& model, const std::vector<std::string>& paths) {
  return counted(model.tets.size(), "tet") + ", " + counted(model.component_count, "component") +
         '\n' + written_line(paths);
}

// Who has a stack, and wants a solid, is told how.
Error with_way_out(Error error, const std::string& path) {
  const bool of_stack = has_input_extension(path, Contents::stack);
  if (error.code != ErrorCode::invalid_input || !of_stack) return error;
  error.message += "; reconstruct makes a model of a stack";
  return error;
}

}  // namespace

std::vector<Option> model_conversion_options() {
  const auto names = model_targets();
  return {model_format_option(),
          {"--to",
           "NAME",
           "of a model: write this format, whatever the extension of OUT",
           {},
           {names.begin(), names.end()}},
          {"--per-component", "",
           "of a model: a file for each component, OUT-NAME, by its name or number"},
          kAsciiOption,
          kCompressOption};
}

bool converts_model(const Arguments& arguments, const std::string& output) {
  for (const char* option : {"--model-format", "--to", "--per-component"}) {
    if (arguments.has(option)) return true;
  }
  const std::string extension = io::extension_of(output);
  const bool of_model = among(extension, target_extensions());
  const bool of_stack = among(extension, output_extensions(Contents::stack));
  if (of_model != of_stack) return of_model;
  const std::string& input = arguments.operand(0);
  return has_input_extension(input, Contents::model) &&
         !has_input_extension(input, Contents::stack);
}

Result<int> convert_model(const Arguments& arguments, const std::string& output, Console& console) {
  const auto conversion = conversion_of(arguments, output);
  if (!conversion) return conversion.error();
  const auto model = read_model_input(conversion->input, conversion->model_format, console);
  if (!model) return with_way_out(model.error(), conversion->input);
  if (model->tets.empty()) {
    return in_file({ErrorCode::invalid_input, "the model has no tets", {}}, conversion->input);
  }
  if (!conversion->solid && !conversion->per_component && components_touch(*model)) {
    console.warn(
        {"components have faces in common, which their boundary leaves out; "
         "--per-component gives each its own",
         {}});
  }
  if (conversion->per_component && model->component_count == 0) {
    return in_file({ErrorCode::invalid_input, "the model does not tell of components", {}},
                   conversion->input);
  }
  const std::vector<std::string> paths = outputs_for(*conversion, *model);
  if (Result<void> apart = check_parts(*conversion, paths); !apart) return apart.error();
  auto files = stage_parts(*conversion, *model, paths, console);
  if (!files) return files.error();
  const std::vector<std::string> written = paths_of(*files);
  std::string told;
  if (console.json()) {
    told = to_json(*model, written, console);
  } else if (!console.quiet()) {
    told = to_text(*model, written);
  }
  const Result<void> done = deliver_with(*files, told, console);
  if (!done) return done.error();
  return 0;
}

}  // namespace tetloft::cli
