package robotran.build

/** The imports between packages. Tests are excluded, since they may import anything. */
class PackageGraph(files: List<SourceFile>) {
    private val sources = files.filterNot { it.isTest }
    private val packages = sources.map { it.packageName }.toSet()

    /** For each package, the packages it imports, each with one importing file. */
    private val uses: Map<String, Map<String, String>> =
        sources.groupBy { it.packageName }.mapValues { (name, ofPackage) ->
            ofPackage
                .flatMap { file -> file.imports.map { packageOf(it) to file.path } }
                .filter { (used, _) -> used != name && used in packages }
                .toMap()
        }

    /**
     * Groups of packages that depend on each other directly or indirectly, one sentence each; empty if there are none.
     */
    fun cycles(): List<String> = groups().filter { it.size > 1 }.map { group ->
        val edges =
            group.flatMap { from ->
                uses.getValue(from).filterKeys { it in group }.map { (to, file) -> "  $from imports $to in $file" }
            }
        "packages in a cycle: ${group.joinToString()}\n${edges.joinToString("\n")}"
    }

    /** Tarjan's strongly connected components, each sorted by name. */
    private fun groups(): List<List<String>> {
        val found = mutableListOf<List<String>>()
        val number = mutableMapOf<String, Int>()
        val lowest = mutableMapOf<String, Int>()
        val open = ArrayDeque<String>()

        fun visit(name: String) {
            number[name] = number.size
            lowest[name] = number.getValue(name)
            open.addLast(name)
            for (used in uses[name].orEmpty().keys) {
                if (used !in number) visit(used)
                if (used in open) lowest[name] = minOf(lowest.getValue(name), lowest.getValue(used))
            }
            if (lowest[name] == number[name]) {
                val group = mutableListOf<String>()
                do {
                    group += open.removeLast()
                } while (group.last() != name)
                found += group.sorted()
            }
        }
        for (name in packages.sorted()) if (name !in number) visit(name)
        return found
    }

    private companion object {
        /** `a.b` for `a.b.name`, `a.b.Type`, `a.b.Type.member` and `a.b.` of a star: packages are lower case. */
        fun packageOf(import: String): String {
            val parts = import.split(".")
            val type = parts.indexOfFirst { it.firstOrNull()?.isUpperCase() == true }
            return parts.take(if (type >= 0) type else parts.size - 1).joinToString(".")
        }
    }
}
