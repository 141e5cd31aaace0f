package robotran.ui.screen

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction

/** The current notice, until it is dismissed. Its action alone if it says nothing. */
@Composable
internal fun NoticeBar(notice: Notice, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) = NoticeFrame(
    NoticeWords(noticeText(notice), notice.isError, CommonTexts.noticeClose(spoken)),
    NoticeTags(ScreenTags.NOTICE, ScreenTags.NOTICE_TEXT, ScreenTags.NOTICE_CLOSE),
    { onEvent(WorkshopEvent.NoticeDismissed) },
    modifier,
    notice.action?.let { { ActionButton(it, onEvent) } },
)

@Composable
private fun ActionButton(action: NoticeAction, onEvent: (WorkshopEvent) -> Unit) = Button(
    noticeActionText(action)(spoken),
    ScreenTags.NOTICE_ACTION,
    ButtonKind.LINK,
) { onEvent(WorkshopEvent.NoticeTaken) }
