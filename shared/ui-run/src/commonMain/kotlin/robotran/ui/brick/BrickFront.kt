package robotran.ui.brick

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.brick.state.BrickState
import robotran.nxt.state.NxtState
import robotran.rcxrom.state.RcxState
import robotran.ui.brick.nxt.ExceptionCalls
import robotran.ui.brick.nxt.NxtFront
import robotran.ui.brick.nxt.NxtStrip
import robotran.ui.brick.rcx.BrickPlan
import robotran.ui.brick.rcx.RcxFront
import robotran.ui.brick.rcx.RcxStrip
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.pluggedSensors

/**
 * The front of a brick, with buttons that support multi-touch.
 *
 * @param down the buttons drawn pressed.
 * @param robot what is plugged in.
 * @param onTouch called when the user presses or releases the touch sensor on an input port, from 0.
 */
@Composable
fun BrickFront(
    state: BrickState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier = Modifier,
    robot: RobotDescription = ReadyRobots.defaultOf(state.kind),
    onTouch: (Int, Boolean) -> Unit = { _, _ -> },
) {
    when (state.kind) {
        BrickKind.RCX -> RcxFront(state as RcxState, down, onPress, onRelease, modifier, robot.pluggedSensors, onTouch)
        BrickKind.NXT -> NxtFront(state as NxtState, down, onPress, onRelease, modifier, robot, onTouch)
    }
}

/**
 * A compact brick where room is scarce: what its display shows, and its start button.
 *
 * @param isLow whether it is as low as a finger allows.
 */
@Composable
fun BrickStrip(
    state: BrickState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier = Modifier,
    isLow: Boolean = false,
) {
    when (state.kind) {
        BrickKind.RCX -> RcxStrip(state as RcxState, down, onPress, onRelease, modifier, isLow)
        BrickKind.NXT -> NxtStrip(state as NxtState, down, onPress, onRelease, modifier, isLow)
    }
}

/** What is below a hint about a brick: the calls of an exception; nothing on most. */
@Composable
internal fun BelowBrickHint(state: BrickState, modifier: Modifier = Modifier) {
    when (state.kind) {
        BrickKind.RCX -> Unit
        BrickKind.NXT -> (state as NxtState).exception?.let { ExceptionCalls(it, modifier) }
    }
}

/** The ratio of a brick's width to its height, the same for all kinds. */
const val BRICK_ASPECT = BrickPlan.ASPECT

/** The min width at which every button is large enough for a finger. */
val MIN_BRICK_WIDTH = Dp(BrickPlan.WIDTH * BrickPlan.MIN_UNIT)
