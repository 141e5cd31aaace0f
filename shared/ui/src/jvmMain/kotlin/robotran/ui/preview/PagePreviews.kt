package robotran.ui.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.learning.LearningPages
import robotran.ui.learning.TutorialPane
import robotran.ui.screen.NoticeBar
import robotran.ui.screen.TopStrip
import robotran.ui.settings.SettingsPage
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Notice

@Preview
@Composable
internal fun TopStripPreview() = PreviewWorkshop {
    TopStrip(it.document, isEditingWorld = false, fullPane = null, {}, Modifier.width(860.dp))
}

@Preview
@Composable
internal fun NoticePreview() = PreviewWorkshop { NoticeBar(Notice.FixOutdated, {}, Modifier.width(480.dp)) }

@Preview
@Composable
internal fun ErrorNoticePreview() = PreviewWorkshop { NoticeBar(Notice.LinkNotCopied, {}, Modifier.width(480.dp)) }

@Preview
@Composable
internal fun TutorialPreview() =
    PreviewWorkshop({ show(LearningPage.TUTORIAL) }) { TutorialPane(it.learning, {}, Modifier.size(328.dp, 600.dp)) }

@Preview
@Composable
internal fun WorldGalleryPreview() = LearningPagePreview(LearningPage.WORLDS)

@Preview
@Composable
internal fun ExamplesPreview() = LearningPagePreview(LearningPage.EXAMPLES)

@Preview
@Composable
internal fun HelpPreview() = LearningPagePreview(LearningPage.HELP)

@Preview
@Composable
internal fun WelcomePreview() = LearningPagePreview(LearningPage.FIRST_RUN)

@Preview
@Composable
internal fun SettingsPreview() = PreviewWorkshop {
    Box(Modifier.size(800.dp, 600.dp)) {
        SettingsPage(it.settings, siteRequested = false, asksForSite = true, onEvent = {})
    }
}

@Composable
private fun LearningPagePreview(page: LearningPage) = PreviewWorkshop({ show(page) }) {
    Box(Modifier.size(1_000.dp, 600.dp)) {
        LearningPages(it.learning, it.settings.programView, null, hasGoals = false, {})
    }
}

private fun Workshop.show(page: LearningPage) = handle(LearningEvent.PageRequested(page))
