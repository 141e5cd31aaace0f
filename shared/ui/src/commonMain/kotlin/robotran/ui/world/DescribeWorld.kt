package robotran.ui.world

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.ui.resources.*
import robotran.ui.runbar.oneDecimal
import robotran.ui.sheet.GoalRegion
import robotran.ui.sheet.goalRegions
import robotran.world.RegionRole
import robotran.world.World
import robotran.world.geometry.centre

/** The places of the robots, their drawings and their goals, in words. */
@Composable
internal fun describeWorld(world: World, session: SessionState): String {
    val robots = world.robots.zip(session.robots).map { (place, robot) ->
        if (session.robots.size == 1) {
            robotWords(robot)
        } else {
            stringResource(Res.string.sheet_robot_of_several, place.name, robotWords(robot))
        }
    }
    val ink =
        stringResource(
            Res.string.ink_length,
            stringResource(Res.string.centimetres, oneDecimal(session.ink.lengthCentimetres)),
        )
    val regions = goalRegions(world.goals).map { regionWords(it, session) }
    return (robots + ink + regions).joinToString(". ")
}

@Composable
private fun robotWords(snapshot: RobotSnapshot): String {
    val pose = snapshot.robot.pose
    val place = stringResource(
        Res.string.robot_pose,
        stringResource(Res.string.centimetres, oneDecimal(pose.x)),
        stringResource(Res.string.centimetres, oneDecimal(pose.y)),
        stringResource(Res.string.degrees, oneDecimal(pose.heading)),
    )
    return "$place, " +
        "${stringResource(if (snapshot.robot.penDown) Res.string.robot_pen_down else Res.string.robot_pen_up)}"
}

@Composable
private fun regionWords(region: GoalRegion, session: SessionState): String {
    val place = placeWords(region.shape.centre)
    val number = region.number
    val words = when (region.role) {
        RegionRole.TARGET -> {
            if (number == null) {
                stringResource(Res.string.sheet_region_reach, place)
            } else {
                stringResource(Res.string.sheet_region_reach_numbered, number, place)
            }
        }

        RegionRole.FORBIDDEN -> stringResource(Res.string.sheet_region_stay_out, place)
        RegionRole.PERMITTED -> stringResource(Res.string.sheet_region_stay_in, place)
    }
    return if (region.isMet(session.goals)) stringResource(Res.string.sheet_region_met, words) else words
}
