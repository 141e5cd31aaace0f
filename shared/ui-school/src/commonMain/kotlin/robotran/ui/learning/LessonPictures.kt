package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.language.Language
import robotran.learning.Lesson
import robotran.learning.drawing.RunDrawing
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures

/**
 * What a card shows of a lesson.
 *
 * @property own what the pupil's robot drew in it; null shows what the solution draws.
 */
internal data class ShownLesson(val lesson: Lesson, val own: RunDrawing?)

/** Thumbnails of what the lessons draw: the robot at the end, and its ink. No program runs for them. */
internal object LessonPictures : CardPictures<ShownLesson> {
    private val pictures = SheetPictures()

    override fun ready(subject: ShownLesson, colours: SheetColours, room: PictureBounds): ImageBitmap? =
        pictures.ready(keyOf(subject), colours, room)

    override suspend fun of(subject: ShownLesson, colours: SheetColours, room: PictureBounds): ImageBitmap {
        val world = subject.lesson.world(Language.ENGLISH)
        return pictures.of(keyOf(subject), world, colours, room, shown = { stateOf(subject, it) })
    }

    private fun stateOf(subject: ShownLesson, begun: SessionState): SessionState {
        val own = subject.own ?: return subject.lesson.drawing?.shownIn(begun) ?: begun
        // The robot is glad about what the pupil has done.
        return own.shownIn(begun).run { copy(goals = goals.map { it.copy(status = GoalStatus.MET) }) }
    }

    private fun keyOf(subject: ShownLesson): String =
        "${subject.lesson.name} ${subject.lesson.brick} ${subject.own?.text.orEmpty()}"
}
