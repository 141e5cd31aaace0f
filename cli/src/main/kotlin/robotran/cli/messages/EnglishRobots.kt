package robotran.cli.messages

import robotran.language.listed

internal object EnglishRobotMessages : RobotMessages {
    override fun noButton(brick: String, button: String, buttons: List<String>) =
        "An $brick has no button $button. Its buttons are ${listed(buttons, "and")}."

    override fun noCallGroup(brick: String, group: String, groups: List<String>) =
        "An $brick has no calls of a group $group. Its groups are ${listed(groups, "and")}."

    override fun noMemory(brick: String) = "The robot has an $brick: only the memory of an RCX can be shown."

    override fun standsIn(robot: String, file: String) =
        "Built as $file says, the robot $robot has no room where it starts in this world."

    override fun robotIsFine(name: String, title: String, brick: String) =
        "$name has no mistakes. It is the robot \"$title\" with an $brick."
}
