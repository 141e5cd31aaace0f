package robotran.json

/** One step from a value in a JSON file to one of its members or items. */
sealed interface JsonStep {
    data class Member(val name: String) : JsonStep

    /** @property number from 0. */
    data class Item(val number: Int) : JsonStep
}

/** The path of a value in a JSON file, written as in `walls[2].from`; empty for the whole file. */
class JsonPath private constructor(private val outer: JsonPath?, private val last: JsonStep?) {
    /** From the root inwards. */
    val steps: List<JsonStep> get() = generateSequence(this) { it.outer }.mapNotNull { it.last }.toList().asReversed()

    /** This path extended by [step]. */
    operator fun plus(step: JsonStep) = JsonPath(this, step)

    override fun toString(): String = buildString {
        for (step in steps) {
            when (step) {
                is JsonStep.Member -> append(if (isEmpty()) "" else ".").append(step.name)
                is JsonStep.Item -> append('[').append(step.number).append(']')
            }
        }
    }

    companion object {
        val WHOLE_FILE = JsonPath(null, null)

        fun of(steps: List<JsonStep>): JsonPath = steps.fold(WHOLE_FILE, JsonPath::plus)
    }
}
