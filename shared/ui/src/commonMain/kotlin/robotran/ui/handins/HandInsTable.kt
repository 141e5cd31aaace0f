package robotran.ui.handins

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.lazy.grid.GridCells
import androidx.compose.foundation.lazy.grid.GridItemSpan
import androidx.compose.foundation.lazy.grid.LazyGridScope
import androidx.compose.foundation.lazy.grid.LazyVerticalGrid
import androidx.compose.foundation.lazy.grid.itemsIndexed
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.Dp
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
internal fun HandInsTable(state: HandInsState, form: TableForm, onEvent: (HandInsEvent) -> Unit) {
    val list = rememberLazyGridState()
    LazyVerticalGrid(
        GridCells.Fixed(form.columns),
        Modifier.fillMaxSize().testTag("hand-in-list").scrolledByReaders(list) {
            list.layoutInfo.viewportSize.height
        },
        list,
        PaddingValues(if (form == TableForm.CARDS) Space.MEDIUM else Space.PAGE),
        horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
        verticalArrangement = Arrangement.spacedBy(Space.SMALL),
    ) {
        whole("head") { HandInsHead(state, onEvent) }
        if (state.rows.isEmpty() && !state.isReading) {
            whole("empty") {
                EmptyState(
                    EmptyPicture.SHEETS,
                    stringResource(Res.string.hand_ins_empty),
                    "hand-ins-empty",
                    Modifier.fillMaxWidth().height(EMPTY_HEIGHT),
                )
            }
        } else {
            whole("summary") { HandInsSummary(state, onEvent) }
            if (form == TableForm.TABLE) whole("columns") { ColumnTitles() }
        }
        itemsIndexed(state.rows, { _, row -> "row ${row.id}" }) { index, row ->
            if (form == TableForm.TABLE) {
                HandInTableRow(row, index, state.plan, onEvent)
            } else {
                HandInCard(row, index, state.plan, onEvent)
            }
        }
    }
}

/** An item as wide as the page. */
private fun LazyGridScope.whole(key: String, content: @Composable () -> Unit) =
    item(key, { GridItemSpan(maxLineSpan) }) { content() }

/** How hand-ins are arranged: in [columns]. */
internal enum class TableForm(val columns: Int) {
    TABLE(1),
    PAIRS_OF_CARDS(2),
    CARDS(1),
    ;

    companion object {
        /** @param scale larger text needs the room of a larger screen. */
        fun of(width: Dp, scale: Float): TableForm = when {
            width >= TABLE_WIDTH * scale -> TABLE
            width >= PAIR_WIDTH * scale -> PAIRS_OF_CARDS
            else -> CARDS
        }

        private val TABLE_WIDTH = 1_080.dp
        private val PAIR_WIDTH = 720.dp
    }
}

private val EMPTY_HEIGHT = 300.dp
