package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.template.fillIn
import robotran.robolang.template.templates

/**
 * The files of a kit around the program (`src/brick/kit`): instructions, an Ant build file and scripts. The scripts
 * compile [sources] with the tools of leJOS, then link [mainClass] and send it to the brick. leJOS 2.1 has `lejosc` and
 * `lejosjc`, leJOS 3.0 only `lejosjc`; both have `lejos` (folder `bin` of leJOS's repository at its releases).
 *
 * @param className the program's name, on an NXT also on the brick.
 * @param mainClass the main class with its package, if any.
 * @param sources the names of its files; of the special characters of a shell, only a dollar sign may be in them.
 * @param robolangName the Robolang program that it is a translation of; null if it was written in Java.
 */
internal class KitTools(
    private val className: String,
    private val mainClass: String,
    private val sources: List<String>,
    private val robolangName: String?,
) {
    private val values: Map<String, String> = mapOf(
        "CLASS" to className,
        "MAIN_CLASS" to mainClass,
        "SOURCES" to sources.joinToString(" "),
        "SOURCE_ARGUMENTS" to sources.joinToString("\n") { "            <arg value=\"$it\"/>" },
        "QUOTED_MAIN_CLASS" to quoted(mainClass),
        "QUOTED_SOURCES" to sources.joinToString(" ", transform = ::quoted),
        // Into the folders of their packages, if any.
        "OPTIONS" to if ('.' in mainClass) "-encoding UTF-8 -d ." else "-encoding UTF-8",
        "SOURCE" to robolangName.orEmpty(),
    )

    fun filesFor(brick: BrickKind): List<KitFile> = NAMES.mapNotNull { name ->
        templates["kit/${brick.name.lowercase()}/$name"]?.let { template ->
            KitFile("$className/$name", textOf(template), isExecutable = name.endsWith(".sh"))
        }
    }

    private fun textOf(template: String): String {
        val language = if (robolangName == null) "JAVA" else "ROBOLANG"
        return CONDITION.replace(template) {
            if (it.groupValues[1] ==
                language
            ) {
                it.groupValues[2]
            } else {
                ""
            }
        }.fillIn(values)
    }

    /** Quoted for a shell: names of nested classes contain a dollar sign. */
    private fun quoted(name: String) = if ('$' in name) "'$name'" else name

    private companion object {
        /** The files of all bricks in their order; a brick has those that are in its folder. */
        val NAMES = "README.txt LIESMICH.txt LEEME.txt build.xml download.sh download.bat upload.sh upload.bat".split(
            ' ',
        )

        /** Lines that are only for programs written in one language. */
        val CONDITION = Regex("@IF_([A-Z]+)@\n([\\s\\S]*?)@END@\n")
    }
}
