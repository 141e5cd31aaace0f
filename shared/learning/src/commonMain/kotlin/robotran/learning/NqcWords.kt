package robotran.learning

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi

private val API = NqcApi.of(FirmwareTarget.RCX2)

/** The names of NQC's functions, values and constants, by what they are about. */
internal val nqcWords: List<String> get() = API.keys.toList()

internal fun nqcHelp(word: String, language: Language): WordHelp? = API[word]?.let { entry ->
    WordHelp(entry.name, entry.help(language), language, listOf(entry.signature), example = null)
}
