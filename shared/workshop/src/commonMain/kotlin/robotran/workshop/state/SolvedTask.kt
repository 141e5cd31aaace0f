package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.learning.GalleryWorld

/**
 * A task that the current run has solved.
 *
 * @property learned what the lesson has taught, as in [robotran.learning.LessonText.skill]; null outside the tutorial.
 * @property milliseconds virtual time of the run.
 * @property lines of the program, without empty ones and comments.
 * @property bestMilliseconds the pupil's own best time before; null if it is the first solution.
 * @property bestLines the fewest lines before; null if it is the first solution.
 * @property nextStep the index of the tutorial's next step; null after the last one and outside the tutorial.
 * @property harder the harder variations of the gallery's world that are not done yet.
 */
@Immutable
data class SolvedTask(
    val learned: String?,
    val milliseconds: Long,
    val lines: Int,
    val bestMilliseconds: Long? = null,
    val bestLines: Int? = null,
    val nextStep: Int? = null,
    val harder: List<GalleryWorld> = emptyList(),
)
