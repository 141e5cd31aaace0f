package robotran.workshop.programs

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.listing.assemblyListing
import robotran.robolang.RobolangProgram
import robotran.robolang.messages.NqcTranslationMessages
import robotran.robolang.nqc.translateToNqc
import robotran.robolang.translate.LineMap
import robotran.robolang.translate.translateRobolang
import robotran.workshop.state.ProgramTranslation
import robotran.workshop.state.PupilProgram
import robotran.workshop.state.SourceLine
import robotran.workshop.state.TranslationKind
import robotran.workshop.state.TranslationRemark

/** This program as Java for its brick. */
internal fun RobolangProgram.asJava(file: String): ProgramTranslation {
    val translation = translateRobolang(this)
    val origins = originsOf(translation.java, translation.lineMap, file)
    return ProgramTranslation(
        TranslationKind.JAVA,
        ProgramLanguage.JAVA,
        translation.fileName,
        translation.java,
        origins,
    )
}

/** This program as NQC, with remarks in [language]. */
internal fun RobolangProgram.asNqc(file: String, language: Language): ProgramTranslation {
    val translation = translateToNqc(this, NqcTranslationMessages.of(language))
    return ProgramTranslation(
        TranslationKind.NQC,
        ProgramLanguage.NQC,
        translation.fileName,
        translation.nqc,
        originsOf(translation.nqc, translation.lineMap, file),
        translation.remarks.map { TranslationRemark(it.range.line, it.message) },
    )
}

/** The commands of this program, which was compiled from the files of [written]. */
internal fun FirmwareProgram.asAssembly(written: PupilProgram): ProgramTranslation {
    val listing = image.assemblyListing()
    val origins = arrayOfNulls<SourceLine>(listing.text.count { it == '\n' } + 1)
    for (chunk in ChunkKind.entries.flatMap { kind -> List(kind.limit) { ChunkId(kind, it) } }) {
        for (command in listing.lines.linesOf(chunk)) {
            val source = lines.lineOf(chunk, command.address) ?: continue
            origins[command.line - 1] = SourceLine(source.file ?: written.name, source.line)
        }
    }
    val fileName = written.name.removeSuffix(written.language.extension) + ProgramLanguage.LASM.extension
    return ProgramTranslation(
        TranslationKind.ASSEMBLY,
        ProgramLanguage.LASM,
        fileName,
        listing.text,
        origins.toList(),
    )
}

private fun originsOf(text: String, map: LineMap, file: String): List<SourceLine?> =
    List(text.count { it == '\n' } + 1) { line -> map.robolangLineOf(line + 1)?.let { SourceLine(file, it) } }
