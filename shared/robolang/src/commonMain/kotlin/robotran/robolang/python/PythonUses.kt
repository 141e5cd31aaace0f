package robotran.robolang.python

import robotran.robolang.robot.RobotTarget

/** What a translation uses of modules and of its own helpers. */
internal class PythonUses(
    private val robot: RobotTarget.Hub,
    private val isReacting: Boolean,
    private val ways: PybricksWays,
) {
    private val imports = mutableMapOf<String, Set<String>>()
    private val helpers = mutableSetOf<PythonHelper>()

    /** All names that the translation itself has. */
    val names: Set<String> get() = imports.values.flatten().toSet() + helpers.flatMap { it.names }

    /** Marks [name] of [module] as used; returns it. */
    fun import(module: String, name: String): String {
        imports[module] = imports[module].orEmpty() + name
        return name
    }

    /** `Port.A`, `Color.RED` and so on: [name] of a class of the parameters. */
    fun parameter(name: String): String {
        import("pybricks.parameters", name.substringBefore('.'))
        return name
    }

    fun tool(name: String): String = import("pybricks.tools", name)

    fun maths(name: String): String = import("umath", name)

    /** Marks [helper] and what it needs as used; returns its name. */
    fun use(helper: PythonHelper): String {
        if (!helpers.add(helper)) return helper.called
        helper.needs.forEach { use(it) }
        helper.imports.forEach { import(it.substringBefore(':'), it.substringAfter(':')) }
        return helper.called
    }

    /** What is used so far, for [takeBack]. */
    fun copy(): PythonUses = PythonUses(robot, isReacting, ways).also { it.takeBack(this) }

    /** Only what [earlier] has is used: what was written since is left out. */
    fun takeBack(earlier: PythonUses) {
        imports.clear()
        imports += earlier.imports
        helpers.clear()
        helpers += earlier.helpers
    }

    val hasHelpers: Boolean get() = helpers.isNotEmpty()

    fun writeImports(writer: PythonWriter) {
        for ((module, names) in imports.entries.sortedBy { it.key }) {
            writer.line("from $module import ${names.sorted().joinToString()}")
        }
    }

    fun writeHelpers(writer: PythonWriter) {
        for (helper in PythonHelper.entries.filter { it in helpers }) {
            writer.gap()
            writer.lines(helper.textFor(robot, isReacting, ways))
        }
    }
}
