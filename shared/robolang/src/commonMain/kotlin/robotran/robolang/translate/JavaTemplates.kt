package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.template.sectionsOf
import robotran.robolang.template.templates

/**
 * The Java that translations do not make themselves (`src/brick/java`): helpers, figures and classes. A brick has a
 * folder with what is different on it; a section such as `STOP_AT, reacting` is for programs with behaviours.
 */
internal object JavaTemplates {
    private val byBrick: Map<BrickKind, Map<String, String>> = BrickKind.entries.associateWith { brick ->
        sectionsIn(FOLDER) + sectionsIn("$FOLDER${brick.name.lowercase()}/")
    }

    /**
     * The Java called [name] for [brick], in a program with behaviours if [isReacting]. In those whoever waits has to
     * give way; what has no section of its own for them differs in nothing else.
     */
    fun of(name: String, brick: BrickKind, isReacting: Boolean): String {
        val sections = byBrick.getValue(brick)
        return if (isReacting) {
            sections["$name, reacting"] ?: sections.getValue(name).replace("Thread.sleep(", "pause(")
        } else {
            sections.getValue(name)
        }
    }

    private fun sectionsIn(folder: String): Map<String, String> =
        templates.filterKeys { it.startsWith(folder) && '/' !in it.removePrefix(folder) }.values
            .fold(emptyMap()) { sections, text -> sections + sectionsOf(text) }

    private const val FOLDER = "java/"
}
