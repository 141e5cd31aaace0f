package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/** Keeps what is being learned from. */
class LearningHolder(private val bench: Bench) {
    var state: LearningState by mutableStateOf(LearningState())
        private set

    fun handle(event: LearningEvent) {
        when (event) {
            is LearningEvent.PageWanted -> state = state.copy(page = event.page)
            LearningEvent.PageLeft -> state = state.copy(page = null)
            is LearningEvent.HelpWanted -> state = state.copy(page = LearningPage.HELP)
        }
    }
}
