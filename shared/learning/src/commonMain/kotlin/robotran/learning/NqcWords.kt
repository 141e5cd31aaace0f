package robotran.learning

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi
import robotran.nqc.edit.nqcHelp as sentenceOn

private val API = NqcApi.of(FirmwareTarget.RCX2)

/** The names of NQC's functions, values and constants, by what they are about. */
internal val nqcWords: List<String> get() = API.keys.toList()

/** The help on a name or a word of NQC. */
internal fun nqcHelp(word: String, language: Language): WordHelp? = sentenceOn(word, language)?.let { sentence ->
    WordHelp(word, sentence, language, listOf(API[word]?.signature ?: word), example = null)
}
