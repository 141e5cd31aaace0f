package robotran.ui.world

import androidx.compose.runtime.Composable
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.ui.sheet.GoalRegion
import robotran.ui.sheet.goalRegions
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
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
            SheetTexts.robotOfSeveral(spoken, place.name, robotWords(robot))
        }
    }
    val ink =
        SheetTexts.inkLength(spoken, SheetTexts.centimetres(spoken, oneDecimal(session.ink.lengthCentimetres)))
    val regions = goalRegions(world.goals).map { regionWords(it, session) }
    return (robots + ink + regions).joinToString(". ")
}

@Composable
private fun robotWords(snapshot: RobotSnapshot): String {
    val pose = snapshot.robot.pose
    val place = SheetTexts.robotPose(
        spoken,
        SheetTexts.centimetres(spoken, oneDecimal(pose.x)),
        SheetTexts.centimetres(spoken, oneDecimal(pose.y)),
        SheetTexts.degrees(spoken, oneDecimal(pose.heading)),
    )
    return "$place, " +
        "${if (snapshot.robot.penDown) SheetTexts.robotPenDown(spoken) else SheetTexts.robotPenUp(spoken)}"
}

@Composable
private fun regionWords(region: GoalRegion, session: SessionState): String {
    val place = placeWords(region.shape.centre)
    val number = region.number
    val words = when (region.role) {
        RegionRole.TARGET -> {
            if (number == null) {
                SheetTexts.regionReach(spoken, place)
            } else {
                SheetTexts.regionReachNumbered(spoken, number, place)
            }
        }

        RegionRole.FORBIDDEN -> SheetTexts.regionStayOut(spoken, place)
        RegionRole.PERMITTED -> SheetTexts.regionStayIn(spoken, place)
    }
    return if (region.isMet(session.goals)) SheetTexts.regionMet(spoken, words) else words
}
