package robotran.ui.handins

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInsState

/** What pupils have handed in for an assignment: a table, or one hand-in at a time. */
@Composable
fun HandInsPage(state: HandInsState, onEvent: (HandInsEvent) -> Unit) {
    val row = state.openedRow
    val title = if (row == null) {
        SchoolTexts.handInsTitle(spoken, state.title)
    } else {
        SchoolTexts.handInsOf(spoken, row.name, state.title)
    }
    val close = { onEvent(if (row == null) HandInsEvent.Closed else HandInsEvent.HandInChosen(null)) }
    val list = rememberLazyGridState()
    val ofOne = rememberScrollState()
    val words = if (row == null) KitTexts::pageClose else SchoolTexts::handInGoBack
    Page(title, HandInTags.HAND_INS, close, if (row == null) list else ofOne, MAX_WIDTH, words) {
        state.message?.let { HandInsMessageText(it, onEvent) }
        BoxWithConstraints(Modifier.weight(1f)) {
            val form = TableForm.of(maxWidth, LocalDensity.current.fontScale)
            if (row == null) {
                // Where there is room, they do not scroll away.
                val areActionsFixed = form != TableForm.CARDS && maxHeight >= ROOM * LocalDensity.current.fontScale
                Column {
                    if (areActionsFixed) {
                        val place = Modifier.padding(horizontal = Space.PAGE).padding(top = Space.SMALL)
                        HandInsActions(state, onEvent, place)
                    }
                    HandInsTable(state, list, form, hasActions = !areActionsFixed, onEvent)
                }
            } else {
                HandInView(state, row, isWide = form != TableForm.CARDS, ofOne, onEvent)
            }
        }
    }
    HandInsDialogs(state, onEvent)
}

private val MAX_WIDTH = 1400.dp

/** A page as high as this has room for buttons that stay. */
private val ROOM = 480.dp
