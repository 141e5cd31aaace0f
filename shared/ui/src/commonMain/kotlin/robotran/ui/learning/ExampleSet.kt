package robotran.ui.learning

import org.jetbrains.compose.resources.StringResource
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.ui.resources.*
import robotran.workshop.examples.examplesFor

/**
 * The example programs in one language.
 *
 * @property brick the brick that they are for; null for every brick.
 */
internal enum class ExampleSet(val language: ProgramLanguage, val brick: BrickKind?, val title: StringResource) {
    ROBOLANG(ProgramLanguage.ROBOLANG, null, Res.string.program_examples_robolang),
    LEJOS(ProgramLanguage.JAVA, BrickKind.RCX, Res.string.program_examples_java),
    NQC(ProgramLanguage.NQC, BrickKind.RCX, Res.string.program_examples_nqc),
    NXJ(ProgramLanguage.JAVA, BrickKind.NXT, Res.string.program_examples_nxj),
    ;

    val programs: Map<String, String> get() = language.examplesFor(brick ?: BrickKind.RCX)

    /** What tells the example [name] from those of the other sets. */
    fun idOf(name: String): String = if (this == NXJ) "$NXJ_FOLDER$name" else name

    companion object {
        private const val NXJ_FOLDER = "nxj/"

        /** The set and the name of the example [id]; null if there is none. */
        fun find(id: String): Pair<ExampleSet, String>? = entries.firstNotNullOfOrNull { set ->
            set.programs.keys.firstOrNull { set.idOf(it) == id }?.let { set to it }
        }
    }
}
