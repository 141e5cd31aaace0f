package robotran.nqc.edit

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.ApiHelp
import robotran.nqc.api.NqcApi
import robotran.nqc.api.apiTexts

/**
 * One sentence about [word]: a word of the language, or a name of the API for [target]. Null if there is none.
 *
 * @param isOld whether the API is that of NQC 1.3.
 */
fun nqcHelp(
    word: String,
    language: Language,
    target: FirmwareTarget = FirmwareTarget.RCX2,
    isOld: Boolean = false,
): String? = NqcApi.of(target, isOld)[word]?.help(language) ?: WORDS[word]?.of(language)

/** The words of the language that have help, by name. */
val nqcHelpWords: List<String> get() = WORDS.keys.toList()

private val WORDS: Map<String, ApiHelp> by lazy {
    apiTexts.getValue("words.md").removePrefix(HEADING).split("\n$HEADING")
        .associate { it.substringBefore('\n') to ApiHelp(it) }
}

private const val HEADING = "# "
