package robotran.cli.microbit

import robotran.brick.kind.BrickKind
import robotran.cli.files.FileContent
import robotran.cli.files.readFile
import robotran.cli.hub.PythonOfFile
import robotran.cli.messages.CommandMessages
import robotran.console.ExitCode
import robotran.language.Language
import robotran.microbit.model.MicrobitModel
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.sentences.sentence
import java.nio.file.Path

/** A `.hex` with MicroPython and a program. */
internal sealed interface HexOfFile {
    /**
     * @property text the whole file.
     * @property python the program inside.
     * @property bytes the size of the program.
     * @property maxBytes the room for one.
     * @property warnings what the board does nearly the same, one line each.
     */
    class Success(val text: String, val python: String, val maxBytes: Int, val warnings: List<String>) : HexOfFile {
        val bytes: Int get() = python.encodeToByteArray().size
    }

    /** @property lines what is wrong, one line each. */
    class Failure(val lines: List<String>, val code: ExitCode) : HexOfFile
}

/**
 * Puts [program], which was translated for a micro:bit, into the file [microPython]. What the board cannot do is a mistake.
 *
 * @param brick the micro:bit that it was translated for.
 * @param microPython null if the user has named none.
 */
internal fun hexOf(program: PythonOfFile, brick: BrickKind, microPython: String?, language: Language): HexOfFile {
    val python = when (program) {
        is PythonOfFile.Failure -> return HexOfFile.Failure(program.lines, program.code)
        is PythonOfFile.Success -> program
    }
    if (python.lost.isNotEmpty()) return HexOfFile.Failure(python.lost, ExitCode.PROGRAM_FAILED)
    val name = microPython ?: return badInput(CommandMessages.of(language).microPythonMissing())
    val bytes = when (val read = readFile(Path.of(name), language)) {
        is FileContent.Failure -> return badInput(read.reason)
        is FileContent.Success -> read.bytes
    }
    val file = when (val read = MicroPythonFile.read(bytes.decodeToString())) {
        is ImageResult.Failure -> return badInput("$name: ${read.error.sentence(language)}")
        is ImageResult.Success -> read.value
    }
    (file.imageFor(boardOf(brick)) as? ImageResult.Failure)?.let {
        return badInput("$name: ${it.error.sentence(language)}")
    }
    val text = python.translation.python
    return when (val filled = file.textWith(mapOf(MAIN_FILE to text.encodeToByteArray()))) {
        is ImageResult.Failure -> HexOfFile.Failure(listOf(filled.error.sentence(language)), ExitCode.PROGRAM_FAILED)

        is ImageResult.Success ->
            HexOfFile.Success(filled.value, text, file.smallestImage.room.largestMain, python.changed)
    }
}

private fun boardOf(brick: BrickKind): MicrobitBoard = when (MicrobitModel.of(brick)) {
    MicrobitModel.V1 -> MicrobitBoard.V1
    MicrobitModel.V2 -> MicrobitBoard.V2
    null -> error("$brick is no micro:bit.")
}

private fun badInput(reason: String) = HexOfFile.Failure(listOf(reason), ExitCode.BAD_INPUT)
