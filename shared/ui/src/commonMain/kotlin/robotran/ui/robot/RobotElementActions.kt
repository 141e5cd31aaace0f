package robotran.ui.robot

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotSnapping
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.Chassis
import robotran.world.Facing
import robotran.world.SensorPart
import robotran.world.robot.things

/** What can be done with the chosen element. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun RobotElementActions(scope: RobotScope, element: RobotElement) {
    val part = (element as? RobotElement.Part)?.let { scope.robot.things.getOrNull(it.number) }
    val turns = part is BumperPart || (part as? SensorPart)?.facing is Facing.Ahead
    val stays = element == RobotElement.Wheels || element == RobotElement.Brick || element == RobotElement.Mass ||
        element == RobotElement.Chassis
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        if (!stays) {
            IconWord(EditIcons.DELETE, WorldEditorTexts.delete(spoken), "robot-remove", {
                scope.make(RobotEdit.Remove)
            })
        }
        if (turns) {
            IconWord(EditIcons.TURN_LEFT, WorldEditorTexts.turnLeft(spoken), "robot-turn-left", {
                scope.make(RobotEdit.TurnBy(RobotSnapping.DEGREES))
            })
            IconWord(EditIcons.TURN_RIGHT, WorldEditorTexts.turnRight(spoken), "robot-turn-right", {
                scope.make(RobotEdit.TurnBy(-RobotSnapping.DEGREES))
            })
        }
        if (element is RobotElement.Corner) {
            IconWord(EditIcons.LARGER, WorldEditorTexts.addCorner(spoken), "robot-add-corner", {
                scope.make(RobotEdit.AddCorner)
            })
        }
    }
}
