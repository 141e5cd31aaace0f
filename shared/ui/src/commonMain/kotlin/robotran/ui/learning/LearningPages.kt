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
import androidx.compose.ui.unit.dp
import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.LearningPage
import robotran.ui.workshop.LearningState

/** What lies over the workshop of what there is to learn from; fills the screen. The tutorial is not among it, see [TutorialPane]. */
@Composable
internal fun LearningPages(state: LearningState, onEvent: (LearningEvent) -> Unit) {
    when (state.page) {
        LearningPage.FIRST_RUN -> FirstRunPage(onEvent)

        LearningPage.WORLDS -> WorldGalleryPage(state, onEvent)

        LearningPage.EXAMPLES -> ExamplesPage(state.help.code, onEvent)

        LearningPage.HELP -> BoxWithConstraints(Modifier.fillMaxSize().padding(12.dp)) {
            val most = maxHeight * PANEL_SHARE
            Box(Modifier.align(Alignment.BottomStart)) { HelpPanel(state, onEvent, Modifier.widthIn(max = 520.dp).heightIn(max = most)) }
        }

        LearningPage.TUTORIAL, null -> Unit
    }
}

/** The program above it stays to be seen. */
private const val PANEL_SHARE = 0.72f
