package robotran.ui.world

import androidx.compose.foundation.background
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.layout
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.narration.whatIsAt
import robotran.narration.whereIs
import robotran.ui.sheet.ShownWorld
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SheetWords

/** The sentences of [words]; they stay as they are while the robot drives on, so that a reader can finish. */
@Composable
internal fun rememberSentences(words: SheetWords?, shown: ShownWorld): List<String> {
    val language = spoken
    return remember(words, language, shown.world) {
        when (words) {
            null -> emptyList()
            is SheetWords.WhereIs -> whereIs(words.robot, shown.world, words.session, language)
            is SheetWords.Told -> words.story.sentences(language)
            is SheetWords.Explored -> whatIsAt(words.place, shown.world, shown.session, language)
        }
    }
}

/** Says [sentences] to screen readers when [words] change, also if they are the same as before; draws nothing. */
@Composable
internal fun WordsAnnouncement(words: SheetWords?, sentences: List<String>) {
    val asked = remember { Asked() }
    val end = if (asked.isOdd(words)) NO_BREAK_SPACE else ""
    val said = if (words == null) "" else sentences.joinToString(" ") + end
    Box(
        Modifier.size(1.dp).testTag(WorldTags.WORDS_SAID).semantics {
            liveRegion = LiveRegionMode.Polite
            contentDescription = said
        },
    )
}

/** Counts how often words were asked for. */
private class Asked {
    private var last: SheetWords? = null
    private var count = 0

    fun isOdd(words: SheetWords?): Boolean {
        if (words !== last) count++
        last = words
        return count % 2 == 1
    }
}

/** What is told, above the sheet, so that it covers nothing; a long text scrolls. */
@Composable
internal fun WordsPanel(
    shown: ShownWorld,
    sentences: List<String>,
    onClose: () -> Unit,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Column(modifier.fillMaxWidth().background(colours.pane).testTag(WorldTags.WORDS)) {
        Row {
            Column(
                Modifier
                    .weight(1f)
                    .ofHeight(shown.view.words is SheetWords.Explored)
                    .scrollHint(scroll, ground = colours.pane)
                    .verticalScroll(scroll)
                    .padding(start = 16.dp, top = 12.dp, bottom = 4.dp),
            ) {
                for (sentence in sentences) Text(sentence, style = TextStyles.body, color = colours.onPane)
            }
            IconButton(Icon.CLOSE, SheetTexts.closeWords(spoken), WorldTags.CLOSE_WORDS, onClick = onClose)
        }
        Row(Modifier.horizontalScroll(rememberScrollState()).padding(horizontal = 4.dp)) {
            for (kind in WordsKind.entries) {
                Button(kind.label(spoken), kind.tag, ButtonKind.SMALL_LINK) {
                    onEvent(askFor(kind, shown.view, shown.session))
                }
            }
        }
        HorizontalDivider()
    }
}

/**
 * At most as high as leaves most of the room to the sheet and, if it [isSteady], always as high, so that nothing moves
 * under a finger.
 */
private fun Modifier.ofHeight(isSteady: Boolean) = layout { measurable, constraints ->
    val most = minOf((STEADY * fontScale).roundToPx(), constraints.maxHeight / SHARE)
    val least = if (isSteady) most else 0
    val limit = if (isSteady) most else constraints.maxHeight / SHARE
    val placeable = measurable.measure(constraints.copy(minHeight = least, maxHeight = limit))
    layout(placeable.width, placeable.height) { placeable.place(0, 0) }
}

/** Room for three lines at the usual font size. */
private val STEADY = 88.dp
private const val SHARE = 3
private const val NO_BREAK_SPACE = "\u00A0"
