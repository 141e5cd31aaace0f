package robotran.workshop.send

import robotran.language.source.Diagnostic
import robotran.microbitlink.MicrobitBoard
import robotran.programs.Program

/** Makes of a pupil's program for the shown robot what MicroPython runs on a board. */
internal interface MicrobitPrograms {
    suspend fun build(program: Program): MicrobitTranslation
}

/** The result of translating a program for a board. */
internal sealed interface MicrobitTranslation {
    /**
     * @property python the program, which becomes `main.py`.
     * @property board that of the robot.
     * @property maxBytes the room that such a board usually has for a program.
     * @property memoryShare how full the board's memory gets, from 0 to 1; 0 if its room for files is full before.
     * @property lineOf the pupil's line of a line of the Python, both from 1; null if it has none.
     */
    class Success(
        val python: String,
        val board: MicrobitBoard,
        val maxBytes: Int,
        val memoryShare: Float = 0f,
        val lineOf: (Int) -> Int?,
    ) : MicrobitTranslation {
        val bytes: ByteArray get() = python.encodeToByteArray()
    }

    /** The program has mistakes, or is more than a board can do. [diagnostics] are never empty. */
    class Failure(val diagnostics: List<Diagnostic>) : MicrobitTranslation

    /** It is no program for a board. */
    data object NotForBoards : MicrobitTranslation
}
