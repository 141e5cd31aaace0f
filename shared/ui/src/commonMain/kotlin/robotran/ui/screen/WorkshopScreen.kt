package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState

/** The one screen: side by side where there is room, one pane at a time where there is not. */
@Composable
internal fun WorkshopScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    BoxWithConstraints(modifier.fillMaxSize().background(LocalRobotranColours.current.pane)) {
        if (maxWidth >= Measures.WIDE_WIDTH && maxHeight >= Measures.WIDE_HEIGHT) {
            WideScreen(state, onEvent)
        } else {
            NarrowScreen(state, onEvent)
        }
    }
}
