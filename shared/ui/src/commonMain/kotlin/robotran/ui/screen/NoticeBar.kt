package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction

/** The current notice, until it is dismissed: screen readers announce it. Its action alone if it says nothing. */
@Composable
internal fun NoticeBar(notice: Notice, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val text = noticeText(notice)
    val action = notice.action
    if (text.isEmpty() && action != null) return ActionAlone(action, onEvent, modifier)
    val colour = if (notice.isError) colours.error else colours.onPane
    BoxWithConstraints(
        modifier
            .fillMaxWidth()
            .background(if (notice.isError) colours.errorPane else colours.pane, SHAPE)
            .border(1.dp, colours.line, SHAPE)
            // Blocks touches on the content below.
            .pointerInput(Unit) { }
            .testTag(ScreenTags.NOTICE),
    ) {
        val isBeside = maxWidth >= BESIDE * LocalDensity.current.fontScale
        Column {
            Row(
                Modifier.defaultMinSize(minHeight = Dimensions.TARGET).padding(start = 16.dp),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                Text(
                    text,
                    Modifier.weight(1f).padding(vertical = 8.dp).testTag(ScreenTags.NOTICE_TEXT).semantics {
                        liveRegion = if (notice.isError) LiveRegionMode.Assertive else LiveRegionMode.Polite
                    },
                    TextStyles.body,
                    color = colour,
                )
                if (isBeside) action?.let { ActionButton(it, onEvent) }
                IconButton(
                    Icon.CLOSE,
                    CommonTexts.noticeClose(spoken),
                    ScreenTags.NOTICE_CLOSE,
                    if (notice.isError) IconButtonKind.ERROR else IconButtonKind.PLAIN,
                ) {
                    onEvent(WorkshopEvent.NoticeDismissed)
                }
            }
            if (!isBeside) action?.let { ActionButton(it, onEvent) }
        }
    }
}

/** Hides as little as it can. */
@Composable
private fun ActionAlone(action: NoticeAction, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    Box(modifier.background(colours.pane, SHAPE).border(1.dp, colours.line, SHAPE).testTag(ScreenTags.NOTICE)) {
        ActionButton(action, onEvent)
    }
}

@Composable
private fun ActionButton(action: NoticeAction, onEvent: (WorkshopEvent) -> Unit) = Button(
    noticeActionText(action)(spoken),
    ScreenTags.NOTICE_ACTION,
    ButtonKind.LINK,
) { onEvent(WorkshopEvent.NoticeTaken) }

/** At the usual font size, a narrower notice has its action below the text. */
private val BESIDE = 440.dp
private val SHAPE = Shapes.MEDIUM
