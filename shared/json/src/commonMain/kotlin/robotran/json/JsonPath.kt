package robotran.json

/** One step from a value in a JSON file to one that is in it. */
sealed interface JsonStep {
    data class Member(val name: String) : JsonStep

    /** @property number from 0. */
    data class Item(val number: Int) : JsonStep
}

/** Where in a JSON file a value is; written such as `walls[2].from`, and empty for the whole file. */
class JsonPath private constructor(private val outer: JsonPath?, private val last: JsonStep?) {
    /** From the whole file inwards. */
    val steps: List<JsonStep> get() = generateSequence(this) { it.outer }.mapNotNull { it.last }.toList().asReversed()

    /** This path and one step further. */
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
