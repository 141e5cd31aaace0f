package robotran.assignments.collecting

/** What the teacher should know about a submission. */
sealed interface SubmissionRemark {
    /** The file was changed after it was handed in, or damaged. */
    data object Changed : SubmissionRemark

    /** The pupil has changed the world, which the assignment does not allow. It is graded in the assignment's own. */
    data object WorldChanged : SubmissionRemark

    /** The pupil has changed the world, which the assignment allows. It is graded in the assignment's all the same. */
    data object OwnWorld : SubmissionRemark

    /** The programs are those that the pupil began with. */
    data object Unchanged : SubmissionRemark

    /** It is the teacher's own file of this assignment, with checks or solution. */
    data object TeachersFile : SubmissionRemark

    /** A program is the same as the teacher's solution, apart from names, comments and blanks. */
    data object IsSolution : SubmissionRemark

    /** The pupil's folder has another name than [entered], which the hand-in says. */
    data class OtherName(val entered: String) : SubmissionRemark

    /** A program is in a language that the assignment does not allow. */
    data class LanguageNotAllowed(val program: String) : SubmissionRemark

    /** The programs use [words] that the assignment does not allow. */
    data class WordsNotAllowed(val words: List<String>) : SubmissionRemark

    /** Of [all], which were graded, [chosen] counts: none did better. */
    data class BestCounts(val chosen: String, val all: List<String>) : SubmissionRemark

    /** Of the programs [all] of a project, [chosen] counts: Run starts it. */
    data class ChosenInApp(val chosen: String, val all: List<String>) : SubmissionRemark

    /** [programs] lie beside a project, which counts instead. */
    data class BesideProject(val programs: List<String>) : SubmissionRemark

    /** The pupil's hand-ins from [origins] do not count: this one has more tries. */
    data class FewerTries(val origins: List<String>) : SubmissionRemark

    /** The pupil's hand-ins from [origins] were not tried, since there are too many. */
    data class NotTried(val origins: List<String>) : SubmissionRemark

    /** Something else that the pupil has handed in cannot be used: [reason] is a sentence. */
    data class PartUnusable(val reason: String) : SubmissionRemark

    /** The compiled [classes] lie beside their source, which counts instead. */
    data class CompiledLeftOut(val classes: List<String>) : SubmissionRemark

    /** A program is in an old encoding or has an unusual name, and was read; [sentence] says so. */
    data class ReadAllTheSame(val sentence: String) : SubmissionRemark
}
