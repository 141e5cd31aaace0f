package robotran.ui.brick.front

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.unit.Dp
import robotran.brick.state.BrickState
import robotran.world.RobotDescription

/** A kind of brick as it is seen from the front: its plan, and what is its own, its display and the words on its ports. */
internal interface BrickFace {
    val plan: FrontPlan

    /** @param unit of the plan. */
    @Composable
    fun Display(state: BrickState, unit: Dp, modifier: Modifier)

    /** What shines on the front, on the body of its plan; in units. */
    fun DrawScope.drawLamps(state: BrickState) = Unit

    /** What of the display a [StripLook] has room for. */
    @Composable
    fun StripDisplay(state: BrickState, isLow: Boolean)

    /** @param robot what is plugged in. */
    @Composable
    fun input(state: BrickState, index: Int, robot: RobotDescription): PortView

    @Composable
    fun output(state: BrickState, index: Int, robot: RobotDescription): PortView

    /** What is below a hint about the brick, if anything. */
    @Composable
    fun BelowHint(state: BrickState, modifier: Modifier)
}
