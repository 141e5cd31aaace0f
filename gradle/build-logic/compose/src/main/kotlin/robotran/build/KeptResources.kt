package robotran.build

import org.gradle.api.Action
import org.gradle.api.Task

/**
 * Rewrites what Compose's plugin has generated for strings and pictures: instead of a delegate for each of them, which
 * all are made with the first one, a property keeps what it has made when it was first read. A page starts quicker, and
 * is smaller.
 */
internal class KeptResources : Action<Task> {
    override fun execute(task: Task) {
        task.outputs.files.asFileTree.filter { it.extension == "kt" }.forEach { it.writeText(kept(it.readText())) }
    }

    companion object {
        private val DELEGATE = Regex("""public val (\w+): (\w+) by\s+lazy \{ (\w+)\(\) }""")

        fun kept(source: String): String = DELEGATE.replace(source) { found ->
            val (name, type, make) = found.destructured
            "private var ${name}Kept: $type? = null\n" +
                "  public val $name: $type get() = ${name}Kept ?: $make().also { ${name}Kept = it }"
        }
    }
}
