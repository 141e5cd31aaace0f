package robotran.programs

import robotran.languagesupport.simpleName
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.image.LineTable
import robotran.nqc.NqcOptions
import robotran.nqc.NqcProgram
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages

internal class NqcProgramCompiler(private val settings: CompilerSettings) : LanguageCompiler {
    override fun compile(program: Program): ProgramResult {
        val main = program.files.first()
        val options = NqcOptions(settings.firmware.target, settings.firmware.isOldNqc, includedFiles(program))
        val messages = NqcMessages.of(settings.language)
        return when (val result = compileNqc(simpleName(main.name), main.text, options, messages)) {
            is NqcResult.Failure -> ProgramResult.Failure(result.diagnostics.map { named(program, it) })

            is NqcResult.Success -> ready(
                program.name,
                result.program.image,
                linesOf(result.program, isOneFile = program.files.size == 1),
                result.warnings.map { named(program, it) },
                settings.language,
                result.program.variables,
            )
        }
    }

    /** The texts by the names that `#include` gives them, whose folders may be others than in [program]. */
    private fun includedFiles(program: Program): Map<String, String> {
        val texts = program.files.drop(1).associate { simpleName(it.name) to it.text }
        val included = program.files.flatMap { program.language.support.files.includes(it.text) }
        return texts + included.mapNotNull { name -> texts[simpleName(name)]?.let { name to it } }
    }

    /** What the API does belongs to no line of the pupil's. */
    private fun linesOf(program: NqcProgram, isOneFile: Boolean) = LineTable(
        program.lines.mapValues { (_, lines) ->
            lines.filter { it.range.line > 0 }
                .map { CodeLine(it.address, it.range.line, simpleName(it.range.file).takeUnless { isOneFile }) }
        },
    )
}
