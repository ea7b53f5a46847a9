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

inline constexpr std::int32_t golden_engine_version = 6;

inline constexpr GoldenHashes golden_tube{
    .bone = "e896492ae9dc6392ccf56bf4f9855c3c0391eae03bae8c511038e15487812285",
    .tape = "eb5f93028a9fd6b3fb37a9887f785bb62bc3933814ccb18c039c24ce9a0c61d1",
    .outputs = "9e936fb27377d9b5adaa7d98e1eb058ade24c2c6cff7d4c506025960f1ceb899"};

inline constexpr GoldenHashes golden_guided{
    .bone = "e896492ae9dc6392ccf56bf4f9855c3c0391eae03bae8c511038e15487812285",
    .tape = "61e4aa5ad278c5c23bf853ed6804596b0748b1c3acdadc7cd07b5c162ec2cbc3",
    .outputs = "b62ea0e134a7c1cb74234c96612dc3a37284e38aa470e204f5b5864e802f3c94"};

inline constexpr GoldenHashes golden_silver_expert_1{
    .bone = "d2fdd45f6706e9642dbda39ea6eb6054304701be9af430cedd788c46605f402e",
    .tape = "0a146b32690ca75e874d5f820c4f772ad80aeff04d225757e42c1ea8fb6466ef",
    .outputs = "e2ab88d907e20e07c719100c1c85809f3fbd0848e471db7751bbbc3e2422eb0a"};

/// On the bone that generator 2 made of the same patient, kept in old/.
inline constexpr GoldenHashes golden_silver_expert_1_generator_2{
    .bone = "8875a39afe43c63726079111fe9504ea0804358329d1d3df6a4594bf10fd622a",
    .tape = "fb7a115297d39294a58e7f579456360552ecffaa66d5e634fe76b0d605806823",
    .outputs = "56e5d2465a9c9ab2d8a23523bd7daba01713873d97a62f0947da9dfaad949ca0"};

}  // namespace hallux::tests
