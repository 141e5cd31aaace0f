package robotran.assignments.grading.workers

import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.finish
import robotran.simulation.physics.PhysicsEngine

/** Grades hand-ins as [order] says, which reach it as texts. */
class GradingWorker(private val order: GradingOrder, physics: PhysicsEngine) {
    private val grader = HandInGrader(order.assignment, order.plan, physics, order.language)

    /**
     * Grades a hand-in at once.
     *
     * @param handIn from [writeHandIn].
     * @param onProgress is called several times a second, as a rule, with the number of runs that are over.
     * @return for [readGraded].
     * @throws IllegalArgumentException if [handIn] is no such text.
     */
    suspend fun grade(handIn: String, onProgress: (runs: Int) -> Unit): String {
        val submission = readHandIn(handIn)
        return writeGraded(grader.prepare(submission).finish(onProgress), submission, order.plan)
    }
}
