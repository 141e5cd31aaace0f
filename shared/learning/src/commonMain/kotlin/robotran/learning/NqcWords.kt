package robotran.learning

import robotran.language.Language
import robotran.legofirmware.assembly.CommandHelp
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi
import robotran.nqc.api.NqcApiKind
import robotran.nqc.api.usualCall
import robotran.nqc.edit.nqcHelpWords
import robotran.nqc.edit.nqcHelp as sentenceOn

private val API = NqcApi.of(FirmwareTarget.RCX2)

/** The words of NQC, then the names of its functions, values and constants, by what they are about. */
internal val nqcWords: List<String> get() = nqcHelpWords + (API.keys - nqcHelpWords.toSet())

internal fun nqcHelp(word: String, language: Language): WordHelp? = sentenceOn(word, language)?.let { sentence ->
    val known = API[word]
    val call = known?.usualCall?.takeIf { known.kind == NqcApiKind.FUNCTION }
    val example = call?.let { "task main()\n{\n    $it;\n}\n" }
    WordHelp(known?.name ?: word, sentence, language, listOf(known?.signature ?: word), example)
}

/** The help on a command of LEGO's assembly. */
internal fun lasmHelp(word: String, language: Language): WordHelp? = CommandHelp.of(word, language)?.let { help ->
    WordHelp(help.mnemonic, help.sentence, language, help.forms, example = null)
}
