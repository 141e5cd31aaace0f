package robotran.ui.screen

import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import robotran.learning.LessonPlace
import robotran.ui.run.texts.RunTexts
import robotran.ui.screen.tags.ScreenTags
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState

/** What is different there, and the way on, which comes first where large text leaves room for little else. */
@Composable
internal fun TryElsewhere(learning: LearningState, elsewhere: LessonPlace, onEvent: (WorkshopEvent) -> Unit) {
    val isLarge = LocalDensity.current.fontScale > LARGE
    val again = learning.tutorial?.current?.let(learning::textOf)?.again
    val words = again?.takeIf { elsewhere == LessonPlace.AGAIN } ?: RunTexts.outcomeElsewhere(spoken)
    if (isLarge) TryThere(onEvent)
    Text(words, Modifier.testTag(ScreenTags.ELSEWHERE_WORDS), TextStyles.sentence)
    if (!isLarge) TryThere(onEvent)
}

@Composable
private fun TryThere(onEvent: (WorkshopEvent) -> Unit) = Button(
    RunTexts.outcomeTryThere(spoken),
    ScreenTags.TRY_ELSEWHERE,
    modifier = Modifier.padding(vertical = Space.TINY),
) { onEvent(LearningEvent.OtherPlaceTried) }

/** From this font scale on, a card has room for a few lines only. */
private const val LARGE = 1.3f
