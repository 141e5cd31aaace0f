package robotran.cli.messages

import robotran.language.listed

internal object SpanishRobotMessages : RobotMessages {
    override fun noButton(brick: String, button: String, buttons: List<String>) =
        "Un $brick no tiene un botón $button. Sus botones son ${listed(buttons, "y")}."

    override fun noCallGroup(brick: String, group: String, groups: List<String>) =
        "Un $brick no tiene llamadas de un grupo $group. Sus grupos son ${listed(groups, "y")}."

    override fun noMemory(brick: String) = "El robot tiene un $brick: solo se puede mostrar la memoria de un RCX."

    override fun standsIn(robot: String, file: String) =
        "Construido como dice $file, el robot $robot no cabe en su salida de este mundo."

    override fun robotIsFine(name: String, title: String, brick: String) =
        "$name no tiene errores. Es el robot «$title» con un $brick."
}
