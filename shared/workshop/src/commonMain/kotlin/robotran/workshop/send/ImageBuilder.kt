package robotran.workshop.send

import robotran.language.source.Diagnostic
import robotran.legofirmware.image.RcxImage
import robotran.programs.Program

/** Makes of a pupil's program what the firmware of a real brick runs. */
interface ImageBuilder {
    /** Builds [program], which may take seconds, most of them for loading the Java compiler. */
    suspend fun build(program: Program): ProgramImageResult
}

/** A program as it is sent. */
sealed interface BuiltProgram {
    /** @property maxBytes how large an image a brick with the project's version of leJOS takes. */
    class Lejos(val image: ByteArray, val maxBytes: Int) : BuiltProgram

    /** A program for LEGO's own firmware. */
    class Lego(val image: RcxImage) : BuiltProgram
}

/** The result of building an image. */
sealed interface ProgramImageResult {
    data class Success(val program: BuiltProgram) : ProgramImageResult

    /** The program has mistakes, or is more than a brick can take. [diagnostics] are never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : ProgramImageResult

    /** The Java compiler could not be loaded. */
    data object NoCompiler : ProgramImageResult

    /** The compiler crashed on the program because of a bug. */
    data object CompilerFailed : ProgramImageResult
}
