package robotran.blockediting.palette

import robotran.brick.kind.BrickKind
import robotran.robolang.RobolangWords
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ValueForm
import robotran.robolang.outline.outlineRobolang

/** The values that palette blocks of this form have; those with names of the pupil's come from the program. */
internal val ValueForm.templates: List<String>
    get() = when (this) {
        ValueForm.NUMBER -> listOf("5")
        ValueForm.TRUTH -> listOf("true")
        ValueForm.LIST -> listOf("[1, 2, 3]")
        ValueForm.NEGATION -> listOf("-light")
        ValueForm.NOT -> listOf("not left bumper")
        ValueForm.LOGIC -> listOf("left bumper and right bumper")
        ValueForm.COMPARISON -> listOf(LIGHT_COMPARISON)
        ValueForm.ARITHMETIC -> listOf("5 + 5")
        ValueForm.BUILT_IN -> RobolangWords.functions.map { (name, parameters) -> callOf(name, parameters) }
        ValueForm.BUMPER -> listOf("left bumper")
        ValueForm.LIGHT -> listOf("light")
        ValueForm.SENSOR -> listOf("sensor 1")
        ValueForm.BUTTON -> listOf("button run")
        ValueForm.TIMER -> listOf("timer")
        ValueForm.BATTERY -> listOf("battery")
        ValueForm.DISTANCE -> listOf("distance")
        ValueForm.LOUDNESS -> listOf("loudness")
        ValueForm.COLOUR -> listOf("colour")
        ValueForm.COLOUR_NAME -> listOf("red")
        ValueForm.TURNED -> listOf("turned A")
        ValueForm.BRACKETS -> listOf("(5)")
        ValueForm.NAME, ValueForm.ELEMENT, ValueForm.CALL -> emptyList()
    }

/** The same for a robot with [brick]. */
internal fun ValueForm.templatesOn(brick: BrickKind): List<String> = when {
    this.brick != null && this.brick != brick -> emptyList()
    this == ValueForm.COMPARISON && brick == BrickKind.NXT -> listOf(DISTANCE_COMPARISON)
    this == ValueForm.BUTTON && brick == BrickKind.NXT -> listOf("button enter")
    else -> templates
}

/** A call of the built-in function [name] with an example for each parameter. */
private fun callOf(name: String, parameters: Int): String {
    val anything = List(parameters) { "1" }.joinToString()
    val value = valuesIn("$name($anything)").first().value
    val examples = value.parts.filterIsInstance<PhrasePart.Value>().map { it.use.example }
    return examples.joinToString(prefix = "$name(", postfix = ")")
}

/** The values of the line that gives [value] to a variable; the first one is [value] itself. */
internal fun valuesIn(value: String): List<PhrasePart.Value> =
    outlineRobolang("var x = $value").lines.first().parts.filterIsInstance<PhrasePart.Value>()
