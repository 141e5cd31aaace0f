package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.Verdict
import robotran.projects.ProjectProgram

/**
 * The page with what pupils have handed in for one assignment or for a course.
 *
 * @property title the assignment's or the course's.
 * @property tasks the assignments, at least one.
 * @property kind what the hand-ins are graded with.
 * @property rows in the order in which they are shown.
 * @property progress null while nothing is graded.
 * @property isStopped whether the teacher has stopped grading before all was graded.
 * @property opened null while the table is shown.
 * @property message what came of the last action; null for nothing to say.
 * @property last the ID of the hand-in that was open or replayed last; null for none. The table returns to its place.
 * @property scanners how QR codes can be read here; empty if they cannot.
 * @property isScanning whether the view of a scanner is open.
 */
@Immutable
data class HandInsState(
    val title: String,
    val kind: HandInsKind,
    val tasks: List<HandInTask>,
    val scanners: List<QrScannerKind> = emptyList(),
    val isScanning: Boolean = false,
    val rows: List<HandInRow> = emptyList(),
    val order: HandInOrder = HandInOrder.VERDICT,
    val isReading: Boolean = false,
    val progress: GradingProgress? = null,
    val isStopped: Boolean = false,
    val opened: OpenedHandIn? = null,
    val last: String? = null,
    val dialog: HandInsDialog? = null,
    val message: HandInsMessage? = null,
) {
    /** The assignment of [row]; the first one for what is for none. */
    fun taskOf(row: HandInRow): HandInTask = tasks.getOrNull(row.task) ?: tasks.first()

    /** The hand-ins that can stand beside the open one, those that are most like it first. */
    val comparable: List<HandInRow>
        get() {
            val alike = openedRow?.alike.orEmpty().associate { it.id to it.isEqual }
            return rows.filter { it.id != opened?.id && it.task == openedRow?.task && it.programs.isNotEmpty() }
                .sortedWith(compareBy({ alike[it.id]?.not() ?: true }, { it.id !in alike }, { it.name.lowercase() }))
        }

    /** The row of the open hand-in. */
    val openedRow: HandInRow? get() = opened?.let { open -> rows.firstOrNull { it.id == open.id } }

    /** How many hand-ins have each verdict, without those that none has. */
    val counts: Map<HandInVerdict, Int>
        get() = HandInVerdict.entries.associateWith { verdict -> rows.count { it.verdict == verdict } }
            .filterValues { it > 0 }
}

/**
 * An assignment for which hand-ins are graded.
 *
 * @property title empty if it is the only one.
 * @property solution its programs to compare with; empty if it has none.
 */
@Immutable
data class HandInTask(val title: String, val plan: GradingPlan, val solution: List<ProjectProgram> = emptyList())

/** What hand-ins are graded with. */
enum class HandInsKind {
    /** The teacher's own file, with its checks. */
    WITH_CHECKS,

    /** An assignment without checks: a pupil's copy, or the teacher has set none. */
    WITHOUT_CHECKS,

    /** Any world with goals. */
    WORLD,
}

/** The orders of the table. */
enum class HandInOrder {
    NAME,

    /** Those who need help come first. */
    VERDICT,
}

/** What came of a hand-in; who needs most help comes first. See [Verdict]. */
enum class HandInVerdict {
    UNUSABLE,
    NOT_GRADED,
    HAS_MISTAKES,
    MISSED,
    PARTLY,
    PASSED,

    /** It is not graded yet. */
    WAITING,
}

/**
 * A hand-in in the table.
 *
 * @property id stays the same while other hand-ins are brought in.
 * @property collected as it was brought in.
 * @property graded null until it is graded.
 * @property lines the number of lines with code in its programs.
 * @property alike other hand-ins with equal or nearly equal programs.
 * @property comment what the teacher writes to the pupil.
 * @property hasNamesake whether another hand-in has the same name: of another pupil, or from another source.
 * @property task the index of its assignment; beyond the last if it is for none.
 */
@Immutable
data class HandInRow(
    val id: String,
    val collected: Submission,
    val graded: GradedHandIn? = null,
    val lines: Int = 0,
    val alike: List<AlikeHandIn> = emptyList(),
    val comment: String = "",
    val hasNamesake: Boolean = false,
    val task: Int = 0,
) {
    /** What counts of it, once it is graded. */
    val submission: Submission get() = graded?.submission ?: collected

    val name: String get() = collected.name

    val verdict: HandInVerdict
        get() = when (graded?.verdict) {
            null -> HandInVerdict.WAITING
            Verdict.PASSED -> HandInVerdict.PASSED
            Verdict.PARTLY -> HandInVerdict.PARTLY
            Verdict.MISSED -> HandInVerdict.MISSED
            Verdict.MISTAKES -> HandInVerdict.HAS_MISTAKES
            Verdict.FAILED -> HandInVerdict.NOT_GRADED
            Verdict.UNUSABLE -> HandInVerdict.UNUSABLE
        }

    /** Its results; null if it has none. */
    val results: GradedHandIn.Graded? get() = graded as? GradedHandIn.Graded

    /** The programs of the first robot. */
    val programs: List<ProjectProgram> get() = (submission as? Submission.Usable)?.robot?.programs.orEmpty()

    /** Whether the pupil's own run can be repeated. */
    val hasInputs: Boolean get() = submission.project?.inputs?.isNotEmpty() == true
}

/** A hand-in whose programs are like those of another one. [isEqual] is whether only names and layout differ. */
data class AlikeHandIn(val id: String, val name: String, val isEqual: Boolean)

/** A run of a hand-in: in the world called [world], with [seed]. */
data class HandInRun(val world: String, val seed: Int)

/**
 * How far grading is.
 *
 * @property handIns the number of hand-ins that are graded, of [of].
 * @property secondsLeft about how long it will still take; null until that is known.
 */
data class GradingProgress(val handIns: Int, val of: Int, val part: Float, val secondsLeft: Int?)

/**
 * The hand-in that the page shows alone.
 *
 * @property beside the hand-in that its programs are compared with; empty for the solution, null for none.
 */
data class OpenedHandIn(val id: String, val beside: String? = null)

/** A dialog over the page. */
sealed interface HandInsDialog {
    data object PastingLinks : HandInsDialog

    /** Asks which hand-in to put beside the open one. */
    data object Comparing : HandInsDialog

    /** Asks whether to remove all [count] hand-ins. */
    data class Removing(val count: Int) : HandInsDialog
}

/** What came of an action. */
sealed interface HandInsMessage {
    val isError: Boolean get() = false

    /**
     * [count] hand-ins are new and can be used, [unusable] are new and cannot, the [others] were there already; [notes]
     * are sentences on files that are no hand-ins.
     */
    data class Brought(val count: Int, val others: Int, val notes: List<String> = emptyList(), val unusable: Int = 0) :
        HandInsMessage

    /** There was no hand-in in what was brought; [notes] are sentences on what it is. */
    data class NothingFound(val notes: List<String> = emptyList()) : HandInsMessage {
        override val isError: Boolean get() = true
    }

    /** At most [max] files, or [maxMegabytes] together, can be kept; the others were left out. */
    data class TooMany(val max: Int, val maxMegabytes: Int) : HandInsMessage {
        override val isError: Boolean get() = true
    }

    /** The hand-ins or comments cannot be kept on this device; [reason] is the platform's message. */
    data class NotKept(val reason: String) : HandInsMessage {
        override val isError: Boolean get() = true
    }

    /** A file could not be read; [sentence] is the error message. */
    data class Unreadable(val sentence: String) : HandInsMessage {
        override val isError: Boolean get() = true
    }

    /** The hand-in called [name] was removed, which can be undone. */
    data class Removed(val name: String) : HandInsMessage

    /** There was no QR code in the chosen pictures, or in the one that was taken if [isPhoto]. */
    data class NoCodes(val isPhoto: Boolean) : HandInsMessage {
        override val isError: Boolean get() = true
    }

    /** The camera may not be used here. */
    data object CameraNotAllowed : HandInsMessage {
        override val isError: Boolean get() = true
    }

    /** There is no camera, or another program uses it. */
    data object NoCamera : HandInsMessage {
        override val isError: Boolean get() = true
    }

    data class Saved(val name: String) : HandInsMessage

    data class NotSaved(val reason: String, val isFull: Boolean) : HandInsMessage {
        override val isError: Boolean get() = true
    }
}
