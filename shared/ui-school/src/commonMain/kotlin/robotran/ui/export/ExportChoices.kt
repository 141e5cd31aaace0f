package robotran.ui.export

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.school.tags.ExportTags
import robotran.ui.school.texts.ExportTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.state.ExportState
import robotran.workshop.state.MovingKind
import robotran.world.World

/** What can be made, as large buttons with pictures of the pupil's own sheet; in two columns if there is room. */
@Composable
internal fun ExportChoices(state: ExportState, world: World, session: SessionState, onEvent: (WorkshopEvent) -> Unit) {
    val choices = ShowChoice.entries.filter { it != ShowChoice.VIDEO || state.canRecord }
    val scroll = rememberScrollState()
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val columns = if (maxWidth >= TWO_COLUMNS * LocalDensity.current.fontScale) 2 else 1
        Column(
            Modifier
                .fillMaxWidth()
                .scrollHint(scroll)
                .verticalScroll(scroll),
            Arrangement.spacedBy(GAP),
        ) {
            for (row in choices.chunked(columns)) {
                Row(Modifier.height(IntrinsicSize.Min), Arrangement.spacedBy(GAP)) {
                    for (choice in row) {
                        val enabled = state.hasRun || !choice.needsRun
                        ChoiceButton(choice, enabled, Modifier.weight(1f).fillMaxHeight(), world, session) {
                            onEvent(choice.event)
                            if (choice == ShowChoice.LINK) onEvent(ExportEvent.Closed)
                        }
                    }
                    repeat(columns - row.size) { Spacer(Modifier.weight(1f)) }
                }
            }
        }
    }
}

@Composable
private fun ChoiceButton(
    choice: ShowChoice,
    enabled: Boolean,
    modifier: Modifier,
    world: World,
    session: SessionState,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    val sheet = remember(world) { ShownSheet(world) }
    CardButton(ExportTags.choice(choice), onClick, modifier, enabled = enabled) {
        Row(
            Modifier.heightIn(min = MIN_HEIGHT).padding(12.dp).alpha(if (enabled) 1f else UNAVAILABLE),
            Arrangement.spacedBy(12.dp),
            Alignment.CenterVertically,
        ) {
            Canvas(Modifier.size(PICTURE_WIDTH, PICTURE_HEIGHT)) { with(choice) { draw(sheet, session, colours) } }
            Column(Modifier.weight(1f), Arrangement.spacedBy(2.dp)) {
                Text(choice.words(spoken), style = TextStyles.label.medium)
                val help = if (enabled) choice.help else ExportTexts::noRun
                Text(help(spoken), style = TextStyles.smallLines, color = colours.quiet)
            }
        }
    }
}

private enum class ShowChoice(
    val words: Label,
    val help: Label,
    val event: WorkshopEvent,
    private val picture: DrawScope.(ShownSheet, SessionState, RobotranColours) -> Unit,
    val needsRun: Boolean = false,
) {
    MOVING(
        ExportTexts::moving,
        ExportTexts::movingHelp,
        ExportEvent.MovingChosen(MovingKind.PICTURE),
        { sheet, session, _ -> drawMoving(sheet, session) },
        needsRun = true,
    ),
    VIDEO(
        ExportTexts::video,
        ExportTexts::videoHelp,
        ExportEvent.MovingChosen(MovingKind.VIDEO),
        { sheet, session, _ -> drawFilm(sheet, session) },
        needsRun = true,
    ),
    PICTURE(
        ExportTexts::picture,
        ExportTexts::pictureHelp,
        ExportEvent.StillChosen(FileKind.PNG),
        { sheet, session, _ -> drawPhoto(sheet, session) },
    ),
    POSTER(
        ExportTexts::poster,
        ExportTexts::posterHelp,
        ExportEvent.PosterChosen,
        { sheet, session, _ -> drawPage(sheet, session) },
    ),
    DRAWING(
        ExportTexts::drawing,
        ExportTexts::drawingHelp,
        ExportEvent.StillChosen(FileKind.SVG),
        { sheet, session, colours -> drawEnlarged(sheet, session, colours) },
    ),
    LINK(
        ExportTexts::link,
        ExportTexts::linkHelp,
        DocumentEvent.LinkRequested,
        { sheet, session, colours -> drawLinked(sheet, session, colours) },
    ),
    ;

    fun DrawScope.draw(sheet: ShownSheet, session: SessionState, colours: RobotranColours) =
        picture(sheet, session, colours)
}

private val GAP = 10.dp
private val MIN_HEIGHT = 96.dp
private val PICTURE_WIDTH = 84.dp
private val PICTURE_HEIGHT = 72.dp
private val TWO_COLUMNS = 560.dp
private const val UNAVAILABLE = 0.55f
