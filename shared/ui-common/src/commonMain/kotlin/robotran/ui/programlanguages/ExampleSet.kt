package robotran.ui.programlanguages

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.ProgramLanguage
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.NqcTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*
import robotran.workshop.examples.examplesFor

/**
 * The example programs in one language.
 *
 * @property brick the brick that they are for; null for every brick.
 * @property ending of the names of texts about them, where those about Robolang do not fit.
 * @property folder what tells them from others of the same name.
 */
enum class ExampleSet(
    val language: ProgramLanguage,
    val brick: BrickKind?,
    val title: Label,
    val ending: String = "",
    private val folder: String = "",
) {
    ROBOLANG(ProgramLanguage.ROBOLANG, null, CommonTexts::programExamplesRobolang),
    LEJOS(ProgramLanguage.JAVA, BrickKind.with(JavaPlatform.LEJOS), CommonTexts::programExamplesJava, "_java"),
    NQC(ProgramLanguage.NQC, BrickKind.ofLegoFirmware, NqcTexts::programExamplesNqc, "_nqc"),
    NXJ(ProgramLanguage.JAVA, BrickKind.with(JavaPlatform.NXJ), NxtTexts::programExamplesNxj, "_nxj", "nxj/"),
    ;

    val programs: Map<String, String> get() = language.examplesFor(brick ?: BrickKind.default)

    /** What tells the example [name] from those of the other sets. */
    fun idOf(name: String): String = folder + name

    companion object {
        /** The set and the name of the example [id]; null if there is none. */
        fun find(id: String): Pair<ExampleSet, String>? = entries.firstNotNullOfOrNull { set ->
            set.programs.keys.firstOrNull { set.idOf(it) == id }?.let { set to it }
        }
    }
}
