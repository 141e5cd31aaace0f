package robotran.ui.export

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.dp
import robotran.ui.poster.DrawnPoster
import robotran.ui.school.tags.ExportTags
import robotran.ui.school.texts.ExportTexts
import robotran.uikit.*
import robotran.workshop.event.ExportEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.state.Poster
import robotran.workshop.state.ShowStep

/** What is on the poster, beside the page as it will be; on a narrow screen above it. */
@Composable
internal fun PosterForm(step: ShowStep.ChoosingPoster, onEvent: (ExportEvent) -> Unit) {
    BoxWithConstraints(Modifier.fillMaxSize()) {
        if (maxWidth >= BESIDE) {
            Row(Modifier.fillMaxSize(), Arrangement.spacedBy(16.dp)) {
                PosterPreview(step.poster, Modifier.weight(1f).fillMaxHeight())
                Column(Modifier.weight(1f).verticalScroll(rememberScrollState()), Arrangement.spacedBy(8.dp)) {
                    PosterFields(step, onEvent)
                }
            }
        } else {
            val scroll = rememberScrollState()
            Column(
                Modifier
                    .fillMaxSize()
                    .scrollHint(scroll)
                    .verticalScroll(scroll),
                Arrangement.spacedBy(8.dp),
            ) {
                PosterFields(step, onEvent)
                PosterPreview(step.poster, Modifier.fillMaxWidth().heightIn(max = this@BoxWithConstraints.maxWidth))
            }
        }
    }
}

@Composable
private fun PosterFields(step: ShowStep.ChoosingPoster, onEvent: (ExportEvent) -> Unit) {
    val poster = step.poster
    PosterField(poster.title, ExportTexts.posterTitle(spoken), ExportTags.POSTER_TITLE) {
        onEvent(ExportEvent.PosterChanged(it, poster.maker, step.isDated))
    }
    PosterField(poster.maker, ExportTexts.posterMaker(spoken), ExportTags.POSTER_MAKER) {
        onEvent(ExportEvent.PosterChanged(poster.title, it, step.isDated))
    }
    SwitchRow(ExportTexts.posterDate(spoken), step.isDated, ExportTags.POSTER_DATE) {
        onEvent(ExportEvent.PosterChanged(poster.title, poster.maker, it))
    }
    val kinds = listOf(
        FileKind.PNG to ExportTexts.posterPicture(spoken),
        FileKind.SVG to ExportTexts.posterDrawing(spoken),
    )
    ChipRow(title = "", kinds, step.kind, ExportTags.POSTER_KIND) {
        onEvent(ExportEvent.PosterKindChosen(it))
    }
    val quiet = LocalRobotranColours.current.quiet
    Text(ExportTexts.posterPrivate(spoken), style = TextStyles.smallLines, color = quiet)
}

@Composable
private fun PosterField(value: String, label: String, tag: String, onChange: (String) -> Unit) =
    TextField(value, onChange, Modifier.fillMaxWidth().testTag(tag), label)

@Composable
private fun PosterPreview(poster: Poster, modifier: Modifier) =
    PosterView(poster, modifier, Modifier.testTag(ExportTags.POSTER_PREVIEW))

/** The page, as large as there is room. */
@Composable
internal fun PosterView(poster: Poster, modifier: Modifier, pageModifier: Modifier) {
    val drawn = remember(poster) { DrawnPoster(poster) }
    val labels = rememberTextMeasurer(CACHED_LINES)
    val code = codeStyle().fontFamily
    val description = ExportTexts.posterPreview(spoken)
    BoxWithConstraints(modifier, Alignment.TopCenter) {
        val line = LocalRobotranColours.current.line
        Canvas(
            pageModifier
                .aspectRatio((drawn.width / drawn.height).toFloat())
                .border(1.dp, line)
                .semantics {
                    role = Role.Image
                    contentDescription = description
                },
        ) { with(drawn) { draw(labels, checkNotNull(code)) } }
    }
}

private val BESIDE = 520.dp

/** The lines of a long program: while the title is typed, they stay as they are. */
private const val CACHED_LINES = 400
