package robotran.cli.image

import kotlinx.coroutines.runBlocking
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.readProgramFiles
import robotran.cli.input.lineOf
import robotran.cli.messages.CommandMessages
import robotran.console.ExitCode
import robotran.language.Language
import robotran.lejoslinker.LejosImage
import robotran.programs.ImageBuildResult
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.tinyvm.config.LejosVersion

/** The result of building an image of program files. */
internal sealed interface ImageOfFiles {
    /** @property warnings one line each. */
    class Success(val image: LejosImage, val warnings: List<String>) : ImageOfFiles

    /** @property lines what is wrong, one line each. */
    class Failure(val lines: List<String>, val code: ExitCode) : ImageOfFiles
}

/** Builds one image of the programs in [files] for leJOS [version]. */
internal fun buildImage(files: List<String>, language: Language, version: LejosVersion): ImageOfFiles =
    when (val read = readProgramFiles(files, CommandMessages.of(language))) {
        is ProgramFiles.Success -> when (val built = buildImageOf(read.programs, language, version)) {
            is ImageOfFiles.Success -> ImageOfFiles.Success(built.image, read.notes + built.warnings)
            is ImageOfFiles.Failure -> ImageOfFiles.Failure(read.notes + built.lines, built.code)
        }

        is ProgramFiles.Failure -> ImageOfFiles.Failure(listOf(read.reason), ExitCode.BAD_INPUT)
    }

/** Builds one image of [programs] for leJOS [version]. */
internal fun buildImageOf(programs: List<NamedProgram>, language: Language, version: LejosVersion): ImageOfFiles {
    val messages = CommandMessages.of(language)
    val compiler = ProgramCompiler(PENBOT_TARGET, language = language)
    return when (val result = runBlocking { compiler.buildImage(programs.map { it.source }, version) }) {
        is ImageBuildResult.Success -> ImageOfFiles.Success(
            result.image,
            result.warnings.map { messages.warning(lineOf(programs, it)) },
        )

        is ImageBuildResult.Failure -> ImageOfFiles.Failure(
            result.diagnostics.map { lineOf(programs, it) },
            ExitCode.PROGRAM_FAILED,
        )

        is ImageBuildResult.NotLoaded -> throw result.cause
    }
}
