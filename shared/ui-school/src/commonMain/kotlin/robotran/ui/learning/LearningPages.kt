package robotran.ui.learning

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.projects.ProgramView
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.LearningState
import robotran.workshop.state.SavedOwnCourse

/**
 * The learning pages over the workshop; fills the screen. The tutorial is not one of them, see [TutorialPane].
 *
 * @param view how programs are shown.
 * @param saved what came of saving lessons or worlds as a course.
 * @param hasGoals whether the open project has goals.
 * @param foot the height of the run bar, which help on words leaves free.
 */
@Composable
fun LearningPages(
    state: LearningState,
    view: ProgramView,
    saved: SavedOwnCourse?,
    hasGoals: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    foot: Dp = 0.dp,
) {
    when (state.page) {
        LearningPage.FIRST_RUN -> FirstRunPage(view, onEvent)
        LearningPage.MAP -> LessonMapPage(state, onEvent)
        LearningPage.TEACHERS -> TeachersPage(state.language, hasGoals, saved, onEvent)
        LearningPage.WORLDS -> WorldGalleryPage(state, onEvent)
        LearningPage.EXAMPLES -> ExamplesPage(state.help.programLanguage, state.help.brick, onEvent)

        LearningPage.HELP -> BoxWithConstraints(Modifier.fillMaxSize().padding(bottom = foot).padding(12.dp)) {
            // Covers only the program, so that Run stays visible: beside the paper, below it, or the whole of a phone.
            val isBroad = maxWidth > BROAD
            val isUnderPaper = isBroad && maxHeight > maxWidth
            val width = if (isBroad && !isUnderPaper) {
                (maxWidth * PANEL_SHARE_ACROSS).coerceIn(PANEL_WIDTHS)
            } else {
                maxWidth
            }
            val height = maxHeight * if (isUnderPaper) PANEL_SHARE_UPRIGHT else PANEL_SHARE
            Box(Modifier.align(Alignment.BottomStart)) {
                HelpPanel(state, onEvent, Modifier.widthIn(max = width).heightIn(max = height))
            }
        }

        LearningPage.TUTORIAL, null -> Unit
    }
}

/** Keeps part of the program above it visible. */
private const val PANEL_SHARE = 0.72f
private const val PANEL_SHARE_UPRIGHT = 0.3f
private const val PANEL_SHARE_ACROSS = 0.3f
private val PANEL_WIDTHS = 300.dp..520.dp
private val BROAD = 520.dp
