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

inline constexpr std::int32_t golden_engine_version = 1;

inline constexpr GoldenHashes golden_tube{
    .bone = "e896492ae9dc6392ccf56bf4f9855c3c0391eae03bae8c511038e15487812285",
    .tape = "df1bbdc8bb27a8559e872a95573dfdb661f686044d95ff2d5bae5ac987d54b95",
    .outputs = "1ec804fd02403635c231f4b9ba94d122a085c56642da7488fd646d897d710ec1"};

inline constexpr GoldenHashes golden_silver_expert_1{
    .bone = "92dd40f750076b690889728a5d162badc10fa8890d084fcfe72d4100cbbceeca",
    .tape = "0256a76fb87757edfa5708740c2198b8b87c823b96a57bb6e98ee4397c895ffb",
    .outputs = "de608855eda74b4f20adf862eaabea93195a7e878b308b9ee1482118693f18f4"};

}  // namespace hallux::tests
