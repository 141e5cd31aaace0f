package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.assignments.doing.NotAllowed
import robotran.learning.Hint
import robotran.projects.Assignment
import robotran.projects.AssignmentTries
import robotran.projects.Feedback
import robotran.projects.HandIn
import robotran.projects.TryResult

/**
 * The assignment that is open.
 *
 * @property tries of the pupil on this device.
 * @property isAuthor whether it has what only its author has; nobody's tries are counted then.
 * @property hints for the last try, which failed.
 * @property notAllowed what the pupil's programs have that the assignment does not allow.
 * @property canBeginAgain whether the programs differ from those to begin with.
 * @property handedInAs the name under which it was handed in on this device; null if it was not.
 * @property handIn says that the open project is a hand-in; null while the pupil works at it.
 * @property feedback the teacher's answer in the open project; null if there is none.
 * @property isTaskFolded whether the pupil has folded the card of the task; null if that was never chosen.
 */
@Immutable
data class AssignmentState(
    val assignment: Assignment,
    val tries: AssignmentTries = AssignmentTries(),
    val isAuthor: Boolean = false,
    val hints: List<Hint> = emptyList(),
    val notAllowed: List<NotAllowed> = emptyList(),
    val canBeginAgain: Boolean = false,
    val handedInAs: String? = null,
    val handIn: HandIn? = null,
    val feedback: Feedback? = null,
    val isTaskFolded: Boolean? = null,
) {
    /** Whether the pupil works at it, so that tries count. */
    val isOpenForTries: Boolean get() = !isAuthor && handIn == null && feedback == null

    /** Whether the program is known to be the one that was handed in: there is none if nothing could be used. */
    val isProgramHandedIn: Boolean get() = handIn != null || feedback?.results.orEmpty().isNotEmpty()

    /** Whether the world may not be changed. */
    val isWorldLocked: Boolean get() = isOpenForTries && !assignment.mayChangeWorld
}

/** A step of the sheet with which a pupil hands in. */
@Immutable
sealed interface HandInStep {
    /**
     * Asks for the name.
     *
     * @property best how the best try did; null without one.
     * @property canChoose whether the program in the editor differs from that of the best try.
     * @property isEditor whether the program in the editor is handed in, not the best try.
     * @property notAllowed what the assignment does not allow in what is handed in.
     * @property isUnchanged whether the program in the editor is still as the pupil got it.
     */
    data class Asking(
        val name: String,
        val wanted: String,
        val best: TryResult?,
        val canChoose: Boolean,
        val isEditor: Boolean,
        val notAllowed: List<NotAllowed>,
        val isUnchanged: Boolean = false,
    ) : HandInStep {
        val canGoOn: Boolean get() = name.isNotBlank()
    }

    /** Runs the program in the editor; [part] of the longest time that it may take is over, 0..1. */
    data class Running(val part: Float) : HandInStep

    /** The program cannot run. Each of [reasons] is a line of text. */
    data class HasErrors(val reasons: List<String>) : HandInStep

    /**
     * The hand-in is made.
     *
     * @property result null if the program cannot run.
     * @property link null if there is none, see [linkError].
     * @property savedAs the name of the file; null until it is saved.
     */
    data class Ready(
        val name: String,
        val result: TryResult?,
        val link: String? = null,
        val linkError: LinkError? = null,
        val isCopied: Boolean = false,
        val savedAs: String? = null,
        val saveError: String? = null,
    ) : HandInStep
}

/** Why there is no link. */
sealed interface LinkError {
    /** [message] is one sentence. */
    data class TooLong(val message: String) : LinkError

    /** The app does not know an address for links. */
    data object NoSite : LinkError
}
