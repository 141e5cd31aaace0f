package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import robotran.programs.Mistake
import robotran.rom.Brick

/**
 * The pupil's programs as they are shown.
 *
 * @property programs in the order of the brick's slots; never empty.
 * @property shownProgram the one of [programs] that is shown, from 0.
 * @property shownFile the file of it that is shown, from 0.
 * @property closedProgram a program that was taken away and can be brought back.
 * @property mistakes what is wrong with the program shown, in its order.
 * @property reading how far the programs were read since they were changed.
 * @property mistakePointedOut whether somebody wanted to run a program with mistakes since it was last edited.
 */
@Immutable
data class ProgramsState(
    val programs: List<PupilProgram>,
    val shownProgram: Int = 0,
    val shownFile: Int = 0,
    val closedProgram: PupilProgram? = null,
    val mistakes: List<Mistake> = emptyList(),
    val reading: ProgramReading = ProgramReading.DONE,
    val mistakePointedOut: Boolean = false,
) {
    val program: PupilProgram get() = programs[shownProgram]
    val file: ProgramFile get() = program.files[shownFile]

    /** Whether the brick has a slot for one more program. */
    val hasRoom: Boolean get() = programs.size < Brick.MOST_PROGRAMS
}

/** How far programs were read since they were changed. */
enum class ProgramReading {
    /** All of them. */
    DONE,

    /** A Java program waits for a pause in the typing. */
    WAITING,

    /** The compiler is fetched or at work, and somebody waits for it. */
    COMPILING,

    /** The compiler could not be fetched; Run tries again. */
    NO_COMPILER,
}
