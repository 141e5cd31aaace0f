package robotran.benchmarks

import robotran.language.Language
import robotran.programs.JavaSettings
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.rcxrom.program.RcxProgram

/** The valid Java program [source], compiled and linked. */
internal suspend fun javaProgramOf(name: String, source: String, settings: JavaSettings = JavaSettings()): RcxProgram =
    when (
        val result = ProgramCompiler(
            ANY_TARGET,
            settings,
            language = Language.ENGLISH,
        ).read(ProgramSource.Java(name, listOf(SourceFile(name, source))))
    ) {
        is ProgramResult.Ready -> result.program as RcxProgram
        is ProgramResult.HasErrors -> error(result.diagnostics.first().message)
    }
