// Names that look alike: other Unicode forms, other cases of letters, and code pages from before Unicode.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

// UTF-8 in its composed form (NFC): "o" with a mark becomes one letter. Other bytes are left as they are.
std::string composed(std::string_view text);
// Composed, in lower case by Unicode's folding, without differences of form (NFKC), marks that are not seen, and kinds of dashes and
// spaces: names with equal ones look alike. Bytes that are no
// UTF-8 have ASCII in lower case only.
std::string folded(std::string_view text);

// Whether two names look alike, spaces being as good as _, the bytes of one or both perhaps of a code page (Western, Japanese, Chinese,
// Korean, Cyrillic ...).
bool looksAlike(std::string_view a, std::string_view b);

// UTF-8 of bytes in a code page, as iconv calls it ("CP1252", "UTF-16LE"); nothing where they are no text in it.
std::optional<std::string> fromCodePage(const char* page, std::string_view bytes);

// The file or folder itself when it is there, else the one of the same folder whose name looks alike; nothing without any.
std::optional<std::filesystem::path> thatLooksLike(const std::filesystem::path& file);

} // namespace relievo
