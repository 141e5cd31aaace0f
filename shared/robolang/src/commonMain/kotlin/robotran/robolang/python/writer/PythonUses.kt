package robotran.robolang.python.writer

/** What a translation uses of modules and of its own helpers. */
internal class PythonUses {
    private val imports = mutableMapOf<String, Set<String>>()
    private val modules = mutableSetOf<String>()
    private val helpers = mutableSetOf<PythonHelper>()

    /** All names that the translation itself has. */
    val names: Set<String> get() = imports.values.flatten().toSet() + modules + helpers.flatMap { it.names }

    /** Marks [name] of [module] as used; returns it. */
    fun import(module: String, name: String): String {
        imports[module] = imports[module].orEmpty() + name
        return name
    }

    /** Marks [module] as used as a whole; returns its name. */
    fun module(module: String): String = module.also { modules += it }

    /** Marks [helper] and what it needs as used; returns its name. */
    fun use(helper: PythonHelper): String {
        if (!helpers.add(helper)) return helper.called
        helper.needs.forEach { use(it) }
        for (import in helper.imports) {
            val module = import.substringBefore(':')
            if (module == import) module(module) else import(module, import.substringAfter(':'))
        }
        return helper.called
    }

    operator fun contains(helper: PythonHelper): Boolean = helper in helpers

    /** What is used so far, for [takeBack]. */
    fun copy(): PythonUses = PythonUses().also { it.takeBack(this) }

    /** Only what [earlier] has is used: what was written since is left out. */
    fun takeBack(earlier: PythonUses) {
        imports.clear()
        imports += earlier.imports
        modules.clear()
        modules += earlier.modules
        helpers.clear()
        helpers += earlier.helpers
    }

    val hasHelpers: Boolean get() = helpers.isNotEmpty()

    fun writeImports(writer: PythonWriter) {
        for ((module, names) in imports.entries.sortedBy { it.key }) {
            writer.line("from $module import ${names.sorted().joinToString()}")
        }
        for (module in modules.sorted()) writer.line("import $module")
    }

    fun writeHelpers(writer: PythonWriter, textOf: (PythonHelper) -> String) {
        for (helper in helpers.sortedBy { it.ordinal }) {
            writer.gap()
            writer.lines(textOf(helper))
        }
    }
}
