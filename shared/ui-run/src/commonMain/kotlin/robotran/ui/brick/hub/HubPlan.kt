package robotran.ui.brick.hub

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.hub.model.HubButton
import robotran.hub.model.HubModel
import robotran.ui.brick.front.ButtonFinish
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontShape
import robotran.ui.brick.front.StripLook
import robotran.ui.brick.nxt.NxtPlan

/**
 * The front of a hub, arranged as on a real one, with plugs and buttons large enough for fingers.
 *
 * @property display where its lights, its screen or, without either, what it prints is.
 * @property ring the middle and the radius of the ring of its status light; null if it has none there.
 */
internal class HubPlan(
    private val body: List<FrontShape>,
    private val display: Rect,
    private val buttons: List<FrontPart.Button>,
    private val ports: List<FrontPart>,
    val ring: Pair<Offset, Float>? = null,
) {
    val front = FrontPlan(
        body,
        ButtonFinish(corner = 12f, side = 0.3f, pressed = 0.14f, isSquashed = true),
        ports.filter { it.place.top < display.top } + FrontPart.Display(display) + buttons +
            ports.filter { it.place.top >= display.top },
        StripLook(
            HubColours.CASE,
            HubColours.EDGE,
            buttonSize = DpSize(56.dp, 52.dp),
            lowButtonSize = DpSize(52.dp, 48.dp),
            gap = 8.dp,
        ),
    )

    companion object {
        /** The plan of [model]; an NXT looks as ever. */
        fun of(model: HubModel): FrontPlan = planOf(model)?.front ?: NxtPlan.front

        /** Its own plan; null for a hub that is an NXT. */
        fun planOf(model: HubModel): HubPlan? = when {
            model.hasMatrix -> primePlan(model)
            HubButton.UP in model.buttons -> ev3Plan(model)
            model.hasScreen -> null
            else -> boxPlan(model)
        }
    }
}

/** A case with its edge. */
internal fun caseOf(bounds: Rect, corner: Float) = listOf(
    FrontShape(FrontShape.Box(bounds, corner), HubColours.EDGE),
    FrontShape(FrontShape.Box(bounds.deflate(1.5f), corner), HubColours.CASE),
)
