package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.staticCompositionLocalOf
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

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
    BlockTexts.change(spoken),
    BlockTexts.addBelow(spoken),
    BlockTexts.doNow(spoken),
    BlockTexts.up(spoken),
    BlockTexts.down(spoken),
    BlockTexts.duplicate(spoken),
    BlockTexts.delete(spoken),
    BlockTexts.fold(spoken),
    BlockTexts.unfold(spoken),
    BlockTexts.more(spoken),
    BlockTexts.runsNow(spoken),
    BlockTexts.stopsBefore(spoken),
    BlockTexts.folded(spoken),
)
