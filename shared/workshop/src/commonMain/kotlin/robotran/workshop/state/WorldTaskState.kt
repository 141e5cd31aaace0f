package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.learning.GalleryWorld
import robotran.learning.Lesson

/**
 * The task of a world of the gallery that is loaded.
 *
 * @property canStart whether the program to begin with is not among the pupil's programs.
 */
@Immutable
data class WorldTaskState(
    val world: GalleryWorld,
    val task: Lesson,
    val help: TaskHelp = TaskHelp(),
    val canStart: Boolean = true,
)
