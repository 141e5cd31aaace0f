package robotran.ui.world

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.simulation.state.SessionState
import robotran.ui.resources.*
import robotran.ui.runbar.oneDecimal
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
            stringResource(Res.string.sheet_robot, world.robots[thing.number].name, poseWords(pose))
        }

        SheetElementKind.BLOCK -> {
            val name = world.blocks[thing.number].name
            if (name != null) {
                stringResource(Res.string.sheet_block, name, poseWords(pose))
            } else {
                stringResource(Res.string.sheet_block_numbered, thing.number + 1, poseWords(pose))
            }
        }

        else -> {
            val isOn = session.lamps[thing.number].on
            val state = stringResource(if (isOn) Res.string.sheet_lamp_on else Res.string.sheet_lamp_off)
            val isInfrared = world.lamps[thing.number].infrared
            val on = if (isInfrared) stringResource(Res.string.sheet_lamp_infrared, state) else state
            val place = placeWords(Point(pose.x, pose.y))
            val name = world.lamps[thing.number].name
            if (name != null) {
                stringResource(Res.string.sheet_lamp, name, place, on)
            } else {
                stringResource(Res.string.sheet_lamp_numbered, thing.number + 1, place, on)
            }
        }
    }

/** A place such as `20.0 cm across and 30.0 cm up`. */
@Composable
internal fun placeWords(place: Point): String = stringResource(
    Res.string.sheet_place,
    stringResource(Res.string.centimetres, oneDecimal(place.x)),
    stringResource(Res.string.centimetres, oneDecimal(place.y)),
)

@Composable
private fun poseWords(pose: Pose): String = stringResource(
    Res.string.sheet_pose,
    placeWords(Point(pose.x, pose.y)),
    stringResource(Res.string.degrees, oneDecimal(pose.heading)),
)
