package robotran.ui.handins

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.lazy.grid.GridCells
import androidx.compose.foundation.lazy.grid.LazyGridState
import androidx.compose.foundation.lazy.grid.itemsIndexed
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyState
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInTask
import robotran.workshop.state.HandInsState

/**
 * All hand-ins, below what can be done with them. When it appears again, it shows the one that was open last, which has
 * the focus.
 *
 * @param list keeps its place meanwhile.
 * @param hasActions whether what can be done with all of them scrolls with them.
 */
@Composable
internal fun HandInsTable(
    state: HandInsState,
    list: LazyGridState,
    form: TableForm,
    hasActions: Boolean,
    onEvent: (HandInsEvent) -> Unit,
) {
    val focus = remember { FocusRequester() }
    var wanted by remember { mutableStateOf(state.last) }
    LaunchedEffect(Unit) {
        val index = state.rows.indexOfFirst { it.id == state.last }
        // Above the rows are the head, the summary and, in a table, the titles of columns.
        if (index >= 0) list.show(index + if (form == TableForm.TABLE) 3 else 2)
    }
    val padding = if (form == TableForm.CARDS) Space.MEDIUM else Space.PAGE
    CardGrid(GridCells.Fixed(form.columns), list, HandInTags.HAND_IN_LIST, Space.SMALL, padding) {
        wholeRow("head") { HandInsHead(state, hasActions, onEvent) }
        if (state.rows.isEmpty() && !state.isReading) {
            wholeRow("empty") {
                EmptyState(
                    EmptyPicture.SHEETS,
                    SchoolTexts.handInsEmpty(spoken),
                    HandInTags.HAND_INS_EMPTY,
                    Modifier.fillMaxWidth().height(EMPTY_HEIGHT),
                )
            }
        } else {
            wholeRow("summary") { HandInsSummary(state, onEvent) }
            if (form == TableForm.TABLE) wholeRow("columns") { ColumnTitles(rowPictureSize(state.tasks.first().plan)) }
        }
        itemsIndexed(state.rows, { _, row -> "row ${row.id}" }) { index, row ->
            val isWanted = row.id == wanted
            val modifier = if (isWanted) Modifier.focusRequester(focus) else Modifier
            if (form == TableForm.TABLE) {
                val picture = rowPictureSize(state.tasks.first().plan)
                HandInTableRow(row, index, taskOf(state, row), picture, onEvent, modifier)
            } else {
                HandInCard(row, index, taskOf(state, row), onEvent, modifier)
            }
            if (isWanted) {
                LaunchedEffect(Unit) {
                    focus.requestFocus()
                    wanted = null
                }
            }
        }
    }
}

/** What is for no assignment of a course has no title of one. */
private fun taskOf(state: HandInsState, row: HandInRow): HandInTask =
    state.taskOf(row).let { if (row.task in state.tasks.indices) it else it.copy(title = "") }

/** Scrolls to the item [index] unless all of it is in sight. */
private suspend fun LazyGridState.show(index: Int) {
    // Until then nobody knows what is in sight.
    withFrameNanos { }
    val info = layoutInfo
    val isInSight = info.visibleItemsInfo.any {
        it.index == index && it.offset.y >= info.viewportStartOffset &&
            it.offset.y + it.size.height <= info.viewportEndOffset
    }
    if (!isInSight) scrollToItem(index)
}

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
