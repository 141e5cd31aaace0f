package robotran.workshop.platform

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.language.Language
import robotran.projects.Project

/** Grades hand-ins with all processors of the machine, beside the screen's own thread. */
interface GradingWorkers {
    /**
     * Prepares to grade hand-ins for [assignment].
     *
     * @param plan of [assignment].
     * @param language of goals and errors.
     * @return null if it cannot be done here.
     */
    suspend fun start(assignment: Project, plan: GradingPlan, language: Language): GradingCrew?
}

/** Workers that grade hand-ins for one assignment. */
interface GradingCrew {
    /** How many hand-ins it grades at the same time. */
    val size: Int

    /**
     * Grades [submission]. If a worker ends or stands still, this is [GradedHandIn.Failed], and the others go on. Call
     * it at most [size] times at once. Cancelling the coroutine ends the work.
     *
     * @param onProgress is called with the number of runs that are over, in the caller's thread.
     */
    suspend fun grade(submission: Submission.Usable, onProgress: (runs: Int) -> Unit): GradedHandIn

    /** Ends all work. */
    fun close()
}
