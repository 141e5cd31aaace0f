package robotran.programs

import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.listing.assemblyListing
import robotran.robolang.RobolangProgram
import robotran.robolang.messages.NqcTranslationMessages
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.nqc.translateToNqc
import robotran.robolang.python.pythonOf
import robotran.robolang.translate.LineMap
import robotran.robolang.translate.translateRobolang

/** Shows programs in one language as programs in others. */
internal fun interface ProgramTranslator {
    /**
     * The program [written], which was compiled to [compiled], in the language [to], which is one of the translations of
     * its own. Notes are in [language].
     */
    fun translate(written: Program, compiled: BrickProgram, to: ShownLanguage, language: Language): ProgramTranslation
}

/** Robolang becomes Java for its brick, NQC, or Python for its hub or board. */
internal val ROBOLANG_TRANSLATOR = ProgramTranslator { written, compiled, to, language ->
    val program = compiled as RobolangProgram
    when (to) {
        ShownLanguage.NQC -> program.asNqc(written.name, language)
        ShownLanguage.PYTHON -> program.asPython(written.name, language)
        else -> program.asJava(written.name)
    }
}

private fun RobolangProgram.asJava(file: String): ProgramTranslation {
    val translation = translateRobolang(this)
    val origins = originsOf(translation.java, translation.lineMap, file)
    return ProgramTranslation(ShownLanguage.JAVA, translation.fileName, translation.java, origins)
}

private fun RobolangProgram.asNqc(file: String, language: Language): ProgramTranslation {
    val translation = translateToNqc(this, NqcTranslationMessages.of(language))
    return ProgramTranslation(
        ShownLanguage.NQC,
        translation.fileName,
        translation.nqc,
        originsOf(translation.nqc, translation.lineMap, file),
        translation.notes.map { TranslationNote(it.range.line, it.message) },
    )
}

private fun RobolangProgram.asPython(file: String, language: Language): ProgramTranslation {
    val python = pythonOf(this, PythonTranslationMessages.of(language))
    val translation = checkNotNull(python) { "Only a robot that runs Python shows it." }
    return ProgramTranslation(
        ShownLanguage.PYTHON,
        translation.fileName,
        translation.python,
        originsOf(translation.python, translation.lineMap, file),
        translation.notes.map { TranslationNote(it.range.line, it.message) },
    )
}

/** NQC becomes the commands that LEGO's firmware runs. */
internal val NQC_TRANSLATOR = ProgramTranslator { written, compiled, _, _ ->
    val program = compiled as FirmwareProgram
    val listing = program.image.assemblyListing()
    val origins = arrayOfNulls<SourceLine>(listing.text.count { it == '\n' } + 1)
    for (chunk in ChunkKind.entries.flatMap { kind -> List(kind.limit) { ChunkId(kind, it) } }) {
        for (command in listing.lines.linesOf(chunk)) {
            val source = program.lines.lineOf(chunk, command.address) ?: continue
            origins[command.line - 1] = SourceLine(source.file ?: written.name, source.line)
        }
    }
    val fileName = written.name.removeSuffix(written.language.extension) + ShownLanguage.LASM.extension
    ProgramTranslation(ShownLanguage.LASM, fileName, listing.text, origins.toList())
}

private fun originsOf(text: String, map: LineMap, file: String): List<SourceLine?> =
    List(text.count { it == '\n' } + 1) { line -> map.sourceLineOf(line + 1)?.let { SourceLine(file, it) } }
