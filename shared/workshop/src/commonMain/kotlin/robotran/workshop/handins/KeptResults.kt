package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.workers.readGraded
import robotran.assignments.grading.workers.writeGraded
import robotran.assignments.grading.workers.writeHandIn
import robotran.documents.FileStamp
import robotran.language.Language
import robotran.projects.writeProject
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine

/**
 * What grading for [task] has found out, kept on the device, so that a class need not be graded again when the page is
 * opened again. A newer Robotran may find out something else, so nothing is believed before one hand-in was graded
 * anew with the same result.
 */
internal class KeptResults(
    private val kept: KeptHandIns,
    private val task: GradedTask,
    private val language: Language,
    private val physics: PhysicsEngine,
) {
    private val assignment by lazy { FileStamp.of(writeProject(task.project) + language.tag).text }

    /** What a result is drawn on. */
    private val start by lazy {
        val session = Session(task.plan.worlds.first().world, emptyList<RobotProgramSet>(), physics, language)
        session.state.also { session.close() }
    }

    /** The text kept for [submission]; null for none. */
    suspend fun textFor(submission: Submission.Usable): String? = kept.result(keyOf(submission))

    /** What [text] says about [submission]; null if it cannot be read. */
    fun read(text: String, submission: Submission.Usable): GradedHandIn? = try {
        readGraded(text, submission, task.plan, start)
    } catch (_: IllegalArgumentException) {
        null
    }

    /** [graded] as a text, as [textFor] returns it. */
    fun write(graded: GradedHandIn, submission: Submission.Usable): String = writeGraded(graded, submission, task.plan)

    suspend fun keep(graded: GradedHandIn, submission: Submission.Usable) {
        // What Robotran itself failed with is worth another try.
        if (graded !is GradedHandIn.Failed) kept.keepResult(keyOf(submission), write(graded, submission))
    }

    private fun keyOf(submission: Submission.Usable): String = FileStamp.of(assignment + writeHandIn(submission)).text
}
