package robotran.cli.messages

import robotran.language.listed

internal object GermanRobotMessages : RobotMessages {
    override fun noButton(brick: String, button: String, buttons: List<String>) =
        "Ein $brick hat keine Taste $button. Seine Tasten sind ${listed(buttons, "und")}."

    override fun noCallGroup(brick: String, group: String, groups: List<String>) =
        "Ein $brick hat keine Aufrufe einer Gruppe $group. Seine Gruppen sind ${listed(groups, "und")}."

    override fun noMemory(brick: String) = "Der Roboter hat einen $brick: Nur der Speicher eines RCX lässt sich zeigen."

    override fun standsIn(robot: String, file: String) =
        "Gebaut, wie $file sagt, hat der Roboter $robot an seinem Start in dieser Welt keinen Platz."

    override fun robotIsFine(name: String, title: String, brick: String) =
        "$name hat keine Fehler. Das ist der Roboter „$title“ mit einem $brick."
}
