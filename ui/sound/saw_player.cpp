#include "ui/sound/saw_player.h"

#include <AL/al.h>
#include <AL/alc.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace hallux::ui {

namespace {

constexpr std::size_t buffer_count = 4;
constexpr std::size_t buffer_samples = sound_rate_hz / 50;
constexpr std::chrono::milliseconds pause{5}, tone_lasts{500};
constexpr std::uint64_t noise_seed = 1;

struct CloseDevice {
  void operator()(ALCdevice* device) const { alcCloseDevice(device); }
};
struct DestroyContext {
  void operator()(ALCcontext* context) const {
    alcMakeContextCurrent(nullptr);
    alcDestroyContext(context);
  }
};

/// A sound card, a sound server, or somebody who named a driver. Without any, opening a device
/// would only make the sound libraries complain on the terminal.
bool may_have_sound() {
  if (std::getenv("ALSOFT_DRIVERS") != nullptr || std::getenv("PULSE_SERVER") != nullptr) {
    return true;
  }
  std::error_code ignored;
  if (const char* runtime = std::getenv("XDG_RUNTIME_DIR")) {
    if (std::filesystem::exists(std::filesystem::path(runtime) / "pulse" / "native", ignored)) {
      return true;
    }
  }
  // A device for playing is named pcmC0D0p.
  for (std::filesystem::directory_iterator entry("/dev/snd", ignored), end; entry != end;
       entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("pcm") && name.ends_with("p")) return true;
  }
  return false;
}

/// One source with its queue of buffers.
class Queue {
 public:
  Queue() {
    alGenSources(1, &source_);
    alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
  }
  ~Queue() {
    alSourceStop(source_);
    alSourcei(source_, AL_BUFFER, 0);
    alDeleteSources(1, &source_);
    alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
  }
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  /// A buffer that is free, or 0: first the new ones, then those that were played.
  ALuint take() {
    if (used_ < buffers_.size()) return buffers_[used_++];
    ALint played = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &played);
    if (played <= 0) return 0;
    ALuint buffer = 0;
    alSourceUnqueueBuffers(source_, 1, &buffer);
    return alGetError() == AL_NO_ERROR ? buffer : 0;
  }
  void queue_samples(ALuint buffer, std::span<const std::int16_t> samples) {
    alBufferData(buffer, AL_FORMAT_MONO16, samples.data(),
                 static_cast<ALsizei>(samples.size_bytes()), sound_rate_hz);
    alSourceQueueBuffers(source_, 1, &buffer);
  }
  /// A source whose queue ran dry has stopped.
  void keep_playing() {
    ALint state = 0;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (state != AL_PLAYING && used_ == buffers_.size()) alSourcePlay(source_);
  }

 private:
  ALuint source_ = 0;
  std::array<ALuint, buffer_count> buffers_{};
  std::size_t used_ = 0;
};

}  // namespace

SawPlayer::SawPlayer() {
  try {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  } catch (const std::system_error&) {
    state_.store(State::NoDevice, std::memory_order_release);
  }
}

SawPlayer::~SawPlayer() = default;

void SawPlayer::play(const SawTone& tone) noexcept { said_.write({tone, Clock::now()}); }

SawTone SawPlayer::tone_now() noexcept {
  const Said& said = said_.read();
  SawTone tone = said.tone;
  tone.runs = tone.runs && Clock::now() - said.at < tone_lasts;
  return tone;
}

void SawPlayer::run(const std::stop_token& stop) {
  const auto stay_silent = [&] { state_.store(State::NoDevice, std::memory_order_release); };
  if (!may_have_sound()) return stay_silent();
  const std::unique_ptr<ALCdevice, CloseDevice> device(alcOpenDevice(nullptr));
  if (!device) return stay_silent();
  const std::unique_ptr<ALCcontext, DestroyContext> context(
      alcCreateContext(device.get(), nullptr));
  if (!context || alcMakeContextCurrent(context.get()) == ALC_FALSE) return stay_silent();
  Queue queue;
  if (alGetError() != AL_NO_ERROR) return stay_silent();
  state_.store(State::Playing, std::memory_order_release);

  SawSound sound(noise_seed);
  std::array<std::int16_t, buffer_samples> samples{};
  while (!stop.stop_requested()) {
    while (const ALuint buffer = queue.take()) {
      sound.fill(tone_now(), samples);
      queue.queue_samples(buffer, samples);
      buffers_.fetch_add(1, std::memory_order_relaxed);
    }
    queue.keep_playing();
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace hallux::ui
