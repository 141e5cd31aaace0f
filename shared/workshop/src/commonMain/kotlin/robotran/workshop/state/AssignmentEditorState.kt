package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.projects.Assignment

/**
 * The page that makes an assignment.
 *
 * @property title as entered; the world keeps its title while this is blank.
 * @property programs the open programs of the first robot, and whether pupils begin with them.
 * @property solution the open programs of the first robot and those of the solution, and whether they belong to it.
 * @property notGiven what the last change would have given to pupils although it is of the solution: names of programs.
 * @property canTakeSolution whether taking the programs as they are now would change the solution.
 * @property missing what the assignment lacks; it can be used nevertheless.
 * @property check the run of the solution; null before it.
 * @property pictureMadeSmaller the size of the picture added last, if it was made smaller.
 * @property link the link for pupils; null while it is not shown.
 * @property savedAs the name of the last file; null before it.
 * @property canPack whether there is a web site at hand to make packages for learning platforms of.
 * @property isPacking whether a package is being made.
 * @property isAboutPackage whether [savedAs] and [saveError] are about a package.
 * @property embedCode the code for a frame; null while it is not shown.
 * @property embedCodeCopied whether it was copied.
 * @property embedError why there is no code for a frame.
 * @property asksBeforeGiving whether the page asks if pupils shall begin with what solves the task.
 */
@Immutable
data class AssignmentEditorState(
    val assignment: Assignment,
    val title: String,
    val task: String,
    val programs: List<StartProgram>,
    val solution: List<SolutionProgram>,
    val canTakeSolution: Boolean,
    val goals: Int,
    val canUndo: Boolean,
    val missing: List<MissingPart>,
    val check: SolutionCheck? = null,
    val pictureError: PictureError? = null,
    val pictureMadeSmaller: PictureSize? = null,
    val link: PupilLink? = null,
    val savedAs: String? = null,
    val saveError: String? = null,
    val hasShareSheet: Boolean = false,
    val canPack: Boolean = false,
    val isPacking: Boolean = false,
    val isAboutPackage: Boolean = false,
    val embedCode: String? = null,
    val embedCodeCopied: Boolean = false,
    val embedError: LinkError? = null,
    val asksBeforeGiving: Boolean = false,
    val notGiven: List<String> = emptyList(),
) {
    /** The name of the empty program with which pupils begin; null if they begin with more. */
    val emptyStart: String?
        get() = assignment.start.firstOrNull()?.name.takeIf {
            assignment.start.all { program -> program.files.all { it.text.isBlank() } }
        }
}

/** A program of the author's; [isStart] is whether pupils begin with it, [isChanged] whether it was changed since. */
data class StartProgram(val name: String, val isStart: Boolean, val isChanged: Boolean)

/**
 * A program that can belong to the solution.
 *
 * @property isTaken whether it belongs to the solution.
 * @property isChanged whether it was changed since it was taken.
 * @property isOpen whether it is open in the editor.
 * @property isOfWorld whether it comes with the world and is only offered so far.
 */
data class SolutionProgram(
    val name: String,
    val isTaken: Boolean,
    val isChanged: Boolean,
    val isOpen: Boolean,
    val isOfWorld: Boolean = false,
)

/** What an assignment lacks. */
enum class MissingPart { TASK, GOALS, SOLUTION, SOLUTION_NOT_ALLOWED }

/** Why a picture cannot be used. */
enum class PictureError { TOO_LARGE, NOT_A_PICTURE, TOO_MANY, HEIC }

/** In pixels. */
data class PictureSize(val width: Int, val height: Int)

/** What running the solution with all seeds and variations says. */
@Immutable
sealed interface SolutionCheck {
    /** [done] of [all] runs are over. */
    data class Running(val done: Int, val all: Int) : SolutionCheck

    /** All [runs] have met the goals. [startPassed] is the number of runs in which the program to begin with has, too. */
    data class Passed(val runs: Int, val startPassed: Int = 0) : SolutionCheck

    /**
     * Some runs have not met the goals.
     *
     * @property world the name of the first variation; empty for the assignment's own world.
     * @property startPassed the number of runs in which the program to begin with has met them.
     */
    data class Failed(val failed: Int, val runs: Int, val world: String, val seed: Int, val startPassed: Int = 0) :
        SolutionCheck

    /** The solution cannot run. Each of [reasons] is a line of text. */
    data class HasErrors(val reasons: List<String>) : SolutionCheck
}

/**
 * The link for pupils.
 *
 * @property link null while it is made, or if it cannot be, see [problem].
 */
@Immutable
data class PupilLink(val link: String? = null, val problem: LinkError? = null, val isCopied: Boolean = false)
