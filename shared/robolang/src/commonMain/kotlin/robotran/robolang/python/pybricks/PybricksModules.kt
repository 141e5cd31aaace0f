package robotran.robolang.python.pybricks

import robotran.robolang.python.writer.PythonUses

/** `Port.A`, `Color.RED` and so on: [name] of a class of the parameters. */
internal fun PythonUses.parameter(name: String): String {
    import("pybricks.parameters", name.substringBefore('.'))
    return name
}

internal fun PythonUses.tool(name: String): String = import("pybricks.tools", name)
