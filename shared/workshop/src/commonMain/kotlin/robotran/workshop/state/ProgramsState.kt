package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.ProgramTranslation
import robotran.programs.support
import robotran.projects.ProgramView
import robotran.textediting.text.TextDocument
import robotran.workshop.blocks.BlocksState
import robotran.world.RobotPlacement

/**
 * The state of the programs.
 *
 * @property robots the robots of the world; the first is the pupil's own.
 * @property shownRobot the name of the robot whose programs are shown.
 * @property isWorldsOwn whether they are the unchanged programs that the world gives this robot.
 * @property programs in the order of the brick's slots; never empty.
 * @property shownProgram the index of the current one of [programs].
 * @property shownFile the index of its current file.
 * @property draft the text and the selection of that file.
 * @property breakpoints lines of that file, from 1, that the program stops before.
 * @property view how the current program is shown.
 * @property blocks its blocks; current while [view] has blocks, null if it was never shown in blocks.
 * @property closed the name of the last removed program or class, which can be restored; null if there is none.
 * @property closedMessageShown whether the message about it is shown; false once the user has closed it.
 * @property canReopen whether there is room to restore it.
 * @property diagnostics the diagnostics of the current program, in order; empty until it is compiled.
 * @property notes its errors and warnings at their lines; until it is compiled again, the old ones.
 * @property compileStatus the compile progress.
 * @property errorPointedOut whether the user tried to run a program with errors since the last edit.
 * @property translationShown whether programs are also shown as another text, if they have one.
 * @property translationKind what the current program is, or would be, shown as; null if it is only itself.
 * @property translation the program as that; null if there is none or it is hidden.
 * @property searchRequested whether the search in the file should open.
 * @property otherBrick the brick that the current program is for, if the robot has another one and the program was
 *   compiled; null otherwise.
 * @property words the language whose words a new program has.
 * @property isTranslated whether [translation] belongs to the current program and not to an earlier one without errors.
 */
@Immutable
data class ProgramsState(
    val robots: List<RobotPlacement>,
    val shownRobot: String,
    val isWorldsOwn: Boolean,
    val programs: List<Program>,
    val shownProgram: Int,
    val shownFile: Int,
    val draft: TextDocument,
    val canUndo: Boolean,
    val canRedo: Boolean,
    val breakpoints: Set<Int>,
    val view: ProgramView,
    val blocks: BlocksState?,
    val closed: String?,
    val closedMessageShown: Boolean,
    val canReopen: Boolean,
    val diagnostics: List<Diagnostic>,
    val notes: List<InlineDiagnostic>,
    val compileStatus: CompileStatus,
    val errorPointedOut: Boolean,
    val translationShown: Boolean,
    val translationKind: ShownLanguage?,
    val translation: ProgramTranslation?,
    val isTranslated: Boolean,
    val searchRequested: Boolean,
    val otherBrick: BrickKind? = null,
    val words: Language = Language.ENGLISH,
) {
    val program: Program get() = programs[shownProgram]
    val file: SourceFile get() = program.files[shownFile]

    /** The robot whose programs are shown. */
    val robot: RobotPlacement get() = robots.firstOrNull { it.name == shownRobot } ?: robots.first()

    /** The brick of that robot. */
    val brick: BrickKind get() = robot.description.brick

    /** What the current program can be shown as. */
    val translationKinds: List<ShownLanguage> get() = program.language.support.translations(brick)

    /** Whether the brick has a free slot. */
    val hasRoom: Boolean get() = programs.size < BrickProgram.MAX_PROGRAMS
}

/** The compile progress. [isOver] is whether nothing is compiled until the next change. */
enum class CompileStatus(val isOver: Boolean = false) {
    /** All programs are compiled. */
    DONE(isOver = true),

    /** Waiting for a pause in typing. */
    WAITING,

    /** The compiler is loading or running, and an action waits for it. */
    COMPILING,

    /** The compiler could not be loaded; Run tries again. */
    NO_COMPILER(isOver = true),

    /** A compiler crashed on a program because of a bug. */
    COMPILER_FAILED(isOver = true),
}
