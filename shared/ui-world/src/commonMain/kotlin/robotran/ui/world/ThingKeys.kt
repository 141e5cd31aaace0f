package robotran.ui.world

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.simulation.SessionInput
import robotran.ui.sheet.isSign
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.geometry.Pose

/**
 * The input of a key for [thing] at [pose]: the arrows move it by a centimetre, `[` and `]`, or `,` and `.`, turn it by
 * 15 degrees; with Shift by a millimetre and a degree. Null for other keys.
 */
internal fun inputOf(event: KeyEvent, thing: SheetElement, pose: Pose): SessionInput? {
    if (event.type != KeyEventType.KeyDown || event.isCtrlPressed || event.isMetaPressed) return null
    val step = if (event.isShiftPressed) FINE_STEP else STEP
    val turn = if (event.isShiftPressed) FINE_TURN else TURN
    return when {
        // A German keyboard types brackets with Alt Gr.
        event.isLeftTurn -> turned(thing, pose, turn)
        event.isRightTurn -> turned(thing, pose, -turn)
        event.isAltPressed -> null
        event.key == Key.DirectionLeft -> moved(thing, pose, -step, 0.0)
        event.key == Key.DirectionRight -> moved(thing, pose, step, 0.0)
        event.key == Key.DirectionUp -> moved(thing, pose, 0.0, step)
        event.key == Key.DirectionDown -> moved(thing, pose, 0.0, -step)
        else -> null
    }
}

internal fun moved(thing: SheetElement, pose: Pose, x: Double, y: Double): SessionInput =
    placing(thing, pose.copy(x = pose.x + x, y = pose.y + y))

/** Null for a lamp. */
internal fun turned(thing: SheetElement, pose: Pose, degrees: Double): SessionInput? =
    placing(thing, pose.copy(heading = pose.heading + degrees)).takeIf { thing.kind != SheetElementKind.LAMP }

private val KeyEvent.isLeftTurn: Boolean get() = isSign('[', setOf(Key.LeftBracket, Key.Comma))
private val KeyEvent.isRightTurn: Boolean get() = isSign(']', setOf(Key.RightBracket, Key.Period))

/** In centimetres and degrees. */
internal const val STEP = 1.0
internal const val TURN = 15.0
private const val FINE_STEP = 0.1
private const val FINE_TURN = 1.0
