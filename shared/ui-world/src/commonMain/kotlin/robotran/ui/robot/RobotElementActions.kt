package robotran.ui.robot

import robotran.editing.WorldEditorTexts
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotSnapping
import robotran.ui.editing.EditorAction
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.Chassis
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.robot.things

/** What can be done with an element. */
internal fun actionsOf(robot: RobotDescription, element: RobotElement): List<EditorAction<RobotEdit>> = buildList {
    fun add(icon: Icon, label: Label, tag: String, edit: RobotEdit) = add(EditorAction(icon, label, tag, edit))
    val part = (element as? RobotElement.Part)?.let { robot.things.getOrNull(it.number) }
    val turns = part is BumperPart || (part as? SensorPart)?.facing is Facing.Ahead
    val stays = element == RobotElement.Wheels || element == RobotElement.Brick || element == RobotElement.Mass ||
        element == RobotElement.Chassis
    val turn = RobotSnapping.DEGREES
    if (!stays) add(EditIcons.DELETE, WorldEditorTexts::delete, WorldTags.ROBOT_REMOVE, RobotEdit.Remove)
    if (turns) {
        add(EditIcons.TURN_LEFT, WorldEditorTexts::turnLeft, WorldTags.ROBOT_TURN_LEFT, RobotEdit.TurnBy(turn))
        add(EditIcons.TURN_RIGHT, WorldEditorTexts::turnRight, WorldTags.ROBOT_TURN_RIGHT, RobotEdit.TurnBy(-turn))
    }
    if (element is RobotElement.Corner) {
        add(EditIcons.LARGER, WorldEditorTexts::addCorner, WorldTags.ROBOT_ADD_CORNER, RobotEdit.AddCorner)
    }
}
