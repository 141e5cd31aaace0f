package robotran.assignments.collecting

import robotran.projects.HandIn
import robotran.projects.Project
import robotran.projects.ProjectRobot

/** What one pupil has handed in. */
sealed interface Submission {
    /**
     * What a learning platform or the pupil's folder calls the pupil, or else what the pupil entered, or else what the
     * file is called.
     */
    val name: String

    /** The file, folder or link it came from, as shown to the teacher. */
    val origin: String

    /** What the teacher should know. */
    val remarks: List<SubmissionRemark>

    /** The whole hand-in, to open it; null if there is no project in it. */
    val project: Project?

    /**
     * There are programs in it.
     *
     * @property robot the programs and choices for the first robot.
     * @property handIn what the pupil's device says about it; null for programs that were not handed in by the app.
     * @property alternatives what may count in its place: grading decides, see [choose]. They have none themselves.
     */
    data class Usable(
        override val name: String,
        override val origin: String,
        val robot: ProjectRobot,
        override val project: Project? = null,
        val handIn: HandIn? = null,
        override val remarks: List<SubmissionRemark> = emptyList(),
        val alternatives: List<Usable> = emptyList(),
    ) : Submission {
        /** All that may count, in an order that depends on names alone. */
        val attempts: List<Usable> get() = listOf(copy(alternatives = emptyList())) + alternatives

        /** The one of [attempts] with this [index] alone; it says so in a remark if there were others. */
        fun choose(index: Int): Usable {
            if (alternatives.isEmpty()) return this
            val chosen = attempts[index]
            val names = namesOf(attempts)
            return chosen.copy(remarks = chosen.remarks + SubmissionRemark.BestCounts(names[index], names))
        }
    }

    /** Nothing in it can be used; [reason] is a sentence. */
    data class Unusable(
        override val name: String,
        override val origin: String,
        val reason: String,
        override val remarks: List<SubmissionRemark> = emptyList(),
        override val project: Project? = null,
    ) : Submission
}

/** The same with [remarks], too. */
internal fun Submission.with(remarks: List<SubmissionRemark>): Submission = when (this) {
    is Submission.Unusable -> copy(remarks = this.remarks + remarks)

    is Submission.Usable -> copy(
        remarks = this.remarks + remarks,
        alternatives = alternatives.map { it.copy(remarks = it.remarks + remarks) },
    )
}

/** What tells [attempts] apart: the names of the programs that run, or those of the files they came from, or both. */
private fun namesOf(attempts: List<Submission.Usable>): List<String> {
    val programs = attempts.map { it.robot.programs.getOrNull(it.robot.firstProgram)?.name.orEmpty() }
    val files = attempts.map { it.origin.substringAfterLast('/') }
    return when {
        attempts.all { it.origin == attempts.first().origin } -> programs
        files.toSet().size == files.size -> files
        else -> attempts.zip(programs) { attempt, program -> "${attempt.origin}: $program" }
    }
}
