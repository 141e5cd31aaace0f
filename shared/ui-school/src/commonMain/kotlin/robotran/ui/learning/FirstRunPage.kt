package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.layout.wrapContentWidth
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.max
import robotran.projects.ProgramView
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.ui.texts.HubTexts
import robotran.uikit.*
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage

/**
 * A robot that draws, one sentence, how programs shall be shown, and three first steps: beside the drawing or below it,
 * without scrolling where the text is not enlarged. The page's greeting (`webApp/src/site`) has the same composition.
 *
 * @param view how programs are shown now: in blocks where there are only fingers, as text where there is a keyboard.
 */
@Composable
internal fun FirstRunPage(view: ProgramView, onEvent: (WorkshopEvent) -> Unit) {
    Page(LearningTexts.welcomeTitle(spoken), LearningTags.FIRST_RUN, {
        onEvent(LearningEvent.PageClosed)
    }, scroll = null, maxWidth = Dp.Infinity) {
        BoxWithConstraints {
            val scale = LocalDensity.current.fontScale
            val height = maxHeight
            if (maxWidth > maxHeight && maxWidth / scale >= BESIDE_WIDTH) {
                Row(Modifier.fillMaxSize()) {
                    WelcomeSheet(Modifier.weight(1f).fillMaxHeight())
                    Choices(
                        view,
                        roomIn(height / scale, PICTURES_HEIGHT_BESIDE),
                        onEvent,
                        Modifier.weight(1f).fillMaxHeight(),
                    )
                }
            } else {
                val min = height * if (scale > LARGE_TEXT) LOW_SHEET else HIGH_SHEET
                val sheet = (height - CHOICES_HEIGHT * scale).coerceIn(min, max(min, MAX_SHEET))
                Column(Modifier.fillMaxSize()) {
                    WelcomeSheet(Modifier.fillMaxWidth().height(sheet))
                    Choices(
                        view,
                        roomIn((height - sheet) / scale, PICTURES_HEIGHT_BELOW),
                        onEvent,
                        Modifier.weight(1f).fillMaxWidth(),
                    )
                }
            }
        }
    }
}

/** Scrolls where large text leaves no room for all of it. */
@Composable
private fun Choices(view: ProgramView, room: WelcomeRoom, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    val isLow = room == WelcomeRoom.LOW
    Box(modifier.scrollHint(scroll, arrow = colours.quiet), Alignment.Center) {
        Column(
            Modifier
                .fillMaxWidth()
                .verticalScroll(scroll)
                .wrapContentWidth()
                .widthIn(max = MAX_WIDTH)
                .padding(horizontal = Space.PAGE, vertical = if (isLow) Space.SMALL else Space.LARGE),
            Arrangement.spacedBy(if (isLow) Space.SMALL else Space.MEDIUM),
        ) {
            Text(
                LearningTexts.welcome(spoken),
                style = (if (isLow) TextStyles.sentence else TextStyles.headingLines).medium,
            )
            ViewChoice(view, room == WelcomeRoom.HIGH) { onEvent(BlockEvent.ViewChosen(it)) }
            Things(room, onEvent, Modifier.fillMaxWidth())
            OtherPages(room == WelcomeRoom.HIGH, onEvent)
            if (room == WelcomeRoom.HIGH) {
                Text(LearningTexts.welcomeAgain(spoken), style = TextStyles.smallLines, color = colours.quiet)
            }
        }
    }
}

/** The ways to another robot, with [hasRoom] to all lessons, and to what is for teachers. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun OtherPages(hasRoom: Boolean, onEvent: (WorkshopEvent) -> Unit) = FlowRow(
    horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
    verticalArrangement = Arrangement.spacedBy(Space.SMALL),
) {
    Button(HubTexts.myRobot(spoken), LearningTags.TRY_ROBOT, ButtonKind.QUIET) {
        onEvent(LearningEvent.PageClosed)
        onEvent(DocumentEvent.RobotChoiceRequested)
    }
    if (hasRoom) {
        Button(LearningTexts.mapAll(spoken), LearningTags.TRY_LESSONS, ButtonKind.QUIET) {
            onEvent(LearningEvent.PageRequested(LearningPage.MAP))
        }
    }
    Button(LearningTexts.teachers(spoken), LearningTags.TRY_TEACHERS, ButtonKind.QUIET) {
        onEvent(LearningEvent.PageRequested(LearningPage.TEACHERS))
    }
}

@Composable
private fun Things(room: WelcomeRoom, onEvent: (LearningEvent) -> Unit, modifier: Modifier) {
    val hasHelp = room != WelcomeRoom.LOW
    ElementRef(
        PLAY_ICON,
        LearningTexts.trySquare(spoken),
        LearningTexts.trySquareHelp(spoken).takeIf { hasHelp },
        LearningTags.TRY_SQUARE,
        modifier,
        isFirst = true,
    ) { onEvent(LearningEvent.FirstProgramTried) }
    ElementRef(
        Icon.BOOK,
        LearningTexts.tryTutorial(spoken),
        LearningTexts.tryTutorialHelp(spoken).takeIf { hasHelp },
        LearningTags.TRY_TUTORIAL,
        modifier,
    ) { onEvent(LearningEvent.TutorialStarted) }
    ElementRef(
        Icon.WORLDS,
        LearningTexts.tryWorlds(spoken),
        LearningTexts.tryWorldsHelp(spoken).takeIf { hasHelp },
        LearningTags.TRY_WORLDS,
        modifier,
    ) { onEvent(LearningEvent.PageRequested(LearningPage.WORLDS)) }
}

/** One suggestion; the first is the recommended one. */
@Composable
private fun ElementRef(
    icon: Icon,
    title: String,
    help: String?,
    tag: String,
    modifier: Modifier,
    isFirst: Boolean = false,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    val onGround = if (isFirst) RobotranColours.ON_YELLOW else colours.onPane
    CardButton(
        tag,
        onClick,
        modifier,
        Corners.LARGE,
        color = if (isFirst) RobotranColours.YELLOW else colours.pane,
        border = if (isFirst) null else edge(colours.quiet),
    ) {
        Row(
            Modifier.padding(horizontal = Space.LARGE, vertical = Space.MEDIUM),
            Arrangement.spacedBy(Space.LARGE),
            Alignment.CenterVertically,
        ) {
            SmallIcon(icon, onGround, size = ICON)
            Column(Modifier.weight(1f), verticalArrangement = Arrangement.spacedBy(Space.HAIR)) {
                Text(title, style = TextStyles.heading.strong, color = onGround)
                help?.let { Text(it, style = TextStyles.label, color = onGround) }
            }
        }
    }
}

/** How much room there is beside or below the drawing. */
private enum class WelcomeRoom {
    /** For titles only, as on a phone on its side. */
    LOW,

    /** For what they mean. */
    NORMAL,

    /** For a picture of each view, and remarks. */
    HIGH,
}

private fun roomIn(height: Dp, forPictures: Dp): WelcomeRoom = when {
    height >= forPictures -> WelcomeRoom.HIGH
    height < LOW_HEIGHT -> WelcomeRoom.LOW
    else -> WelcomeRoom.NORMAL
}

private val LOW_HEIGHT = 540.dp

/** From this width on, at default font size, the drawing is beside the choices. */
private val BESIDE_WIDTH = 640.dp

/** From these heights on, at default font size, there is room for a picture of each view. */
private val PICTURES_HEIGHT_BESIDE = 680.dp
private val PICTURES_HEIGHT_BELOW = 700.dp

/**
 * The part of the height that the drawing has at least above the choices, and the font scale from which on it is less.
 */
private const val HIGH_SHEET = 0.26f
private const val LOW_SHEET = 0.2f
private const val LARGE_TEXT = 1.3f
private val MAX_SHEET = 520.dp

/** The height of the choices at default font size: the drawing has what they leave. */
private val CHOICES_HEIGHT = 710.dp
private val MAX_WIDTH = 640.dp
private val ICON = 28.dp
