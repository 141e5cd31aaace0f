package robotran.workshop.learning

import robotran.languagesupport.SourceFile
import robotran.learning.Lesson
import robotran.learning.LessonPlace
import robotran.learning.drawing.RunDrawing
import robotran.programs.Program
import robotran.simulation.state.SessionState

/** Where one program has reached the goals of a lesson. Another program, or one that is changed, begins anew. */
internal data class PassedPlaces(
    private val lesson: Lesson? = null,
    private val files: List<SourceFile> = emptyList(),
    private val runs: Map<LessonPlace, PassedRun> = emptyMap(),
) {
    fun with(lesson: Lesson, program: Program, place: LessonPlace, run: PassedRun): PassedPlaces =
        PassedPlaces(lesson, program.files, of(lesson, program) + (place to run))

    /** The last run of [program] in each place in which it has reached the goals; none of a program before it. */
    fun of(lesson: Lesson, program: Program): Map<LessonPlace, PassedRun> =
        runs.takeIf { lesson === this.lesson && program.files == files }.orEmpty()
}

/** A run of [milliseconds] that has reached the goals in the state [session]. */
internal class PassedRun(val milliseconds: Long, private val session: SessionState) {
    /** What it has left on the sheet. */
    val drawing: RunDrawing get() = RunDrawing.of(session)
}
