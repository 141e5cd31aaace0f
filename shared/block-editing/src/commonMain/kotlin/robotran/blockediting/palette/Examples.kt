package robotran.blockediting.palette

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.RobolangWords
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.ValueForm

/** The values that palette blocks of this form have for a robot with [brick]. */
internal fun ValueForm.examplesOn(brick: BrickKind): List<String> = when (this) {
    ValueForm.BUILT_IN -> RobolangWords.functions.map { (name, parameters) -> callOf(name, parameters) }
    ValueForm.LOGIC -> listOfNotNull(exampleOn(brick)).flatMap { listOf(it, it.replace(" and ", " or ")) }
    else -> listOfNotNull(exampleOn(brick))
}

/** A call of the built-in function [name] with an example for each parameter. */
private fun callOf(name: String, parameters: Int): String {
    val anything = List(parameters) { "1" }.joinToString()
    val value = valuesIn("$name($anything)").first().value
    val examples = value.parts.filterIsInstance<PhrasePart.Value>().map { it.use.example }
    return examples.joinToString(prefix = "$name(", postfix = ")")
}

/** The values of the line that gives [value] to a variable; the first one is [value] itself. */
internal fun valuesIn(value: String): List<PhrasePart.Value> = outlineRobolang(
    "var x = $value",
    messages = RobolangMessages.of(Language.ENGLISH),
).lines.first().parts.filterIsInstance<PhrasePart.Value>()
