package robotran.assignments.collecting

import robotran.projects.HandIn
import robotran.projects.Project
import robotran.projects.ProjectRobot

/** What one pupil has handed in. */
sealed interface Submission {
    /**
     * What a learning platform calls the pupil, or else what the pupil entered, or else what the folder or file is
     * called.
     */
    val name: String

    /** The file, folder or link it came from, as shown to the teacher. */
    val origin: String

    /**
     * There are programs in it.
     *
     * @property robot the programs and choices for the first robot.
     * @property project the whole hand-in, to open it; null if there were only program files.
     * @property handIn what the pupil's device says about it; null for programs that were not handed in by the app.
     * @property remarks what the teacher should know.
     */
    data class Usable(
        override val name: String,
        override val origin: String,
        val robot: ProjectRobot,
        val project: Project? = null,
        val handIn: HandIn? = null,
        val remarks: List<SubmissionRemark> = emptyList(),
    ) : Submission

    /** Nothing in it can be used; [reason] is a sentence. */
    data class Unusable(override val name: String, override val origin: String, val reason: String) : Submission
}

/** What the teacher should know about a submission. */
sealed interface SubmissionRemark {
    /** The file was changed after it was handed in, or damaged. */
    data object Changed : SubmissionRemark

    /** It was handed in for another assignment, called [title]. */
    data class OtherAssignment(val title: String) : SubmissionRemark

    /** The pupil has changed the world, which the assignment does not allow. It is graded in the assignment's own. */
    data object WorldChanged : SubmissionRemark

    /** The pupil has changed the world, which the assignment allows. It is graded in the assignment's all the same. */
    data object OwnWorld : SubmissionRemark

    /** The programs are those that the pupil began with. */
    data object Unchanged : SubmissionRemark

    /** A program is in a language that the assignment does not allow. */
    data class LanguageNotAllowed(val program: String) : SubmissionRemark

    /** The programs use [words] that the assignment does not allow. */
    data class WordsNotAllowed(val words: List<String>) : SubmissionRemark

    /** The same pupil has handed in [count] more, older ones, which do not count. */
    data class OlderLeftOut(val count: Int) : SubmissionRemark

    /** A program is in an old encoding or has an unusual name, and was read; [sentence] says so. */
    data class ReadAllTheSame(val sentence: String) : SubmissionRemark
}
