package robotran.ui.handins

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.itemsIndexed
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyState
import robotran.ui.parts.scrolledByReaders
import robotran.ui.resources.Res
import robotran.ui.resources.hand_ins_empty
import robotran.ui.theme.Space
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInsState

/** All hand-ins, below what can be done with them. */
@Composable
internal fun HandInsTable(state: HandInsState, isWide: Boolean, onEvent: (HandInsEvent) -> Unit) {
    val list = rememberLazyListState()
    LazyColumn(
        Modifier.fillMaxSize().testTag("hand-in-list").scrolledByReaders(list) {
            list.layoutInfo.viewportSize.height
        },
        list,
        PaddingValues(if (isWide) Space.PAGE else Space.MEDIUM),
        verticalArrangement = Arrangement.spacedBy(Space.SMALL),
    ) {
        item("head") { HandInsHead(state, onEvent) }
        if (state.rows.isEmpty() && !state.isReading) {
            item("empty") {
                EmptyState(
                    EmptyPicture.SHEETS,
                    stringResource(Res.string.hand_ins_empty),
                    "hand-ins-empty",
                    Modifier.fillMaxWidth().height(EMPTY_HEIGHT),
                )
            }
        } else {
            item("summary") { HandInsSummary(state, onEvent) }
            if (isWide) item("columns") { ColumnTitles() }
        }
        itemsIndexed(state.rows, { _, row -> "row ${row.id}" }) { index, row ->
            if (isWide) {
                HandInTableRow(row, index, state.plan, onEvent)
            } else {
                HandInCard(row, index, state.plan, onEvent)
            }
        }
    }
}

private val EMPTY_HEIGHT = 300.dp
