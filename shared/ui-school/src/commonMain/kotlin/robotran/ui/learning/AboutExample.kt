package robotran.ui.learning

import robotran.language.Language
import robotran.ui.programlanguages.ExampleSet
import robotran.ui.school.texts.ExampleTexts

/**
 * A one-sentence description of the example [name]. For `wall-bouncer.robo` and `WallBouncer.java` it is that of
 * `wall_bouncer`, unless the Java version has its own, whose name ends in `_java`, or in `_nxj` for an NXT, or the one in
 * NQC has one that ends in `_nqc`.
 */
internal fun aboutExample(set: ExampleSet, name: String, language: Language): String {
    val stem = name.removeSuffix(set.language.extension)
    val example = stem.replace('-', '_').replace(CAPITAL_INSIDE) { "_${it.value}" }.lowercase()
    val own = if (set.ending.isEmpty()) "" else ExampleTexts.about(language, example + set.ending)
    return own.ifEmpty { ExampleTexts.about(language, example) }
}

private val CAPITAL_INSIDE = Regex("\\B[A-Z]")
