package robotran.ui.brick

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import robotran.brick.controls.BrickButton
import robotran.brick.state.BrickState
import robotran.rcxrom.state.RcxState
import robotran.ui.brick.rcx.BrickPlan
import robotran.ui.brick.rcx.RcxFront
import robotran.ui.brick.rcx.RcxStrip
import robotran.world.PortSensor
import robotran.world.RobotPlacement

/**
 * The front of a brick, with buttons that support multi-touch.
 *
 * @param down the buttons drawn pressed.
 * @param ports the sensors on the input ports.
 * @param onTouch called when the user presses or releases the touch sensor on an input port, from 0.
 */
@Composable
internal fun BrickFront(
    state: BrickState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier = Modifier,
    ports: List<List<PortSensor>> = RobotPlacement.PENBOT_PORTS,
    onTouch: (Int, Boolean) -> Unit = { _, _ -> },
) {
    if (state is RcxState) RcxFront(state, down, onPress, onRelease, modifier, ports, onTouch)
}

/**
 * A compact brick where room is scarce: what its display shows, and its start button.
 *
 * @param isLow whether it is as low as a finger allows.
 */
@Composable
internal fun BrickStrip(
    state: BrickState,
    down: Set<BrickButton>,
    onPress: (BrickButton) -> Unit,
    onRelease: (BrickButton) -> Unit,
    modifier: Modifier = Modifier,
    isLow: Boolean = false,
) {
    if (state is RcxState) RcxStrip(state, down, onPress, onRelease, modifier, isLow)
}

/** The ratio of the brick's width to its height. */
internal const val BRICK_ASPECT = BrickPlan.ASPECT

/** The min width at which every button is large enough for a finger. */
internal val MIN_BRICK_WIDTH = Dp(BrickPlan.WIDTH * BrickPlan.MIN_UNIT)
