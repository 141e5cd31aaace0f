package robotran.robolang.nqc

import robotran.language.source.SourceRange
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangRcxProgram
import robotran.robolang.messages.NqcTranslationMessages
import robotran.robolang.translate.JavaWriter

/**
 * Translates [program] to NQC, as far as whole numbers of 16 bits and LEGO's firmware carry it. Never throws.
 *
 * @param messages the notes in the pupil's language.
 */
fun translateToNqc(program: RobolangProgram, messages: NqcTranslationMessages): NqcTranslation {
    val notes = TranslationNotes(messages)
    val writer = if (program is RobolangRcxProgram) {
        NqcFile(program, program.robot, notes).write()
    } else {
        val message = notes.lost(SourceRange(1, 1, 1), messages.otherBrick())
        JavaWriter().apply { line("// $message") }
    }
    return NqcTranslation(fileNameOf(program.name), writer.text, writer.lineMap, notes.inOrder())
}

private fun fileNameOf(program: String): String =
    program.substringAfterLast('/').substringAfterLast('\\').removeSuffix(".robo").ifEmpty { "program" } + ".nqc"
