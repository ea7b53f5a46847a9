/// The committed digests of known attempts. They change with the engine version and only with it.
///
/// Each attempt has three: its bone and its input tape tell whether the same question was asked,
/// its outputs are the answer. Where only a hand or a patient was changed on purpose, bone and tape
/// change too and the engine version stays. A hand that feels answers to the engine: its tape
/// changes with the engine as well.
#pragma once

#include <cstdint>
#include <string_view>

namespace hallux::tests {

struct GoldenHashes {
  std::string_view bone, tape, outputs;
};

inline constexpr std::int32_t golden_engine_version = 8;

inline constexpr GoldenHashes golden_tube{
    .bone = "e896492ae9dc6392ccf56bf4f9855c3c0391eae03bae8c511038e15487812285",
    .tape = "2169421a294bc0c42343e2a3c1fa4856dea089fdd87339873c9046b991df474d",
    .outputs = "f2be742a225860b284604c06e5cce885ef5913f397fa281d9417bcf4d04062d5"};

inline constexpr GoldenHashes golden_guided{
    .bone = "e896492ae9dc6392ccf56bf4f9855c3c0391eae03bae8c511038e15487812285",
    .tape = "61e4aa5ad278c5c23bf853ed6804596b0748b1c3acdadc7cd07b5c162ec2cbc3",
    .outputs = "96dc8e3731bf4b20a5e5c68123caf79d3038da7ae0d3301e91e5640fb81c305f"};

inline constexpr GoldenHashes golden_silver_expert_1{
    .bone = "d2fdd45f6706e9642dbda39ea6eb6054304701be9af430cedd788c46605f402e",
    .tape = "0a146b32690ca75e874d5f820c4f772ad80aeff04d225757e42c1ea8fb6466ef",
    .outputs = "e26f1c9f74198d3cfe69efd4b630292c60c576b4816a6ee7abe276a2f91e60f4"};

/// On the bone that generator 2 made of the same patient, kept in old/.
inline constexpr GoldenHashes golden_silver_expert_1_generator_2{
    .bone = "8875a39afe43c63726079111fe9504ea0804358329d1d3df6a4594bf10fd622a",
    .tape = "fb7a115297d39294a58e7f579456360552ecffaa66d5e634fe76b0d605806823",
    .outputs = "ecfe512c50faa8b34a7e0128fc14c500a7194b211e162526269d898e2325b595"};

}  // namespace hallux::tests
