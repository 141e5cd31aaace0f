package robotran.programs

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.languagesupport.ParsedSource
import robotran.programs.messages.ProgramMessages
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.python.pythonOf
import robotran.robolang.syntax.ParsedText

internal class RobolangProgramCompiler(private val settings: CompilerSettings) : LanguageCompiler {
    override val tellsOtherBrick get() = true

    override fun compile(program: Program): ProgramResult = resultOf(robolang(program))

    override fun compile(program: Program, read: ParsedSource): ProgramResult =
        resultOf(robolang(program, read as? ParsedText))

    private fun resultOf(result: RobolangResult): ProgramResult = when (result) {
        is RobolangResult.Success -> ProgramResult.Success(result.program, result.warnings + lossesOf(result.program))
        is RobolangResult.Failure -> ProgramResult.Failure(result.diagnostics)
    }

    /** What a real hub or board cannot do of [program], and what to do instead. */
    private fun lossesOf(program: RobolangProgram): List<Diagnostic> =
        pythonOf(program, PythonTranslationMessages.of(settings.language))?.notes.orEmpty().filter { it.isLost }
            .map { Diagnostic(Severity.WARNING, program.name, it.range, it.message) }

    /** Compiles the Java that [program] becomes. */
    override suspend fun compileToClasses(
        program: Program,
        java: suspend () -> TimedJavaProgramCompiler,
    ): CompiledSource = when (val result = robolang(program)) {
        is RobolangResult.Success -> TranslatedProgramCompiler(java(), ProgramMessages.of(settings.language))
            .compile(program.name, result.program, result.warnings)

        is RobolangResult.Failure -> CompiledSource.Failure(result.diagnostics)
    }

    private fun robolang(program: Program, read: ParsedText? = null) =
        compileRobolang(program.name, program.text, settings.target, RobolangMessages.of(settings.language), read)
}
