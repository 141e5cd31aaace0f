package robotran.cli.legofirmware

import kotlinx.coroutines.runBlocking
import robotran.cli.files.NamedProgram
import robotran.cli.input.lineOf
import robotran.cli.messages.CommandMessages
import robotran.console.ExitCode
import robotran.language.Language
import robotran.legofirmware.image.RcxImage
import robotran.programs.FirmwareSettings
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.firmwareImage
import robotran.projects.PENBOT_TARGET

/** The result of compiling a program for LEGO's own firmware. */
internal sealed interface FirmwareImageOfFile {
    /** @property warnings one line each. */
    class Success(val image: RcxImage, val warnings: List<String>) : FirmwareImageOfFile

    /** @property lines what is wrong, one line each. */
    class Failure(val lines: List<String>, val code: ExitCode) : FirmwareImageOfFile
}

/** Compiles [program], which must be for LEGO's own firmware. */
internal fun firmwareImageOf(
    program: NamedProgram,
    settings: FirmwareSettings,
    language: Language,
): FirmwareImageOfFile {
    val compiler = ProgramCompiler(PENBOT_TARGET, language = language, firmware = settings)
    return when (val result = runBlocking { compiler.compileOrThrow(program.source) }) {
        is ProgramResult.Success -> FirmwareImageOfFile.Success(
            checkNotNull(result.firmwareImage) { "${program.path} is not for LEGO's firmware." },
            result.warnings.map { CommandMessages.of(language).warning(lineOf(program, it)) },
        )

        is ProgramResult.Failure -> FirmwareImageOfFile.Failure(
            result.diagnostics.map { lineOf(program, it) },
            ExitCode.PROGRAM_FAILED,
        )
    }
}
