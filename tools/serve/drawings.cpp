// SPDX-License-Identifier: Apache-2.0
#include "serve/drawings.hpp"

#include <poll.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "foreign/sandbox.hpp"
#include "importer/read_model.hpp"
#include "serve/seen_model.hpp"

namespace epura {

namespace {

constexpr std::size_t max_at_a_time = 2;
constexpr double max_megabytes_of_svg = 500;

http::Reply error_reply(unsigned status, std::string_view reason, std::string_view hint = "") {
  return {status, "application/json", std::make_shared<const std::string>(error_json(reason, hint)), {}};
}

// Headers hold neither lines nor letters of all languages. RFC 3986, 2.1.
std::string percent_encoded(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte >= ' ' && byte < 0x7f && c != '%';
    if (is_plain)
      encoded += c;
    else
      (encoded += '%') += {digits[byte / 16], digits[byte % 16]};
  }
  return encoded;
}

// Each message begins with the name of the program.
std::string without_program(std::string_view messages) {
  std::string text;
  for (std::string_view line : split(messages, '\n')) {
    constexpr std::string_view program = "epura: ";
    if (line.starts_with(program)) line.remove_prefix(program.size());
    if (!line.empty()) (text += text.empty() ? "" : "\n") += line;
  }
  return text;
}

http::Reply reply_of(ProgramRun run, double megabytes) {
  const std::string messages = without_program(run.err);
  const bool is_drawn = run.code == 0 || run.code == found_wrong_exit_code || run.code == partial_exit_code;
  if (is_drawn && !run.out.empty()) {
    http::Reply reply{200, "image/svg+xml", std::make_shared<const std::string>(std::move(run.out)), {}};
    if (!messages.empty()) reply.headers.emplace_back("Epura-Messages", percent_encoded(messages));
    return reply;
  }
  if (run.code > 128)
    return error_reply(500, "the process that draws was ended by signal " + std::to_string(run.code - 128),
                       "it may need more than " + format_number(megabytes) + " MB: --job-memory");
  return error_reply(400, messages);
}

}  // namespace

std::vector<std::string> words_of_drawing(const ServeOptions& options, const std::string& projection) {
  std::vector<std::string> words{"draw"};
  words.insert(words.end(), options.draw.models.begin(), options.draw.models.end());
  words.insert(words.end(), options.words.begin(), options.words.end());
  for (const char* word : {"--output=-", "--format=svg", "--progress=never"}) words.emplace_back(word);
  words.push_back("--projection=" + projection);
  if (foreign::reason_for_no_sandbox().empty()) words.emplace_back("--sandbox=on");
  return words;
}

std::pair<std::string, std::string> command_around_projection(const ServeOptions& options) {
  std::string before = "epura draw";
  for (const std::string& word : options.draw.models) before += " " + for_shell(word);
  for (const std::string& word : options.words) before += " " + for_shell(word);
  const std::string path = importer::parse_model_request(options.draw.models.front()).path;
  return {before + " --projection ", " -o " + for_shell(std::filesystem::path(path).stem().string() + ".svg")};
}

Drawings::Drawings(const ServeOptions& options, SendReply reply) : options_(options), reply_(std::move(reply)) {}

void Drawings::ask(std::uint64_t request, const std::string& page, const std::string& projection) {
  const auto is_older = [&](const Job& job) { return !page.empty() && job.page == page; };
  for (const Job& job : jobs_)
    if (is_older(job)) reply_(job.request, error_reply(409, "a newer request has taken its place"));
  jobs_.remove_if(is_older);
  jobs_.push_back({request, page, projection});
  look();
}

std::vector<int> Drawings::descriptors() {
  std::vector<int> all;
  for (Job& job : jobs_)
    if (job.process) all.push_back(job.process->descriptor());
  return all;
}

Drawings::Clock::time_point Drawings::deadline() const {
  Clock::time_point first = Clock::time_point::max();
  for (const Job& job : jobs_)
    if (job.process) first = std::min(first, job.until);
  return first;
}

void Drawings::look() {
  jobs_.remove_if([this](Job& job) { return job.process && has_ended(job); });
  std::size_t running = 0;
  jobs_.remove_if([&](Job& job) {
    const bool goes_on = job.process || running == max_at_a_time || start(job);
    running += job.process ? 1 : 0;
    return !goes_on;
  });
}

bool Drawings::start(Job& job) {
  const ProcessLimits limits{options_.job_memory, max_megabytes_of_svg};
  try {
    job.process = std::make_unique<EpuraProcess>(words_of_drawing(options_, job.projection), limits);
    static_cast<void>(job.process->descriptor());
  } catch (const Error& error) {
    job.process.reset();
    reply_(job.request, error_reply(500, error.what(), error.hint()));
    return false;
  }
  job.until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.job_time));
  return true;
}

bool Drawings::has_ended(Job& job) {
  pollfd end{job.process->descriptor(), POLLIN, 0};
  if (::poll(&end, 1, 0) > 0) {
    reply_(job.request, reply_of(job.process->wait(), options_.job_memory));
    return true;
  }
  if (Clock::now() < job.until) return false;
  reply_(job.request, error_reply(503, "the drawing takes more than " + format_number(options_.job_time) + " s",
                                  "run the command below, or serve with a larger --job-time"));
  return true;
}

}  // namespace epura
