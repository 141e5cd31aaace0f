package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.programs.ProgramDiagnostic
import robotran.rcxrom.Brick
import robotran.robolang.translate.Translation
import robotran.textediting.text.Draft
import robotran.world.RobotPlacement

/**
 * The programs as they are shown.
 *
 * @property robots those of the world, the pupil's own first.
 * @property shownRobot the name of the one whose programs are shown.
 * @property isWorldsOwn whether they are what the world gives this robot, and nobody has changed them.
 * @property programs in the order of the brick's slots; never empty.
 * @property shownProgram the one of [programs] that is shown, from 0.
 * @property shownFile the file of it that is shown, from 0.
 * @property draft the text of that file, and what is selected in it.
 * @property breakpoints the lines of that file, from 1, that the program is to stop before.
 * @property closed the name of the program, or the class of one, that was taken away last and is kept; null if nothing
 * is.
 * @property closedShown whether that is told; false once somebody has put it away.
 * @property canReopen whether there is room to bring it back.
 * @property diagnostics what is wrong with the program shown, in its order; empty as long as it was not read.
 * @property notes what is told about its lines, mistakes and doubts; as long as it was not read, what was told before.
 * @property reading how far the programs were read since they were changed.
 * @property mistakePointedOut whether somebody wanted to run a program with mistakes since it was last edited.
 * @property translationShown whether a Robolang program's translation is shown.
 * @property translation the program as Java; null if there is none, or it is not shown.
 * @property findingWanted whether the search in the file is to be opened.
 * @property isTranslated whether [translation] is that of the program as it is now, not as it was before its mistakes.
 */
@Immutable
data class ProgramsState(
    val robots: List<RobotPlacement>,
    val shownRobot: String,
    val isWorldsOwn: Boolean,
    val programs: List<PupilProgram>,
    val shownProgram: Int,
    val shownFile: Int,
    val draft: Draft,
    val canUndo: Boolean,
    val canRedo: Boolean,
    val breakpoints: Set<Int>,
    val closed: String?,
    val closedShown: Boolean,
    val canReopen: Boolean,
    val diagnostics: List<ProgramDiagnostic>,
    val notes: List<InlineDiagnostic>,
    val reading: ProgramReading,
    val mistakePointedOut: Boolean,
    val translationShown: Boolean,
    val translation: Translation?,
    val isTranslated: Boolean,
    val findingWanted: Boolean,
) {
    val program: PupilProgram get() = programs[shownProgram]
    val file: ProgramFile get() = program.files[shownFile]

    /** Whether the brick has a slot for one more program. */
    val hasRoom: Boolean get() = programs.size < Brick.MAX_PROGRAMS
}

/**
 * How far programs were read since they were changed; [isOver] says that nothing is read any more until something
 * changes.
 */
enum class ProgramReading(val isOver: Boolean = false) {
    /** All of them. */
    DONE(isOver = true),

    /** A program waits for a pause in the typing. */
    WAITING,

    /** The compiler is fetched or at work, and somebody waits for it. */
    COMPILING,

    /** The compiler could not be fetched; Run tries again. */
    NO_COMPILER(isOver = true),

    /** A compiler failed on a program, by a mistake of its own. */
    COMPILER_FAILED(isOver = true),
}
