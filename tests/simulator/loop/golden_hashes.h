/// The committed digests of known attempts. They change with the engine version and only with it.
///
/// Each attempt has three: its bone and its input tape tell whether the same question was asked, its outputs are the
/// answer. Where only a hand or a patient was changed on purpose, bone and tape change too and the engine version stays.
#pragma once

#include <cstdint>
#include <string_view>

namespace hallux::tests {

struct GoldenHashes {
  std::string_view bone, tape, outputs;
};

inline constexpr std::int32_t golden_engine_version = 2;

inline constexpr GoldenHashes golden_tube{
    .bone = "e896492ae9dc6392ccf56bf4f9855c3c0391eae03bae8c511038e15487812285",
    .tape = "8fb15a6c049c65fed5d61e4f58524b369d5b9fd62a864a95417a13432a1380f9",
    .outputs = "43a9e0d106c5549b6f7c31ea26fffa0e43c62b1fac7bea1b3071f55b3f073551"};

inline constexpr GoldenHashes golden_silver_expert_1{
    .bone = "8875a39afe43c63726079111fe9504ea0804358329d1d3df6a4594bf10fd622a",
    .tape = "f179696853d79a15d6adb5cd08b9eba16ce7fb7924cae18ebdbe4e09e244cef0",
    .outputs = "a30b0b281cb64f3f2c657030f4a0497b52a47439ca1d1807278a7081dffcbc82"};

}  // namespace hallux::tests
