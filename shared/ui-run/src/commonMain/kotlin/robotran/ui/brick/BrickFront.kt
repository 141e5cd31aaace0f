package robotran.ui.brick

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.brick.kind.ByBrick
import robotran.brick.state.BrickState
import robotran.hub.model.HubModel
import robotran.microbit.model.MicrobitModel
import robotran.ui.brick.front.BrickFace
import robotran.ui.brick.front.FrontButton
import robotran.ui.brick.front.FrontPart
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontPort
import robotran.ui.brick.front.Signal
import robotran.ui.brick.front.drawFront
import robotran.ui.brick.front.inUnits
import robotran.ui.brick.hub.HubFace
import robotran.ui.brick.microbit.MicrobitFace
import robotran.ui.brick.nxt.NxtFace
import robotran.ui.brick.rcx.RcxFace
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.world.ReadyRobots
import robotran.world.RobotDescription

/** What is its own on the front of each kind of brick. */
internal val BrickKind.face: BrickFace get() = FACES[this]

private val FACES = ByBrick { kind ->
    when (kind) {
        BrickKind.RCX -> RcxFace
        BrickKind.NXT -> NxtFace

        BrickKind.SPIKE_PRIME, BrickKind.SPIKE_ESSENTIAL, BrickKind.TECHNIC_HUB, BrickKind.EV3, BrickKind.NXT_PYBRICKS,
        -> HubFace(checkNotNull(HubModel.of(kind)))

        BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> MicrobitFace(checkNotNull(MicrobitModel.of(kind)))
    }
}

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
    val face = state.kind.face
    val description = RunTexts.brick(spoken)
    BoxWithConstraints(
        modifier
            .aspectRatio(BRICK_ASPECT)
            .testTag(RunTags.BRICK)
            .semantics {
                contentDescription = description
                isTraversalGroup = true
            },
    ) {
        val unit = maxWidth / FrontPlan.WIDTH
        Canvas(Modifier.matchParentSize()) {
            drawFront(face.plan, signalsOf(state))
            inUnits { with(face) { drawLamps(state) } }
        }
        for (part in face.plan.parts) {
            val place = Modifier.at(part.place, unit)
            when (part) {
                is FrontPart.Display -> face.Display(state, unit, place)

                is FrontPart.Button -> {
                    val button = part.button
                    FrontButton(part, face.plan.finish, unit, button in down, {
                        onPress(button)
                    }, { onRelease(button) }, place)
                }

                is FrontPart.Input -> {
                    val view = face.input(state, part.index, robot)
                    FrontPort(part.look, view, unit, { onTouch(part.index, it) }, place)
                }

                is FrontPart.Output -> FrontPort(part.look, face.output(state, part.index, robot), unit, { }, place)
            }
        }
    }
}

private fun signalsOf(state: BrickState): Set<Signal> = setOfNotNull(
    Signal.SENDING.takeIf { state.isSending },
    Signal.SOUNDING.takeIf { state.sounding },
)

private fun Modifier.at(bounds: Rect, unit: Dp): Modifier =
    offset(unit * bounds.left, unit * bounds.top).size(unit * bounds.width, unit * bounds.height)

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
    val face = state.kind.face
    val look = face.plan.strip
    val edge = look.edge?.let { Modifier.border(1.dp, it, Shapes.LARGE) } ?: Modifier
    Row(
        modifier.background(look.colour, Shapes.LARGE).then(edge).padding(if (isLow) 4.dp else 8.dp),
        horizontalArrangement = Arrangement.spacedBy(if (isLow) look.lowGap else look.gap),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        face.StripDisplay(state, isLow)
        val button = state.kind.startButton
        FrontButton(
            face.plan.button(button),
            face.plan.finish,
            1.dp,
            button in down,
            { onPress(button) },
            { onRelease(button) },
            Modifier.size(if (isLow) look.lowButtonSize else look.buttonSize),
        )
    }
}

/** The ratio of a brick's width to its height, the same for all kinds. */
const val BRICK_ASPECT = FrontPlan.WIDTH / FrontPlan.HEIGHT

/** The min width at which every button is large enough for a finger. */
val MIN_BRICK_WIDTH = Dp(FrontPlan.WIDTH * FrontPlan.MIN_UNIT)
