package robotran.benchmarks

import robotran.language.Language
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.rcxrom.program.RcxProgram

/** The valid Java program [source], compiled and linked. */
internal suspend fun javaProgramOf(name: String, source: String, settings: JavaSettings = JavaSettings()): RcxProgram =
    when (
        val result = ProgramCompiler(
            ANY_TARGET,
            settings,
            language = Language.ENGLISH,
        ).compileOrThrow(Program.of(name, source))
    ) {
        is ProgramResult.Success -> result.program as RcxProgram
        is ProgramResult.Failure -> error(result.diagnostics.first().message)
    }
