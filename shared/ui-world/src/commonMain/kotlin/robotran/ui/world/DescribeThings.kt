package robotran.ui.world

import androidx.compose.runtime.Composable
import robotran.simulation.state.SessionState
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/** A movable element in words: its kind, place and direction. */
@Composable
internal fun describeElement(thing: SheetElement, pose: Pose, world: World, session: SessionState): String =
    when (thing.kind) {
        SheetElementKind.ROBOT -> {
            SheetTexts.robot(spoken, world.robots[thing.number].name, poseWords(pose))
        }

        SheetElementKind.BLOCK -> {
            val name = world.blocks[thing.number].name
            if (name != null) {
                SheetTexts.block(spoken, name, poseWords(pose))
            } else {
                SheetTexts.blockNumbered(spoken, thing.number + 1, poseWords(pose))
            }
        }

        else -> {
            val isOn = session.lamps[thing.number].on
            val state = if (isOn) SheetTexts.lampOn(spoken) else SheetTexts.lampOff(spoken)
            val isInfrared = world.lamps[thing.number].infrared
            val on = if (isInfrared) SheetTexts.lampInfrared(spoken, state) else state
            val place = placeWords(Point(pose.x, pose.y))
            val name = world.lamps[thing.number].name
            if (name != null) {
                SheetTexts.lamp(spoken, name, place, on)
            } else {
                SheetTexts.lampNumbered(spoken, thing.number + 1, place, on)
            }
        }
    }

/** A place such as `20.0 cm across and 30.0 cm up`. */
@Composable
internal fun placeWords(point: Point): String = SheetTexts.place(
    spoken,
    SheetTexts.centimetres(spoken, oneDecimal(point.x)),
    SheetTexts.centimetres(spoken, oneDecimal(point.y)),
)

@Composable
private fun poseWords(pose: Pose): String =
    SheetTexts.pose(spoken, placeWords(Point(pose.x, pose.y)), SheetTexts.degrees(spoken, oneDecimal(pose.heading)))
