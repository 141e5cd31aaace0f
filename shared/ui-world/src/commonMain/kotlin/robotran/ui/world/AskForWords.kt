package robotran.ui.world

import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.CustomAccessibilityAction
import robotran.simulation.state.SessionState
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SheetElementKind
import robotran.workshop.state.SheetViewState
import robotran.workshop.state.SheetWords
import robotran.world.geometry.Point
import kotlin.math.round

/** What can be asked for in words. */
internal enum class WordsKind(val label: Label, val tag: String) {
    WHERE(SheetTexts::whereAmI, WorldTags.WHERE_AM_I),
    EXPLORE(SheetTexts::explore, WorldTags.EXPLORE),
    STORY(SheetTexts::whatHappened, WorldTags.WHAT_HAPPENED),
}

/** The event that asks for words of a [kind] about the selected robot, or else the pupil's own. */
internal fun askFor(kind: WordsKind, view: SheetViewState, session: SessionState): WorkshopEvent = when (kind) {
    WordsKind.WHERE -> SheetEvent.WordsChanged(SheetWords.WhereIs(robotToFollow(view), session))

    WordsKind.EXPLORE -> {
        val pose = (session.robots.getOrNull(robotToFollow(view)) ?: session.robots.first()).robot.pose
        SheetEvent.WordsChanged(SheetWords.Explored(Point(round(pose.x), round(pose.y))))
    }

    WordsKind.STORY -> RunEvent.StoryRequested
}

/** What a screen reader offers to ask for at the sheet. */
@Composable
internal fun askingActions(
    view: SheetViewState,
    session: SessionState,
    onEvent: (WorkshopEvent) -> Unit,
): List<CustomAccessibilityAction> {
    val now by rememberUpdatedState(view to session)
    val send by rememberUpdatedState(onEvent)
    val language = spoken
    return remember(language) {
        WordsKind.entries.map { kind ->
            CustomAccessibilityAction(kind.label(language)) {
                send(askFor(kind, now.first, now.second))
                true
            }
        }
    }
}

/** The selected robot, or else the pupil's own. */
internal fun robotToFollow(view: SheetViewState): Int =
    view.chosen?.takeIf { it.kind == SheetElementKind.ROBOT }?.number ?: 0

/**
 * The event for a key that asks for words, with any focus: F8 for where the robot is, with Shift to explore the sheet,
 * with Ctrl (on a Mac also Command) for what happened in the run. Null for other keys.
 */
fun wordsShortcut(event: KeyEvent, view: SheetViewState, session: SessionState): WorkshopEvent? {
    if (event.type != KeyEventType.KeyDown || event.key != Key.F8 || event.isAltPressed) return null
    val kind = when {
        event.isCtrlPressed || event.isMetaPressed -> WordsKind.STORY
        event.isShiftPressed -> WordsKind.EXPLORE
        else -> WordsKind.WHERE
    }
    return askFor(kind, view, session)
}

/** The event for Escape where nothing else takes it; null if no words are shown. */
fun escapedWords(event: KeyEvent, view: SheetViewState): SheetEvent? = SheetEvent.WordsChanged(null).takeIf {
    view.words != null && event.type == KeyEventType.KeyDown && event.key == Key.Escape
}
