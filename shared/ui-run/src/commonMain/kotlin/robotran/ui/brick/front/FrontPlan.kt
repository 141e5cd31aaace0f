package robotran.ui.brick.front

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.uikit.*

/**
 * What the front of a kind of brick looks like, and where its parts are: on a plan of [WIDTH] by [HEIGHT] units for every
 * kind, so that any of them fits into the same places of the screen.
 *
 * @property body what is drawn, the lowest first.
 * @property parts what can be pressed or says something, in the order of a screen reader.
 */
internal class FrontPlan(
    val body: List<FrontShape>,
    val finish: ButtonFinish,
    val parts: List<FrontPart>,
    val strip: StripLook,
) {
    fun button(button: BrickButton): FrontPart.Button =
        parts.firstNotNullOf { part -> (part as? FrontPart.Button)?.takeIf { it.button == button } }

    companion object {
        const val WIDTH = 264f
        const val HEIGHT = 424f

        /** The min dp per unit. A button is 52 units high and would otherwise be too small for a finger. */
        const val MIN_UNIT = 48f / 52f
    }
}

/** A brick in one row, where room is scarce: what its display shows, and its start button. */
internal class StripLook(
    val colour: Color,
    val edge: Color?,
    val buttonSize: DpSize,
    val lowButtonSize: DpSize,
    val gap: Dp,
    val lowGap: Dp = 8.dp,
)

/** What a lamp or the like on a front can tell. */
internal enum class Signal { SENDING, SOUNDING }

/**
 * A thing that is drawn on a front.
 *
 * @property colour null for what is only seen while lit.
 * @property signal what lights it, in the colour [lit].
 */
internal class FrontShape(
    val figure: Figure,
    val colour: Color?,
    val signal: Signal? = null,
    val lit: Color? = colour,
) {
    sealed interface Figure

    class Box(val bounds: Rect, val corner: Float = 0f) : Figure

    /** @property line the width of the line around it; null for a full disc. */
    class Disc(val middle: Offset, val radius: Float, val line: Float? = null) : Figure

    class Line(val from: Offset, val to: Offset, val width: Float) : Figure

    /** @property from degrees clockwise from the right. */
    class Arc(val middle: Offset, val radius: Float, val from: Float, val sweep: Float, val width: Float) : Figure

    /** What of [shapes] is inside of [box]. */
    class Inside(val box: Box, val shapes: List<FrontShape>) : Figure
}

/** A thing on a front that can be pressed or says something. */
internal sealed interface FrontPart {
    val place: Rect

    class Display(override val place: Rect) : FrontPart

    /** @property index among the ports for sensors. */
    class Input(override val place: Rect, val look: PortLook, val index: Int) : FrontPart

    /** @property index among the ports for motors. */
    class Output(override val place: Rect, val look: PortLook, val index: Int) : FrontPart

    /**
     * @property text what is written on it, if that is not its name.
     * @property textSize in units.
     */
    class Button(
        val button: BrickButton,
        override val place: Rect,
        val name: Label,
        val colour: Color,
        val ink: Color,
        val text: String? = null,
        val textSize: Float = 12.5f,
        val shape: ButtonShape = ButtonShape.PLATE,
    ) : FrontPart
}

/**
 * @property towards where its arrow is: -1 for left or up, 1 for right or down, null if it has none. The side where an
 * arrow to the left or right points is narrow.
 */
internal enum class ButtonShape(val towards: Float?, val isUpright: Boolean = false) {
    PLATE(null),
    ROUND(null),
    TO_THE_LEFT(-1f),
    TO_THE_RIGHT(1f),
    UPWARDS(-1f, isUpright = true),
    DOWNWARDS(1f, isUpright = true),
}

/**
 * What the buttons of a brick have in common.
 *
 * @property corner the radius of their corners in units.
 * @property side how dark their sides are.
 * @property pressed how dark they are while pressed.
 * @property isSquashed whether the upper side is the whole shape made lower, not a shape of its own.
 */
internal class ButtonFinish(val corner: Float, val side: Float, val pressed: Float, val isSquashed: Boolean)

/**
 * What the ports of one side of a brick look like.
 *
 * @property ink of what is written on it.
 */
internal class PortLook(
    val form: PortForm,
    val colour: Color,
    val lit: Color,
    val ink: Color,
    val litInk: Color,
    val emptyInk: Color = ink,
)

internal sealed interface PortForm {
    /** A plate with four studs. */
    class Studs(val edge: Color) : PortForm

    /** A plug with an end of its cable on the outer [side] of the brick; a hole without. */
    class Plug(val side: FrontSide, val edge: Color, val latch: Color, val holeEdge: Color, val hole: Color) : PortForm
}

/** A side of a front. */
internal enum class FrontSide(val x: Float, val y: Float) {
    ABOVE(0f, -1f),
    BELOW(0f, 1f),
    LEFT(-1f, 0f),
    RIGHT(1f, 0f),
}
