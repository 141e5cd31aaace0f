package robotran.nqc

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.SourceFix
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.messages.NqcMessages
import kotlin.test.fail

/** The errors of [source], or its warnings if there are none. */
internal fun diagnosticsOf(source: String, options: NqcOptions = NqcOptions()): List<Diagnostic> =
    when (val result = compileNqc("test.nqc", source, options, messages = NqcMessages.of(Language.ENGLISH))) {
        is NqcResult.Success -> result.warnings
        is NqcResult.Failure -> result.diagnostics
    }

/** The program of [source], which must have no errors. */
internal fun programOf(source: String, options: NqcOptions = NqcOptions()): NqcProgram =
    when (val result = compileNqc("test.nqc", source, options, messages = NqcMessages.of(Language.ENGLISH))) {
        is NqcResult.Success -> result.program
        is NqcResult.Failure -> fail(result.diagnostics.joinToString("\n"))
    }

/** The code of the main task as hexadecimal bytes, without what sets the motors up. */
internal fun codeOf(source: String, target: FirmwareTarget = FirmwareTarget.RCX2): String =
    programOf("#pragma noinit\n$source", NqcOptions(target)).image.chunks.last { it.id.number == 0 }.code.toString()

/** [source] after [fix]. */
internal fun applied(source: String, fix: SourceFix): String {
    val lines = source.lines().toMutableList()
    val line = lines[fix.range.line - 1]
    val changed =
        line.substring(0, fix.range.column - 1) + fix.replacement + line.substring(fix.range.endColumn - 1)
    lines[fix.range.line - 1] = changed
    return lines.joinToString("\n")
}
