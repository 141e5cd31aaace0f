package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.staticCompositionLocalOf
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*

/** What all rows say to a screen reader. It is looked up once: a row that scrolls into sight should cost little. */
@Immutable
internal data class RowWords(
    val change: String,
    val addBelow: String,
    val doNow: String,
    val up: String,
    val down: String,
    val duplicate: String,
    val delete: String,
    val fold: String,
    val unfold: String,
    val more: String,
    val runsNow: String,
    val stopsBefore: String,
    val folded: String,
)

internal val LocalRowWords = staticCompositionLocalOf<RowWords> { error("The words of rows are missing.") }

@Composable
internal fun rowWords(): RowWords = RowWords(
    stringResource(Res.string.blocks_change),
    stringResource(Res.string.blocks_add_below),
    stringResource(Res.string.blocks_do_now),
    stringResource(Res.string.blocks_up),
    stringResource(Res.string.blocks_down),
    stringResource(Res.string.blocks_duplicate),
    stringResource(Res.string.blocks_delete),
    stringResource(Res.string.blocks_fold),
    stringResource(Res.string.blocks_unfold),
    stringResource(Res.string.blocks_more),
    stringResource(Res.string.blocks_runs_now),
    stringResource(Res.string.blocks_stops_before),
    stringResource(Res.string.blocks_folded),
)
