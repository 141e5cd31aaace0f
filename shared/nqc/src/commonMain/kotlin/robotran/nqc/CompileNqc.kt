package robotran.nqc

import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.messages.NqcMessages

/**
 * Compiles an NQC program to the same image as NQC 4.1, but for what `docs/nqc.md` lists. Never throws.
 *
 * @param name the name of the file, also in the ranges of diagnostics.
 * @param source the text of the program, with any line ends.
 * @param messages the diagnostics in the pupil's language.
 */
fun compileNqc(name: String, source: String, options: NqcOptions = NqcOptions(), messages: NqcMessages): NqcResult {
    val sink = DiagnosticSink(messages)
    val files = options.files + (name to source)
    for ((file, text) in files) {
        if (text.length > NqcLimits.SOURCE_CHARACTERS) {
            val message = messages.sourceTooLong(NqcLimits.SOURCE_CHARACTERS)
            sink.report(NqcDiagnosticCode.SOURCE_TOO_LONG, SourceRange(1, 1, 1, file), message)
        }
    }
    val program = if (sink.hasErrors) null else Compilation(name, files, options, sink).compile()
    return if (sink.hasErrors || program == null) {
        NqcResult.Failure(sink.inSourceOrder(Severity.ERROR, name))
    } else {
        NqcResult.Success(program, sink.inSourceOrder(Severity.WARNING, name))
    }
}
